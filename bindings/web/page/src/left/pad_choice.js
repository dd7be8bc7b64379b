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

function takeHull({ target }) {
    const { hull, ...texts } = state.texts;
    set({ texts: target.checked ? { ...texts, hull: "yes" } : texts });
}

export const padChoice = (model) => html`<div class="field"><label for="pad">Shape</label>
    <select id="pad" @change=${({ target }) => choose(target.value, model)}>${options(pads, state.pad)}</select>
    <p class="tools" ?hidden=${state.pad !== "profile"}>
        <input id="hull" type="checkbox" .checked=${live("hull" in state.texts)} @change=${takeHull}>
        <label for="hull">take the convex hull</label></p></div>`;
