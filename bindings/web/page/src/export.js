// SPDX-License-Identifier: GPL-3.0-or-later
// A case as a command and as a program: both give the numbers that are shown.
import { wholeNumber } from "./number.js";
import { inputs } from "./answers/words.js";

/** A profile is in a file that is saved beside. */
const numbersOf = (model) =>
    Object.entries(model.inputs).map(([name, value]) => [
        name,
        name === "profile" ? "profile.csv" : wholeNumber(value),
    ]);

const asOption = ([name, value]) => `--${inputs[name].option} ${value}`;

/** How the profile is made, and plane stress: of the texts that the model was told. */
const makingOptions = ({ texts = {} }) =>
    [
        texts.hull && "--hull",
        texts.fit && "--fit",
        texts.heights && `--heights ${texts.heights}`,
        texts.origin && `--origin ${texts.origin}`,
    ].filter(Boolean);
const planeOption = ({ texts = {} }) => (texts.plane_stress ? ["--plane-stress"] : []);
const rotationOption = ({ texts = {} }) =>
    [texts.rotation && `--rotation ${texts.rotation}`, texts.similar && "--similar"].filter(Boolean);
const bodyOption = ({ texts = {} }) => (texts.strength_of ? ["--strength-of 2"] : []);

/** The command for the case: rwedge solve --E1 210000 ... */
export function asCommand(model) {
    const options = [
        ...numbersOf(model).map(asOption),
        ...makingOptions(model),
        ...planeOption(model),
        ...rotationOption(model),
        ...bodyOption(model),
    ];
    const factor = "k" in model.inputs || "yield_stress" in model.inputs ? " --yield-factor" : "";
    return `rwedge solve ${options.join(" ")}${factor}`;
}

const ofLoad = ["P", "M", "Q", "sigma"];
const SHOWN = 100; // loads

/** The options of a criterion other than the usual one, and of what it needs. */
function criterionOptions({ name, isPlaneStress, constants }) {
    const values = Object.entries(constants).map(
        ([need, value]) => `--${need.toLowerCase().replaceAll("_", "-")} ${value}`,
    );
    return [
        isPlaneStress && "--plane-stress",
        values.length > 0 && `--criteria ${name.replaceAll("_", "-")}`,
        ...values,
    ].filter(Boolean);
}

/** The command for a cycle of loads of the case, from { loads, criterion }: printf ... | rwedge fretting ... P and M come first where no table was given. */
export function asFretting(model, { loads, tilts, displacements, compliance, criterion }, cycles, hasTable) {
    if (loads.length > SHOWN)
        return `More than ${SHOWN} loads: save them as a file and give it to \u201crwedge fretting\u201d.`;
    const isHeld = "tilt" in model.inputs || tilts || model.texts?.rotation === "held", // the moment is a result
        columns = tilts ? ["P", "tilt", "Q", "sigma"] : isHeld ? ["P", "Q", "sigma"] : ofLoad,
        ofRow = displacements ? columns.map((name) => (name === "Q" ? "displacement" : name)) : columns,
        valueAt = (i, name) => wholeNumber({ tilt: tilts, displacement: displacements }[name]?.[i] ?? loads[i][name]);
    const rows = [ofRow.join(), ...loads.map((_, i) => ofRow.map((name) => valueAt(i, name)).join())];
    const ofPad = model.texts?.strength_of ? ["k", "yield_stress"] : []; // a cycle is of the half-plane
    const options = numbersOf(model).filter(([name]) => !ofLoad.includes(name) && !ofPad.includes(name));
    const before = hasTable ? "" : ` --load ${loads[0].P},${isHeld ? 0 : loads[0].M},0,0`;
    const rig = displacements ? [`--compliance ${wholeNumber(compliance)}`] : [];
    return `printf '${rows.join("\\n")}\\n' | rwedge fretting -${before} --cycles ${cycles} ${[...rig, ...options.map(asOption), ...makingOptions(model), ...rotationOption(model), ...criterionOptions(criterion)].join(" ")}`;
}

