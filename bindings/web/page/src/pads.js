// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of body 2: which inputs give each, what each begins with, its heights.

export const pads = {
    wedge: { name: "wedge", names: ["theta", "theta_deg", "a", "radius"] },
    cylinder: { name: "cylinder", names: ["radius"] },
    cylinders: { name: "two cylinders", names: ["radius1", "radius2"] },
    flat: { name: "flat and rounded", names: ["flat", "radius"] },
    profile: { name: "profile, pasted", names: ["profile", "hull", "fit", "heights", "origin"] },
};
/** How a profile is made of its rows: no inputs of the model. */
export const makingNames = ["hull", "fit", "heights", "origin"];
/** The inputs that give a shape. */
export const ofShapes = new Set(Object.values(pads).flatMap(({ names }) => names));

/** The pad that texts give. */
export function padOf(texts) {
    if ("profile" in texts) return "profile";
    if ("flat" in texts) return "flat";
    if ("radius1" in texts) return "cylinders";
    return "radius" in texts && !("theta" in texts || "theta_deg" in texts) ? "cylinder" : "wedge";
}

/** The texts of other pads are kept, and do not count. */
export const textsOfPad = (texts, pad) =>
    Object.fromEntries(Object.entries(texts).filter(([name]) => !ofShapes.has(name) || pads[pad].names.includes(name)));

/** What the inputs of a pad that are empty begin with: by the radius of the one before, and the half-width of its contact. */
export function beginning(pad, radius, b, write) {
    const R = radius > 0 ? radius : 10,
        half = b > 0 ? b / 2 : R / 100;
    const heights = Array.from({ length: 21 }, (_, i) => (4 * half * (i - 10)) / 10);
    return {
        wedge: { theta: write(half / R), radius: write(R) },
        cylinder: { radius: write(R) },
        cylinders: { radius1: write(2 * R), radius2: write(2 * R) },
        flat: { flat: write(half), radius: write(R) },
        profile: {
            profile: ["x\theight", ...heights.map((x) => `${write(x)}\t${write((x * x) / (2 * R))}`)].join("\n"),
        },
    }[pad];
}

/** The heights of a profile: its slopes are linear between places and constant beyond. */
function profileHeight(places) {
    const at = [0];
    for (let i = 1; i < places.length; i++)
        at.push(at[i - 1] + ((places[i].slope + places[i - 1].slope) / 2) * (places[i].x - places[i - 1].x));
    return (x) => {
        const next = places.findIndex((place) => place.x >= x);
        if (next === 0) return places[0].slope * (x - places[0].x);
        if (next < 0) return at.at(-1) + places.at(-1).slope * (x - places.at(-1).x);
        const { x: x0, slope } = places[next - 1],
            bend = (places[next].slope - slope) / (places[next].x - x0 || 1);
        return at[next - 1] + slope * (x - x0) + (bend / 2) * (x - x0) ** 2;
    };
}

/** Its height above the surface at x, from the numbers of the case; for the drawing. */
export function heightOf({ theta, a, radius, flat, places }) {
    if (places.length > 0) return profileHeight(places);
    if (Number.isFinite(flat)) return (x) => Math.max(0, Math.abs(x) - flat) ** 2 / (2 * radius);
    return (x) => theta * (Math.abs(x) < a ? (x * x) / (2 * a) : Math.abs(x) - a / 2);
}
