// SPDX-License-Identifier: GPL-3.0-or-later
// "R for a safety of 2": the input that gives it, and a button that takes it into the form.
import { element } from "../elements.js";
import { readNumber, writeNumber } from "../number.js";
import { findInput } from "../solution.js";
import { inputs } from "../words.js";

const names = { radius: "Radius R", a: "Half-width of rounding a", P: "Load P", f: "Friction f" };

/** A part of the page, and show(model). take(name, text) puts the number into the form. */
export function makeFinder(take) {
    const input = element("select", { id: "find-input", "aria-label": "What is looked for" });
    input.append(...Object.entries(names).map(([value, text]) => element("option", { value }, text)));
    const safety = element("input", { id: "find-safety", type: "text", value: "2", size: 5, "aria-label": "Safety" });
    const answer = element("output", { id: "find-answer" });
    const use = element("button", { type: "button", hidden: true }, "Take it");
    let model, solution;
    const show = (present) => {
        model = present;
        const wanted = readNumber(safety.value, model.sign);
        solution =
            wanted > 0
                ? findInput(model.texts, model.sign, input.value, wanted)
                : { complaint: "the safety must be above 0" };
        const unit = model.unit[inputs[input.value].unit];
        answer.textContent = solution.complaint ?? `${model.write(solution.value)} ${unit}`;
        use.hidden = Boolean(solution.complaint);
    };
    for (const [part, kind] of [
        [input, "change"],
        [safety, "input"],
    ])
        part.addEventListener(kind, () => show(model));
    use.addEventListener("click", () => take(input.value, writeNumber(solution.value, 15, model.sign)));
    const line = element(
        "p",
        { class: "tools" },
        input,
        " for a safety, in full sliding, of ",
        safety,
        ": ",
        answer,
        use,
    );
    return { box: element("fieldset", { class: "find" }, element("legend", {}, "Find an input"), line), show };
}
