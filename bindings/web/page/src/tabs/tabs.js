// SPDX-License-Identifier: GPL-3.0-or-later
// The tabs: one is seen at a time, and only that one is computed.
import { html, nothing } from "lit-html";
import { set, state, tabs } from "../state.js";
import { about } from "./about.js";
import { batch, aside as rows } from "./batch.js";
import { compare } from "./compare.js";
import { contact } from "./contact.js";
import { cycle, aside as history } from "./cycle.js";
import { strength } from "./strength.js";
import { stress } from "./stress.js";

const views = { contact, stress, strength, cycle, batch, compare, about };
/** What computes for a tab in the background, also while another is seen. */
const asides = { cycle: history, batch: rows };
const names = Object.keys(tabs);

/** By name, as they were drawn last. */
const drawn = {};

/** These show the case. */
const ofCase = ["contact", "stress", "strength"];

/** Draws the tab that is seen. What cannot be computed, far beyond the usual sizes, is said in the tab. */
function faultOfDrawing(model) {
    try {
        drawn[state.tab] = views[state.tab](model);
        return "";
    } catch (error) {
        return `This cannot be computed: ${error.message}`;
    }
}

function turn(event) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    set({ tab: names[(names.indexOf(state.tab) + step + names.length) % names.length] });
    document.getElementById(`tab-${state.tab}`).focus();
}

export const tabList = () =>
    html`<div role="tablist" aria-label="Answers" @keydown=${turn}>${names.map(
        (name) => html`<button type="button" role="tab" id="tab-${name}" aria-controls="panel-${name}"
        aria-selected=${name === state.tab} tabindex=${name === state.tab ? 0 : -1} @click=${() => set({ tab: name })}
        >${tabs[name]}</button>`,
    )}</div>`;

export function tabPanels(model) {
    const seen = ofCase.includes(state.tab) ? model.pictured : model,
        fault = faultOfDrawing(seen);
    return names.map(
        (name) => html`<div role="tabpanel" id="panel-${name}" aria-labelledby="tab-${name}"
            aria-busy=${asides[name]?.busy || nothing} ?hidden=${name !== state.tab}>
            <p class="note bad" role="alert">${name === state.tab ? fault : ""}</p>
            <div class=${seen === model ? "" : "old"} ?inert=${seen !== model}>${drawn[name]}</div></div>`,
    );
}
