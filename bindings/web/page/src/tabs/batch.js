// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Batch: rows pasted from a spreadsheet, and rows to paste back.
import { copyButton, download, element, escaped } from "../elements.js";
import { Aside } from "../aside.js";

const SHOWN = 100; // rows that are drawn; all are copied
const example =
    "case\tE1\tnu1\ttheta_deg\tradius\tP\tQ\tf\tyield_stress\nsteel on steel\t210000\t0.3\t2\t10\t300\t40\t0.3\t900\na sharper one\t210000\t0.3\t2\t2\t70\t15\t0.3\t900";

/** All digits; the decimal sign is that of the page, and as in the tool ; stands between cells where it is a comma. */
const valueText = (text, sign) => (isNumber(text) ? text.replace(".", sign) : text);
const isNumber = (text) => text !== "" && Number.isFinite(Number(text));

function linesOf({ columns, results, rows }, sign) {
    const width = results.length;
    const cells = rows.map(({ cells, values, error }) => [
        ...cells,
        ...Array.from({ length: width }, (_, i) => valueText(values[i] ?? "", sign)),
        error,
    ]);
    return [[...columns, ...results, "error"], ...cells];
}

const asText = (lines) => lines.map((line) => line.join("\t")).join("\n") + "\n";

/** A text that a spreadsheet would compute gets a ' in front. */
const harmless = (cell) => (/^[=+@-]/.test(cell) && !/^[+-]?[\d.,]/.test(cell) ? `'${cell}` : cell);
const quoted = (cell) => (/[",;\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell);

function csvOf(lines, sign) {
    const between = sign === "," ? ";" : ",";
    return lines.map((line) => line.map((cell) => quoted(harmless(cell))).join(between)).join("\n") + "\n";
}

/** Drawn beside the first column: what one looks for. The files have the tool's order. */
function tableOf({ columns, results, rows }, write) {
    const [safety, warnings] = ["safety", "warnings"].map((name) => results.indexOf(name)),
        others = results.map((_, i) => i).filter((i) => i !== safety && i !== warnings);
    const head = [columns[0], "safety", "warnings", ...columns.slice(1), ...others.map((i) => results[i])]
        .map((name) => `<th scope="col">${escaped(name)}</th>`)
        .join("");
    const shown = (text = "") => (isNumber(text) ? write(Number(text)) : text);
    const body = rows.slice(0, SHOWN).map(({ colour, error, cells, values }) => {
        const remark = `<td class="remark">${escaped(error || (values[warnings] ?? ""))}</td>`,
            rest = [...cells.slice(1), ...others.map((i) => shown(values[i]))];
        const [first, factor, ...more] = [cells[0], shown(values[safety]), ...rest].map(
            (cell) => `<td>${escaped(cell)}</td>`,
        );
        return `<tr class="${colour}">${first}${factor}${remark}${more.join("")}</tr>`;
    });
    return `<table class="numbers rows"><caption class="hidden">Solved rows</caption><thead><tr>${head}</tr></thead><tbody>${body.join("")}</tbody></table>`;
}

/** Why the first rows that have no answer have none. */
function faultsOf({ rows }) {
    const faults = rows.map(({ error }, i) => [i + 1, error]).filter(([, error]) => error !== "");
    const first = faults.slice(0, 5).map(([i, error]) => `Row ${i}: ${error}.`);
    return first.join(" ") + (faults.length > 5 ? ` And ${faults.length - 5} more.` : "");
}

/** What is said above the table. */
function remarkOf(solved) {
    if (solved.complaint !== undefined) return solved.complaint;
    const { rows, constants, unused } = solved;
    const errors = rows.filter(({ error }) => error !== "").length;
    const from = constants.map(([name, text]) => `${name} = ${text}`).join(", ");
    return [
        `${rows.length} rows, ${errors} could not be solved. ${faultsOf(solved)}`,
        unused && `${unused[0].toUpperCase()}${unused.slice(1)}.`,
        from && `From the case of the form: ${from}.`,
        rows.length > SHOWN && `The first ${SHOWN} are drawn; all are copied.`,
    ]
        .filter(Boolean)
        .join(" ");
}

/** Where rows are pasted, with a label and an example; the parts in their order. */
function pasteArea() {
    const pasted = element("textarea", {
        id: "batch",
        rows: 8,
        wrap: "off",
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
        element("span", {}, "What the rows lack is taken from the case of the form."),
    );
    return { pasted, parts: [element("label", { for: "batch" }, title), pasted, line] };
}

/** What is done with the solved rows: lines() are all of them. */
function saveTools(lines, sign) {
    const save = () => download("solved.csv", new Blob([csvOf(lines(), sign())], { type: "text/csv" }));
    return element(
        "p",
        { class: "tools" },
        copyButton("Copy the solved rows", () => asText(lines())),
        element("button", { type: "button", onclick: save }, "Save as CSV"),
    );
}

export function makeBatch(state, changed) {
    const { pasted, parts } = pasteArea();
    const note = element("p", { id: "batch-note", class: "note", "aria-live": "polite" });
    const numbers = element("div", { class: "wide", tabindex: "0", role: "region", "aria-label": "Solved rows" });
    const aside = new Aside("rows");
    let solved = null,
        model;
    const tools = saveTools(
        () => linesOf(solved, state.sign),
        () => state.sign,
    );
    const panel = element("div", {}, ...parts, note, tools, numbers);
    const draw = (answer) => {
        solved = answer;
        panel.removeAttribute("aria-busy");
        const bad = solved.complaint !== undefined;
        note.textContent = remarkOf(solved);
        note.className = bad ? "note bad" : "note";
        tools.hidden = numbers.hidden = bad;
        numbers.innerHTML = bad ? "" : tableOf(solved, model.write);
    };
    const show = (present) => {
        model = present;
        if (document.activeElement !== pasted) pasted.value = state.batch;
        panel.setAttribute("aria-busy", "true");
        aside.ask([state.batch, model.texts, state.sign], draw);
    };
    pasted.addEventListener("input", () => {
        state.batch = pasted.value;
        show(model);
        changed();
    });
    return { panel, show };
}
