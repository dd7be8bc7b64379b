// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Compare: cases that were pinned, with names, their numbers side by side with the present one's, and the differences in percent.
import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { factorOf } from "../answers/library.js";
import { resultKinds } from "../answers/words.js";
import { copyButton } from "../parts.js";
import { redraw, state } from "../state.js";
import { wordsOf } from "../units.js";
import { groups, symbols } from "./symbols.js";

const pinned = []; // { name, results, inputs, units }
let count = 0;

function pin({ results, inputs }) {
    count++;
    pinned.push({ name: state.name || `case ${count}`, results, inputs, units: state.units });
    redraw();
}

const shown = groups.flatMap(({ names }) => names);

/** In the units of the page now. */
const numberOf = ({ results, units }, name) =>
    typeof results[name] === "number" ? results[name] * factorOf(wordsOf(units), wordsOf(state.units), resultKinds[name].unit) : null;

/** How much more the present number is. */
function percentText(value, of) {
    if (typeof value !== "number" || of === null || of === 0) return "";
    const percent = 100 * (value / of - 1);
    return `${percent < 0 ? "\u2212" : "+"}${Math.abs(percent) < 0.05 ? "0" : Math.abs(percent).toPrecision(3)} %`;
}

function rowsOf({ results, write, unit }) {
    const present = (name) => (typeof results?.[name] === "number" ? results[name] : null);
    return shown
        .filter((name) => present(name) !== null || pinned.some((each) => numberOf(each, name) !== null))
        .map((name) => [
            symbols[name] ?? name,
            unit[resultKinds[name].unit] ?? "",
            write(present(name)),
            ...pinned.flatMap((each) => [write(numberOf(each, name)), percentText(present(name), numberOf(each, name))]),
        ]);
}

const headOf = () => ["", "unit", "present", ...pinned.flatMap(({ name }) => [name, "present less this"])];

const names = () => html`<ul class="pins">${pinned.map(
    (each, i) => html`<li><label for="pin-${i}">Name</label> <input type="text" id="pin-${i}" size="16" autocomplete="off" .value=${live(each.name)}
        @input=${({ target }) => (Object.assign(each, { name: target.value }), redraw())}>
        <button type="button" @click=${() => (pinned.splice(i, 1), redraw())}>Remove ${each.name}</button></li>`,
)}</ul>`;

export function compare(model) {
    const rows = rowsOf(model),
        asText = () => [headOf(), ...rows].map((cells) => cells.join("\t")).join("\n");
    return html`<p class="tools"><button type="button" id="pin-case" ?disabled=${!model.results} @click=${() => pin(model)}>Pin the present case</button>
            ${pinned.length > 0 ? copyButton("Copy the table", asText) : nothing}</p>
        <p class="note">${pinned.length === 0 ? "Pin a case, change the inputs, and compare: the table has both, and how much they differ." : "Percent: how much more the present number is."}</p>
        ${names()}
        <div class="wide" tabindex="0" role="region" aria-label="Cases side by side"><table class="numbers rows" id="side-by-side">
            <caption class="hidden">Cases side by side</caption>
            <thead><tr>${headOf().map((name) => html`<th scope="col">${name}</th>`)}</tr></thead>
            <tbody>${rows.map(([name, ...cells]) => html`<tr><th scope="row">${name}</th>${cells.map((cell) => html`<td>${cell}</td>`)}</tr>`)}</tbody></table></div>`;
}