const inPython = (value) => (value === "inf" ? "math.inf" : value);

const listOf = (places, name) => `[${places.map((place) => place[name]).join(", ")}]`;
const sizesInPython = {
    wedge: ({ theta, theta_deg, a, radius }) =>
        `theta = ${theta ?? `math.radians(${theta_deg})`}\na = ${a ?? `rwedge.rounding(theta, ${radius})`}`,
    cylinder: ({ radius }) => `R = ${radius}`,
    cylinders: ({ radius1, radius2 }) => `R = 1 / (1 / ${radius1} + 1 / ${radius2})`,
    flat: ({ flat, radius }) => `a, R = ${flat}, ${radius}  # half-width of the flat, radius of its edges`,
    profile: (_, { places }) => `x = ${listOf(places, "x")}\nslope = ${listOf(places, "slope")}`,
};
const makersInPython = {
    wedge: "(theta=theta, a=a, A=A, f=f)",
    cylinder: ".cylinder(R, A, f)",
    cylinders: ".cylinder(R, A, f)",
    flat: ".flat(a, R, A, f)",
    profile: ".profile(x, slope, A, f)",
};

/** A program in Python for the case, with the package rwedge. */
export function asPython(model) {
    const value = Object.fromEntries(numbersOf(model).map(([name, number]) => [name, inPython(number)]));
    const k = value.k ?? (value.yield_stress && `${value.yield_stress} / math.sqrt(3)`);
    const { texts = {}, setup } = model,
        isStress = Boolean(texts.plane_stress),
        isCoupled = Boolean(setup?.coupled);
    const { E1, nu1, tilt = texts.rotation === "held" ? "0" : undefined, P, M = "0", Q = "0", sigma = "0", f = "0" } = value;
    const beta = `beta = rwedge.dundurs_beta${isStress ? "_plane_stress" : ""}(E1, nu1, E2, nu2)\n`;
    const coupling = "contact.set_beta(beta)  # friction changes the pressure of unlike bodies\ncontact.allow_error(1e-3)\n";
    const centred = !isCoupled && model.pad === "wedge" && Number(M) === 0 && Number(sigma) === 0;
    return `import math
import rwedge

E1, nu1, E2, nu2 = ${E1}, ${nu1}, ${value.E2 ?? E1}, ${value.nu2 ?? nu1}
${texts.strength_of ? "E1, nu1, E2, nu2 = E2, nu2, E1, nu1  # stresses of the pad, seen from its own side\n" : ""}${isCoupled ? beta : ""}${isStress ? "nu1 = nu2 = 0  # plane stress\n" : ""}${sizesInPython[model.pad](value, model.setup)}
P, M, Q, sigma, f = ${P}, ${M}, ${Q}, ${sigma}, ${f}
A = float(rwedge.compliance(E1, nu1, E2, nu2))

contact = rwedge.Contact${makersInPython[model.pad]}
${"E2" in value ? "contact.set_strain((1 - nu1**2) / E1)  # body 1 under tension\n" : ""}${isCoupled ? coupling : ""}${tilt === undefined ? "" : `contact.set_rotation(1)  # held at a tilt: M is a result\ncontact.guide(0, ${tilt}, 0, 0)\n`}${isCoupled && Number(M) !== 0 ? "contact.apply(P, 0, 0, 0)\n" : ""}contact.apply(P, M, 0, 0)  # P and M first, then Q and sigma together
contact.apply(P, M, Q, sigma)
print("b", contact.half_width)
print("c", contact.stick_half_width)
left, right = contact.edges
print("left", left)
print("right", right)
print("max_tension", float(contact.stresses([left, right], 0.0)[0].max()))
${k === undefined ? "" : `k = ${k}\n${centred ? 'print("P_yield", float(rwedge.yield_load(theta, a, A, f, nu1, k)))\n' : ""}print("yield_factor", contact.yield_factor(nu1, k).factor)\n`}`;
}
