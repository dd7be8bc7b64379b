// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the tab Cycle about a crack at an edge: its range of K over its length, where it stops, and that in a sentence.
import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { options } from "../parts.js";
import { curvePlot } from "../plot/live.js";
import { withUnit } from "../model.js";
import { edges, setter, state } from "../state.js";

const shears = {
    none: { title: "mode I", style: "one" },
    locked: { title: "locked faces", style: "two" },
    free: { title: "free faces", style: "three" },
};

/** What is asked of a crack; nothing where it has no lengths. */
export function askedCrack({ unit }) {
    const { crack_edge: edge, crack_angle: angle, crack_from: from, crack_to: to } = state;
    return from.trim() && to.trim() ? { edge, angle, from, to, unit: unit.length } : null;
}

const field = (name, title, unit) => html`<label for=${name}>${title}</label>
    <input id=${name} type="text" size="6" inputmode="decimal" spellcheck="false" .value=${live(state[name])}
        @input=${setter(name)}>${unit}`;

const entries = ({ unit }) => html`
    <p class="tools"><label for="crack_edge">A straight crack at the edge</label>
        <select id="crack_edge" @change=${setter("crack_edge")}>${options(edges, state.crack_edge)}</select>
        ${field("crack_angle", "at an angle to the normal, towards +x, of", "\u00b0")}
        ${field("crack_from", "from the length", unit.length)} ${field("crack_to", "to", unit.length)}</p>`;

const noteOf = (crack) =>
    crack?.complaint ?? (crack ? crack.doubt : "Its range of K is drawn where both lengths are given. Constants of the material " +
        "say whether it stops: dK_th and ds0, and paris_C and paris_m for its life; those of K have their unit, as 2.1 MPa sqrt(m).");

/** Each length at which it stops, once. */
function stopsOf({ length, dK, verdict = {} }, { write }) {
    const stops = Object.entries(verdict).filter(([, { arrest }]) => arrest !== null && arrest > length[0]);
    return stops.map(([shear, { arrest }]) => {
        const i = Math.max(1, length.findIndex((l) => l >= arrest)),
            share = (arrest - length[i - 1]) / (length[i] - length[i - 1]),
            [before, after] = [dK[shear][i - 1], dK[shear][i]];
        return { x: arrest, y: before + share * (after - before), name: `stops: ${write(arrest)}` };
    });
}

function pictureOf(crack, model) {
    const { length, dK, threshold } = crack,
        { unit } = model,
        hasThreshold = threshold.every((value) => value !== null);
    const ofShear = ([shear, y]) => ({ name: shears[shear].title, style: shears[shear].style, x: length, y });
    return {
        title: "Range of K over the length of a crack",
        curves: [
            ...Object.entries(dK).map(ofShear),
            ...(hasThreshold ? [{ name: "threshold", style: "dashed", x: length, y: threshold }] : []),
        ],
        points: stopsOf(crack, model),
        xLabel: withUnit("length of the crack", unit.length),
        yLabel: withUnit("\u0394K", `${unit.stress} \u221a${unit.length}`),
    };
}

const columnsOf = ({ length, dK, threshold }, unit) => {
    const ofK = `${unit.stress} sqrt(${unit.length})`;
    return [
        { name: "length", unit: unit.length, numbers: length },
        ...Object.entries(dK).map(([shear, numbers]) => ({ name: `dK_${shear}`, unit: ofK, numbers })),
        { name: "threshold", unit: ofK, numbers: threshold },
    ];
};

/** What is typed, the sentence and the picture. isOld: the answer is to other inputs. */
export function crackPart(crack, model, isOld) {
    const isThere = crack && crack.complaint === undefined;
    return html`<h2>A crack at the edge</h2>
        ${entries(model)}
        <p id="crack-note" class="note ${crack?.complaint ? "bad" : ""}" aria-live="polite">${noteOf(crack)}</p>
        <div class=${isOld ? "old" : ""} ?inert=${isOld}>
            ${isThere && crack.sentence && !isOld ? html`<p class="sentence" id="crack-sentence">${crack.sentence}.</p>` : nothing}
            ${isThere ? curvePlot("crack", pictureOf(crack, model), () => columnsOf(crack, model.unit)) : nothing}</div>`;
}
