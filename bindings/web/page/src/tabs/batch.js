// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Batch: rows pasted from a spreadsheet, and rows to paste back.
import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { Aside } from "../answers/aside.js";
import { copyButton, csvText, download } from "../parts.js";
import { redraw, set, setter, state } from "../state.js";
import { waiting } from "./waiting.js";

const SHOWN = 100; // rows that are drawn; all are copied
const example =
    "case\tE1\tnu1\ttheta_deg\tradius\tP\tQ\tf\tyield_stress\nsteel on steel\t210000\t0.3\t2\t10\t300\t40\t0.3\t900\na sharper one\t210000\t0.3\t2\t2\t70\t15\t0.3\t900";

/** All digits; the decimal sign is that of the page, and as in the tool ; stands between cells where it is a comma. */
const valueText = (text) => (isNumber(text) ? text.replace(".", state.sign) : text);
const isNumber = (text) => text !== "" && Number.isFinite(Number(text));

function linesOf({ columns, results, rows }) {
    const cells = rows.map(({ cells, values, error }) => [
        ...cells,
        ...results.map((_, i) => valueText(values[i] ?? "")),
        error,
    ]);
    return [[...columns, ...results, "error"], ...cells];
}

const asText = (lines) => lines.map((line) => line.join("\t")).join("\n") + "\n";

/** A text that a spreadsheet would compute gets a ' in front. */
const harmless = (cell) => (/^[=+@-]/.test(cell) && !/^[+-]?[\d.,]/.test(cell) ? `'${cell}` : cell);
const quoted = (cell) => (/[",;\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell);
const fileText = (lines) => csvText(lines.map((line) => line.map((cell) => quoted(harmless(cell)))));

/** Drawn beside the first column: what one looks for. The files have the tool's order. */
function tableOf({ columns, results, rows }, write) {
    const [safety, warnings] = ["safety", "warnings"].map((name) => results.indexOf(name)),
        others = results.map((_, i) => i).filter((i) => i !== safety && i !== warnings);
    const head = [columns[0], "safety", "warnings", ...columns.slice(1), ...others.map((i) => results[i])];
    const shown = (text = "") => (isNumber(text) ? write(Number(text)) : text);
    const line = ({ colour, error, cells, values }) => {
        const rest = [...cells.slice(1), ...others.map((i) => shown(values[i]))];
        return html`<tr class=${colour}><td>${cells[0]}</td><td>${shown(values[safety])}</td>
            <td class="remark">${error || (values[warnings] ?? "")}</td>${rest.map((cell) => html`<td>${cell}</td>`)}</tr>`;
    };
    return html`<table class="numbers rows"><caption class="hidden">Solved rows</caption>
        <thead><tr>${head.map((name) => html`<th scope="col">${name}</th>`)}</tr></thead>
        <tbody>${rows.slice(0, SHOWN).map(line)}</tbody></table>`;
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
    const from = Object.entries(constants)
        .map(([name, text]) => `${name} = ${text}`)
        .join(", ");
    return [
        `${rows.length} rows, ${errors} could not be solved. ${faultsOf(solved)}`,
        state.body && "Rows are of the half-plane: k of the form, which is the pad\u2019s, does not count here.",
        unused && `${unused[0].toUpperCase()}${unused.slice(1)}.`,
        from && `From the case of the form: ${from}.`,
        rows.length > SHOWN && `The first ${SHOWN} are drawn; all are copied.`,
    ]
        .filter(Boolean)
        .join(" ");
}

const save = (solved) => download("solved.csv", fileText(linesOf(solved)), "text/csv");

export const aside = new Aside("rows", redraw);

export function batch({ texts, write }) {
    const solved = aside.ask([state.batch, texts, state.sign]) ?? { complaint: "" }, // while it computes
        isBad = solved.complaint !== undefined;
    return html`<label for="batch">Rows pasted from a spreadsheet: one of the first lines names the columns, such as E1, nu1, theta_deg, radius, P, Q, f, yield_stress</label>
        <textarea id="batch" rows="8" wrap="off" spellcheck="false" aria-describedby="batch-note" placeholder=${example}
            .value=${live(state.batch)} @input=${setter("batch")}></textarea>
        <p class="tools"><button type="button" @click=${() => set({ batch: example })}>Try an example</button>
            <span>What the rows lack is taken from the case of the form.</span></p>
        ${waiting(aside)}
        <p id="batch-note" class="note ${isBad ? "bad" : ""}" aria-live="polite">${remarkOf(solved)}</p>
        <p class="tools" ?hidden=${isBad}>${copyButton("Copy the solved rows", () => asText(linesOf(solved)))}
            <button type="button" @click=${() => save(solved)}>Save as CSV</button></p>
        <div class="wide" tabindex="0" role="region" aria-label="Solved rows" ?hidden=${isBad}
            >${isBad ? nothing : tableOf(solved, write)}</div>`;
}
