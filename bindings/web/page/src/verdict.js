// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict, above all tabs: strength in a sentence, a bar for its factor, the figures that are asked for first, what is doubtful.
import { element, escaped } from "./elements.js";
import { symbols } from "./tabs/symbols.js";

const MOST = 3; // where the bar ends

const figures = [
    ["b", "half-width of the contact", "length"],
    ["p0", "peak pressure", "stress"],
    ["c_over_b", "of the contact sticks", "none"],
];

function figureText(model, [name, meaning, unit]) {
    const value = model.write(model.results[name]);
    return value === ""
        ? ""
        : `<span><b>${escaped(symbols[name])} = ${escaped(value)}</b> ${escaped(model.unit[unit])} <small>${meaning}</small></span>`;
}

/** From 0 on, with a line at 1 and a word for it. */
export function barText(factor, colour, limit = "yields") {
    const share = (100 * Math.min(factor, MOST)) / MOST;
    return (
        `<svg class="factor ${colour}" viewBox="0 0 100 10" preserveAspectRatio="none" role="img" aria-label="Factor ${factor.toPrecision(3)}; 1: ${limit}">` +
        `<rect width="100" height="10"/><rect class="reached" width="${share.toFixed(1)}" height="10"/>` +
        `<rect class="limit" x="${(100 / MOST).toFixed(1)}" width="0.4" height="10"/></svg>` +
        `<p class="scale"><span>0</span><span>1: ${limit}</span><span>2</span><span>${MOST} and more</span></p>`
    );
}

const advice =
    "The factor on the stress is for the loads as they are. Where Q may grow, take that of the sliding contact, a factor on P.";

function wholeText(model) {
    const { strength, factor, colour } = model.verdict;
    return (
        `<p class="sentence">${escaped(strength)}</p>` +
        (Number.isFinite(factor) ? barText(factor, colour) : "") +
        `<p class="figures">${figures.map((figure) => figureText(model, figure)).join(" ")}</p>` +
        (Number.isFinite(model.results.safety) ? `<p class="note">${advice}</p>` : "")
    );
}

/** The box, and show(model, tab). The tabs of many loads or cases judge these themselves. */
export function makeVerdict() {
    const status = element("p", { class: "status", id: "status" }),
        head = element("div", { class: "verdict" });
    const show = (model, tab) => {
        const { colour, text } = model.verdict,
            ofCase = !["cycle", "batch"].includes(tab),
            said = ofCase ? text : `The case of the form: ${text}`;
        head.hidden = !ofCase || !model.results;
        if (!head.hidden) head.innerHTML = wholeText(model);
        status.className = `status ${colour}`;
        status.hidden = text === "OK" && !head.hidden;
        if (status.textContent !== said) status.textContent = said;
    };
    return { box: element("div", { role: "status" }, head, status), show };
}
