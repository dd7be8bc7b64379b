// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of a field: from dark to light where it has one sign, blue over white to red where it has two.

const darkToLight = ["#2d0b59", "#5b177e", "#8b2981", "#bb3775", "#e3505c", "#f97b4f", "#fcae64", "#fbdf9b", "#fcf7c5"];
const blueToRed = ["#1c4f8c", "#3f7fbd", "#7fb1da", "#bcd8ec", "#f3f3f3", "#f7cdb5", "#ea9a78", "#cc5f4c", "#9a1f2e"];

function between(from, to, share) {
    const part = (text, i) => parseInt(text.slice(1 + 2 * i, 3 + 2 * i), 16);
    const mixed = [0, 1, 2].map((i) => Math.round(part(from, i) + share * (part(to, i) - part(from, i))));
    return `rgb(${mixed.join(",")})`;
}

function along(colours, share) {
    const at = Math.max(0, Math.min(1, share)) * (colours.length - 1),
        i = Math.min(colours.length - 2, Math.floor(at));
    return between(colours[i], colours[i + 1], at - i);
}

/** The colour of a value in a field from lo to hi. */
export function colourOf(value, lo, hi) {
    if (lo >= 0) return along(darkToLight, 1 - value / hi);
    if (hi <= 0) return along(blueToRed, 0.5 - 0.5 * (value / lo));
    const most = Math.max(-lo, hi);
    return along(blueToRed, 0.5 + (0.5 * value) / most);
}
