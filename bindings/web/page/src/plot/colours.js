// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of a field: from dark to light where it has one sign, blue over white to red where it has two.
import { scaleLinear } from "d3-scale";

/** Of shares from 0 to 1. */
const along = (text) => {
    const colours = text.split(" ");
    return scaleLinear(
        colours.map((_, i) => i / (colours.length - 1)),
        colours,
    ).clamp(true);
};
const darkToLight = along("#2d0b59 #5b177e #8b2981 #bb3775 #e3505c #f97b4f #fcae64 #fbdf9b #fcf7c5");
const blueToRed = along("#1c4f8c #3f7fbd #7fb1da #bcd8ec #f3f3f3 #f7cdb5 #ea9a78 #cc5f4c #9a1f2e");

/** The colour of a value in a field from lo to hi. */
export function colourOf(value, lo, hi) {
    if (lo >= 0) return darkToLight(1 - value / hi);
    return blueToRed(0.5 + (0.5 * value) / Math.max(-lo, hi));
}
