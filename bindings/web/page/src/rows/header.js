// SPDX-License-Identifier: GPL-3.0-or-later
// The names of columns: which are inputs, and which are probably meant for one. As cli/model/header.c.
import { words } from "words";
import { alternatives, inputNames } from "../case/inputs.js";

const bare = (name) => name.toLowerCase().replace(/[\x00-\x2f\x3a-\x60\x7b-\x7f]/g, "");
const isLike = (a, b) => bare(a) === bare(b);
const other = (name) => alternatives[name] ?? Object.keys(alternatives).find((key) => alternatives[key] === name);

/** The input that the name nearly is: "Yield stress", " f" and "Q [N/mm]" are slips. But p beside P may be another thing. */
function slipFor(name, given) {
    return inputNames.find(
        (input) => isLike(name, input) && (input.length > 1 || name.includes(input) || !given(input)),
    );
}

function complaintAbout(name, given) {
    const beforeUnit = name.split(/[[(]/)[0];
    const slip = slipFor(name, given) ?? slipFor(beforeUnit, given);
    const meant = slip ?? words.synonyms.find(([synonym, input]) => isLike(beforeUnit, synonym) && !given(input))?.[1];
    if (!meant) return null;
    return `column '${name}': allowed: ${meant}${meant === "theta" && name !== beforeUnit ? " in radians or theta_deg" : ""}${slip ? "" : ", or another name if it is something else"}`;
}

/** Where each input stands among the names; or complaints. constants: inputs that are given without a column. */
export function readHeader(names, wanted, constants = {}) {
    const column = Object.fromEntries(
        wanted.filter((input) => names.includes(input)).map((input) => [input, names.indexOf(input)]),
    );
    const isThere = (input) => input in column || input in constants;
    const given = (input) => isThere(input) || (other(input) !== undefined && isThere(other(input)));
    const twice = Object.keys(column).filter((input) => names.indexOf(input) !== names.lastIndexOf(input));
    const complaints = [
        ...twice.map((input) => `column ${input}: there twice; allowed: once`),
        ...names
            .filter((name) => !(name in column))
            .map((name) => complaintAbout(name, given))
            .filter(Boolean),
    ];
    return { column, complaints };
}
