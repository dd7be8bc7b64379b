// SPDX-License-Identifier: GPL-3.0-or-later
// Making parts of the page.

/** An element: element("input", { type: "text", onchange: f }, "text", child ...). */
export function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes))
        if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
        else if (value === true) made.setAttribute(key, "");
        else if (value !== false && value !== undefined) made.setAttribute(key, value);
    made.append(...children);
    return made;
}

export const escaped = (text) =>
    String(text).replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);

/** Hands a file to the browser's downloads. */
export function download(name, blob) {
    const address = URL.createObjectURL(blob);
    element("a", { href: address, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
}

/** A button that copies a text, and says so for a while. */
export function copyButton(label, text, done = () => "Copied") {
    const button = element("button", { type: "button" }, label);
    button.addEventListener("click", async () => {
        const copied = await copy(text());
        button.textContent = copied ? done() : "Select the text and copy it";
        setTimeout(() => (button.textContent = label), 2000);
    });
    return button;
}

/** A page that was opened as a file may not have the clipboard of today: then the older way is taken. */
async function copy(text) {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        const area = element("textarea", { "aria-hidden": "true" });
        area.value = text;
        document.body.append(area);
        area.select();
        const copied = document.execCommand("copy");
        area.remove();
        return copied;
    }
}
