// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict, above all tabs: strength in a sentence, a bar for its factor, the figures that are asked for first, what is doubtful.
import { html, nothing } from "lit-html";
import { isOffCentre } from "./answers/solution.js";
import { symbols } from "./tabs/symbols.js";

const MOST = 3; // where the bar ends

const figures = [
    ["b", "half-width of the contact", "length"],
    ["p0", "peak pressure", "stress"],
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

/** Of P in full sliding, again and again: up to the first yield it is elastic, up to shakedown it yields at first, beyond it goes on; a line
 * at this P. */
function passesBar({ safety, safety_shakedown: passes }, write) {
    const place = (factor) => (100 * Math.min(factor, MOST)) / MOST,
        [first, last] = [safety, passes].map(place);
    return html`<svg class="factor passes" viewBox="0 0 100 10" preserveAspectRatio="none" role="img"
            aria-label="P in full sliding: elastic up to ${write(safety)} times this P, after a first yield up to ${write(passes)} times">
            <rect class="red" width="100" height="10"/><rect class="amber" width=${last.toFixed(1)} height="10"/>
            <rect class="green" width=${first.toFixed(1)} height="10"/>
            <rect class="limit" x=${(100 / MOST).toFixed(1)} width="0.4" height="10"/></svg>
        <p class="scale"><span>0</span><span>1: this P</span><span>2</span><span>${MOST} and more</span></p>
        <p class="keys"><span class="green">P, sliding: elastic up to ${write(safety)}</span>
            <span class="amber">yields at first, then elastic up to ${write(passes)}</span>
            <span class="red">goes on yielding</span></p>`;
}

const advice = html`<p class="note">Factors on the stress are for P as it is. With the factor on P the contact grows too. Where Q may grow,
    take those of the sliding contact.</p>`;

/** Where the contact is off the centre its stick zone is told by its edges. */
function stickText(model) {
    const { results, setup, zones, unit, write } = model,
        sticks = zones.filter(({ slip }) => slip === 0);
    if (setup.f === 0) return nothing;
    const isCentred = results.c_over_b !== null && !isOffCentre(setup);
    if (isCentred) return figure(model, ["c_over_b", "of the contact sticks", "none"]);
    return sticks.length === 0
        ? html`<span><small>no part of the contact sticks</small></span>`
        : html`<span><b>${sticks.map(({ from, to }) => `${write(from)} \u2026 ${write(to)}`).join(", ")}</b> ${unit.length}
              <small>sticks, of ${write(results.left)} \u2026 ${write(results.right)}</small></span>`;
}

function whole(model) {
    const { strength, factor, colour } = model.verdict;
    return html`<p class="sentence">${strength}</p>
        ${Number.isFinite(factor) ? bar(factor, colour) : nothing}
        ${[model.results.safety, model.results.safety_shakedown].every(Number.isFinite) ? passesBar(model.results, model.write) : nothing}
        <p class="figures">${figures.map((each) => figure(model, each))} ${stickText(model)}</p>
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
