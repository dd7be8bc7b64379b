// SPDX-License-Identifier: GPL-3.0-or-later
// A case as a command and as a program: both give the numbers that are shown.
import { wholeNumber } from "./number.js";
import { inputs } from "./words.js";

const numbersOf = (model) => Object.entries(model.inputs).map(([name, value]) => [name, wholeNumber(value)]);

/** The command for the case: rwedge solve --E1 210000 ... */
export function asCommand(model) {
    const options = numbersOf(model).map(([name, value]) => `--${inputs[name].option} ${value}`);
    const factor = "k" in model.inputs || "yield_stress" in model.inputs ? " --yield-factor" : "";
    return `rwedge solve ${options.join(" ")}${factor}`;
}

const inPython = (value) => (value === "inf" ? "math.inf" : value);

/** A program in Python for the case, with the package rwedge. */
export function asPython(model) {
    const value = Object.fromEntries(numbersOf(model).map(([name, number]) => [name, inPython(number)]));
    const theta = value.theta ?? `math.radians(${value.theta_deg})`;
    const a = value.a ?? `rwedge.rounding(theta, ${value.radius})`;
    const k = value.k ?? (value.yield_stress && `${value.yield_stress} / math.sqrt(3)`);
    const { E1, nu1, P, M = "0", Q = "0", sigma = "0", f = "0" } = value;
    const centred = Number(M) === 0 && Number(sigma) === 0;
    return `import math
import rwedge

E1, nu1, E2, nu2 = ${E1}, ${nu1}, ${value.E2 ?? E1}, ${value.nu2 ?? nu1}
theta = ${theta}
a = ${a}
P, M, Q, sigma, f = ${P}, ${M}, ${Q}, ${sigma}, ${f}
A = float(rwedge.compliance(E1, nu1, E2, nu2))

contact = rwedge.Contact(theta=theta, a=a, A=A, f=f)
contact.apply(P, M, 0, 0)  # P and M first, then Q and sigma together
contact.apply(P, M, Q, sigma)
print("b", contact.half_width)
print("c", contact.stick_half_width)
left, right = contact.edges
print("left", left)
print("right", right)
print("max_tension", float(contact.stresses([left, right], 0.0)[0].max()))
${k === undefined ? "" : `k = ${k}\n${centred ? 'print("P_yield", float(rwedge.yield_load(theta, a, A, f, nu1, k)))\n' : ""}print("yield_factor", contact.yield_factor(nu1, k).factor)\n`}`;
}
