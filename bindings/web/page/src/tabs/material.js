// SPDX-License-Identifier: GPL-3.0-or-later
// The material of a cycle: one that is shipped, with its source, or constants by name; how many cycles are wanted.
import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { constantsOf } from "../answers/last_cycle.js";
import { factorOf } from "../answers/library.js";
import { criteria, needs } from "../answers/words.js";
import { options } from "../parts.js";
import { set, setter, state, typed, written } from "../state.js";
import { wordsOf } from "../units.js";
import { texts } from "texts";

const { materials } = texts;
const remarks = ["name", "source"];

/** A shipped material as lines, a name and a number each. */
export const linesOf = (name) =>
    Object.entries(materials[name])
        .filter(([word]) => !remarks.includes(word))
        .map(([word, value]) => `${word}\t${typeof value === "number" ? String(value).replace(".", state.sign) : value}`)
        .join("\n");

const menu = { "": { name: "by its constants" }, ...materials };

const choose = ({ target: { value } }) => set({ shipped: value, material: value === "" ? state.material : linesOf(value) });

/** [[name, text]] of what is typed; nothing where it cannot be read, which the tab says. */
function entries() {
    try {
        return constantsOf(state.material, state.sign);
    } catch {
        return [];
    }
}

/** One constant is another text; what it was is forgotten where that is empty. */
function put(name, text) {
    const all = entries().filter(([word]) => word !== name),
        lines = (text.trim() === "" ? all : [...all, [name, text.trim().replace(",", ".")]]).map(
            ([word, value]) => `${word}\t${/^[-+\d.e]+$/i.test(value) ? value.replace(".", state.sign) : value}`);
    set({ material: lines.join("\n"), shipped: "" });
}

const unitText = (unit, model) => model.unit[unit] ?? (unit === "none" ? "" : unit.replace("sqrt", "\u221a").replace("stress", model.unit.stress).replace("length", model.unit.length));

function field({ name, meaning, unit }, model, given) {
    const id = `constant-${name}`,
        text = given[name] ?? "";
    return html`<div class="field"><label for=${id} title=${meaning}>${name}: ${meaning}</label><div class="row">
        <input id=${id} type="text" size="12" autocomplete="off" spellcheck="false" .value=${live(text.replace(".", state.sign))}
            @change=${({ target }) => put(name, target.value)}><span class="unit">${unitText(unit, model)}</span></div></div>`;
}

/** Where the half-plane is of another modulus than the material. */
function modulusHint(model, { E, nu, yield_stress, units }) {
    const factor = factorOf(units ?? wordsOf(state.units), wordsOf(state.units), "stress"),
        own = Number(E) * factor,
        { E1 } = model.inputs;
    if (!(own > 0) || !(E1 > 0) || Math.abs(E1 / own - 1) < 0.01) return nothing;
    const take = () => {
        const { k, ...others } = state.texts;
        const strength = Number(yield_stress) > 0 ? { yield_stress: written(Number(yield_stress) * factor, 6) } : k ? { k } : {};
        if (strength.yield_stress) Object.assign(state.way, { k: false, yield_stress: true });
        set({ texts: { ...others, E1: written(own, 6), ...(nu ? { nu1: written(Number(nu), 6) } : {}), ...strength } });
    };
    return html`<p class="note bad" id="modulus">E of this material is ${model.write(own)}, E\u2081 of the half-plane ${model.write(E1)} ${model.unit.stress}.
        <button type="button" @click=${take}>Take those of the material</button></p>`;
}

/** How the life is beside the cycles that are wanted: { text, factor }; nothing where one of them is not known. */
export function lifeBeside(life) {
    const wanted = typed(state.wanted);
    if (!(wanted > 0) || life === null) return null;
    const factor = life / wanted;
    return { factor, text: factor >= 1 ? `enough for the ${state.wanted.trim()} wanted` : `fewer than the ${state.wanted.trim()} wanted` };
}

export function materialPart(model) {
    const given = Object.fromEntries(entries()),
        { criterion, shipped } = state,
        source = materials[shipped]?.source;
    return html`<p class="tools"><label for="material-name">Material</label>
            <select id="material-name" @change=${choose}>${options(menu, shipped)}</select>
            <label for="wanted">Cycles wanted</label>
            <input id="wanted" type="text" size="8" autocomplete="off" .value=${live(state.wanted)} @input=${setter("wanted")}></p>
        <p class="note" ?hidden=${!source}>Source: ${source}.</p>
        ${modulusHint(model, given)}
        <details ?open=${shipped !== "" || state.material !== ""}><summary>Its constants for ${criteria[criterion]}</summary>
            <div class="groups"><fieldset><legend>Constants</legend>${needs[criterion].map((need) => field(need, model, given))}</fieldset></div>
            <label for="material">All of them, a name and a number a line, or JSON; a number may have its unit</label>
            <textarea id="material" rows="5" placeholder="swt_limit\t0.5" spellcheck="false" .value=${live(state.material)}
                @input=${({ target }) => set({ material: target.value, shipped: "" })}></textarea></details>`;
}
