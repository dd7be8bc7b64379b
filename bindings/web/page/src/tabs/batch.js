// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Batch: rows pasted from a spreadsheet, and rows to paste back.
import { copyButton, download, element, escaped } from "../elements.js";
import { solveRows } from "../rows/batch.js";

const SHOWN = 100; // rows that are drawn; all are copied
const example =
    "case\tE1\tnu1\ttheta_deg\tradius\tP\tQ\tf\tyield_stress\nsteel on steel\t210000\t0.3\t2\t10\t300\t40\t0.3\t900\na sharper one\t210000\t0.3\t2\t2\t70\t15\t0.3\t900";

const asText = ({ names, rows }) => [names, ...rows].map((row) => row.join("\t")).join("\n") + "\n";

const quoted = (cell) => (/[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell);
const csvOf = ({ names, rows }) => [names, ...rows].map((row) => row.map(quoted).join(",")).join("\n") + "\n";

function tableOf({ names, rows, state }) {
    const head = names.map((name) => `<th scope="col">${escaped(name)}</th>`).join("");
    const body = rows
        .slice(0, SHOWN)
        .map((row, i) => `<tr class="${state[i]}">${row.map((cell) => `<td>${escaped(cell)}</td>`).join("")}</tr>`)
        .join("");
    return `<table class="numbers rows"><caption class="hidden">Solved rows</caption><thead><tr>${head}</tr></thead><tbody>${body}</tbody></table>`;
}

/** Why the first rows that have no answer have none. */
function faultsOf({ rows }) {
    const found = rows.map((row, i) => [i + 1, row.at(-1)]).filter(([, error]) => error !== "");
    const first = found.slice(0, 5).map(([i, error]) => `Row ${i}: ${error}.`);
    return first.join(" ") + (found.length > 5 ? ` And ${found.length - 5} more.` : "");
}

/** What is said above the table. */
function remarkOf(solved) {
    if (solved.complaint !== undefined) return solved.complaint;
    const { rows, errors, constants } = solved;
    const from = Object.entries(constants).map(([name, text]) => `${name} = ${text}`);
    return (
        `${rows.length} rows, ${errors} could not be solved. ${faultsOf(solved)}` +
        (from.length > 0 ? ` From the case at the left: ${from.join(", ")}.` : "") +
        (rows.length > SHOWN ? ` The first ${SHOWN} are drawn; all are copied.` : "")
    );
}

/** Where rows are pasted, with a label and an example; the parts in their order. */
function pasteArea() {
    const pasted = element("textarea", {
        id: "batch",
        rows: 8,
        spellcheck: "false",
        "aria-describedby": "batch-note",
        placeholder: example,
    });
    const title =
        "Rows pasted from a spreadsheet: the first names the columns as \u201crwedge solve --input\u201d does";
    const tryExample = () => {
        pasted.value = example;
        pasted.dispatchEvent(new Event("input"));
    };
    const line = element(
        "p",
        { class: "tools" },
        element("button", { type: "button", onclick: tryExample }, "Try an example"),
        element("span", {}, "What the rows lack is taken from the case at the left."),
    );
    return { pasted, parts: [element("label", { for: "batch" }, title), pasted, line] };
}

/** What is done with the solved rows. solved() gives them. */
function saveTools(solved) {
    const save = () => download("solved.csv", new Blob([csvOf(solved())], { type: "text/csv" }));
    return element(
        "p",
        { class: "tools" },
        copyButton("Copy the solved rows", () => asText(solved())),
        element("button", { type: "button", onclick: save }, "Save as CSV"),
    );
}

export function makeBatch(state, changed) {
    const { pasted, parts } = pasteArea();
    const note = element("p", { id: "batch-note", class: "note", "aria-live": "polite" });
    const numbers = element("div", { class: "wide", tabindex: "0", role: "region", "aria-label": "Solved rows" });
    let solved = null,
        model;
    const tools = saveTools(() => solved);
    const show = (present) => {
        model = present;
        if (document.activeElement !== pasted) pasted.value = state.batch;
        solved = solveRows(state.batch, model.texts, state.sign);
        const bad = solved.complaint !== undefined;
        note.textContent = remarkOf(solved);
        note.className = bad ? "note bad" : "note";
        tools.hidden = numbers.hidden = bad;
        numbers.innerHTML = bad ? "" : tableOf(solved);
    };
    pasted.addEventListener("input", () => {
        state.batch = pasted.value;
        show(model);
        changed();
    });
    const panel = element("div", {}, ...parts, note, tools, numbers);
    return { panel, show };
}
