// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of the pad; a pad without sizes begins with those of the one before.
import { html } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { beginning, pads } from "../pads.js";
import { options } from "../parts.js";
import { set, state, written } from "../state.js";
import { waysOf } from "../answers/words.js";

/** Whether the pad has an input, or its other way. */
const has = (pad, name) => waysOf(name).some((way) => way in state.texts && pads[pad].names.includes(way));

function choose(pad, { setup, results }) {
    const { texts, way } = state,
        start = beginning(pad, setup?.radius, results?.b, (value) => written(value, 4));
    if ("radius" in start && pad !== "wedge") delete texts.a;
    if (pad !== "wedge") way.radius = true;
    for (const [name, text] of Object.entries(start)) if (!has(pad, name)) texts[name] = text;
    set({ pad });
}

/** How a profile is made of its rows. */
const makings = {
    "": { name: "as it is" },
    fit: { name: "fitted by arcs" },
    hull: { name: "as its hull" },
};
const makingOf = () => Object.keys(makings).find((name) => name in state.texts) ?? "";

function make({ target }) {
    const { hull, fit, ...texts } = state.texts;
    set({ texts: target.value === "" ? texts : { ...texts, [target.value]: "yes" } });
}

/** For a word that is there or not. */
const toggle = (name, word) => ({ target }) => {
    const { [name]: _, ...texts } = state.texts;
    set({ texts: target.checked ? { ...texts, [name]: word } : texts });
};
const check = (name, word, label) => html`<span><input id=${name} type="checkbox" .checked=${live(name in state.texts)}
    @change=${toggle(name, word)}><label for=${name}>${label}</label></span>`;

export const padChoice = (model) => html`<div class="field"><label for="pad">Shape</label>
    <select id="pad" @change=${({ target }) => choose(target.value, model)}>${options(pads, state.pad)}</select>
    <div ?hidden=${state.pad !== "profile"}><label for="making">The profile is taken</label>
        <select id="making" @change=${make}>${options(makings, makingOf())}</select>
        <p class="tools">${check("origin", "lowest", "x = 0 at its lowest place")}
            ${check("heights", "down", "heights point down")}</p></div></div>`;
