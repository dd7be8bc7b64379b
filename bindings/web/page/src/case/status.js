// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on a case, in the words and colours of the workbook (cli/workbook/calculator/calculator.c).

/** { colour: green | amber | red, text }. */
export function verdict({ complaints, fault, results, what }) {
    if (complaints) return { colour: "red", text: `CHECK THE INPUTS: ${complaints.map((c) => c.text).join("; ")}` };
    if (fault?.slides) return { colour: "red", text: `SLIDES: Q is above f P, there is no equilibrium. ${fault.text}` };
    if (fault?.noClosedForm)
        return { colour: "red", text: `NO CLOSED FORM: ${fault.text.replace(/^no closed form: /, "")}` };
    if (fault) return { colour: "red", text: `CHECK THE INPUTS: ${fault.text}` };
    if (typeof results.safety === "number" && results.safety < 1)
        return { colour: "red", text: "YIELDS: P is above the load at first yield." };
    if (results.yield_factor !== null && results.yield_factor < 1)
        return { colour: "red", text: "YIELDS: the stress under these loads is above the yield stress." };
    if (results.warnings) return { colour: "amber", text: `CAUTION: ${results.warnings}` };
    if (Number.isNaN(what.k))
        return { colour: "amber", text: "CAUTION: no yield stress is given, so there is no safety" };
    return { colour: "green", text: "OK" };
}
