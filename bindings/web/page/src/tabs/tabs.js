// SPDX-License-Identifier: GPL-3.0-or-later
// The tabs: one is seen at a time, and only that one is computed.
import { element } from "../elements.js";
import { makeAbout } from "./about.js";
import { makeBatch } from "./batch.js";
import { makeContact } from "./contact.js";
import { makeCycle } from "./cycle.js";
import { makeStrength } from "./strength.js";
import { makeStress } from "./stress.js";

const titles = {
    contact: ["Contact", makeContact],
    stress: ["Stress", makeStress],
    strength: ["Strength", makeStrength],
    cycle: ["Cycle", makeCycle],
    batch: ["Batch", makeBatch],
    about: ["About", makeAbout],
};

/** These show the case: without results their last picture stays, greyed. */
const ofCase = ["contact", "stress", "strength"];

/** Draws a tab. What cannot be computed, far beyond the usual sizes, is said in the tab. */
function drawSafely(part, model) {
    const { name, draw, fault, panel } = part,
        keeps = ofCase.includes(name) && !model.results && part.drawn;
    fault.textContent = "";
    panel.classList.toggle("old", Boolean(keeps));
    if (keeps) return;
    part.drawn = Boolean(model.results);
    try {
        draw(model);
    } catch (error) {
        fault.textContent = `This cannot be computed: ${error.message}`;
    }
}

/** A tab: its button, its panel, how it is drawn, and where a fault is said. */
function makePart(name, title, { panel, show: draw }, open) {
    const button = element(
        "button",
        { type: "button", role: "tab", id: `tab-${name}`, "aria-controls": `panel-${name}`, onclick: open },
        title,
    );
    const fault = element("p", { class: "note bad", role: "alert" });
    const attributes = { role: "tabpanel", id: `panel-${name}`, "aria-labelledby": `tab-${name}` };
    return { name, button, box: element("div", attributes, fault, panel), panel, draw, fault };
}

/** The list of tabs, their panels, and show(model). model() is the present case; changed() follows a change of the state. */
export function makeTabs(state, model, changed) {
    const names = Object.keys(titles),
        parts = {};
    const open = (name, focus) => {
        state.tab = name;
        show(model());
        changed();
        if (focus) parts[name].button.focus();
    };
    for (const [name, [title, make]] of Object.entries(titles))
        parts[name] = makePart(name, title, make(state, changed), () => open(name));
    const list = element(
        "div",
        { role: "tablist", "aria-label": "Answers" },
        ...names.map((name) => parts[name].button),
    );
    list.addEventListener("keydown", (event) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (!step) return;
        event.preventDefault();
        open(names[(names.indexOf(state.tab) + step + names.length) % names.length], true);
    });
    const show = (present) => {
        if (!Object.hasOwn(parts, state.tab)) state.tab = names[0];
        for (const name of names) {
            const seen = name === state.tab;
            parts[name].box.hidden = !seen;
            parts[name].button.setAttribute("aria-selected", seen);
            parts[name].button.tabIndex = seen ? 0 : -1;
        }
        drawSafely(parts[state.tab], present);
    };
    return { list, panels: names.map((name) => parts[name].box), show };
}
