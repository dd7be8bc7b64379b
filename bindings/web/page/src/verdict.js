// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict, above all tabs: strength in a sentence, a bar for its factor, the figures that are asked for first, what is doubtful.
import { html, nothing } from "lit-html";
import { symbols } from "./tabs/symbols.js";

const MOST = 3; // where the bar ends

const figures = [
    ["b", "half-width of the contact", "length"],
    ["p0", "peak pressure", "stress"],
    ["c_over_b", "of the contact sticks", "none"],
];

function figure(model, [name, meaning, unit]) {
    const value = model.write(model.results[name]);
    return value === ""
        ? nothing
        : html`<span><b>${symbols[name]} = ${value}</b> ${model.unit[unit]} <small>${meaning}</small></span> `;
}

/** From 0 on, with a line at 1 and a word for it. */
export function bar(factor, colour, limit = "yields") {
    const share = (100 * Math.min(factor, MOST)) / MOST;
    return html`<svg class="factor ${colour}" viewBox="0 0 100 10" preserveAspectRatio="none" role="img"
            aria-label="Factor ${factor.toPrecision(3)}; 1: ${limit}">
            <rect width="100" height="10"/><rect class="reached" width=${share.toFixed(1)} height="10"/>
            <rect class="limit" x=${(100 / MOST).toFixed(1)} width="0.4" height="10"/></svg>
        <p class="scale"><span>0</span><span>1: ${limit}</span><span>2</span><span>${MOST} and more</span></p>`;
}

const advice = html`<p class="note">The factor on the stress is for the loads as they are. Where Q may grow, take that of
    the sliding contact, a factor on P.</p>`;

function whole(model) {
    const { strength, factor, colour } = model.verdict;
    return html`<p class="sentence">${strength}</p>
        ${Number.isFinite(factor) ? bar(factor, colour) : nothing}
        <p class="figures">${figures.map((each) => figure(model, each))}</p>
        ${Number.isFinite(model.results.safety) ? advice : nothing}`;
}

/** The tabs of many loads or cases judge these themselves: above them stands only what is wrong with the case of the form. */
const isOfCase = (tab) => !["cycle", "batch"].includes(tab);
export const isSilent = (model, tab) => !isOfCase(tab) && model.faults.length === 0;

export function verdict(model, tab) {
    const { colour, text } = model.verdict,
        isWhole = isOfCase(tab) && model.results;
    return html`<div role="status" ?hidden=${isSilent(model, tab)}>
        <div class="verdict" ?hidden=${!isWhole}>${isWhole ? whole(model) : nothing}</div>
        <p class="status ${colour}" id="status" ?hidden=${text === "OK" && isWhole}
            >${isOfCase(tab) ? text : `The case of the form: ${text}`}</p></div>`;
}
