// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page as the part of its address behind #: a case can be sent as a link.

/** From an object of texts; what is empty is left out. */
export function writeAddress(state) {
    const filled = Object.entries(state).filter(([, value]) => value !== undefined && value !== "");
    return "#" + new URLSearchParams(filled).toString();
}

export const readAddress = (hash) => Object.fromEntries(new URLSearchParams(hash.replace(/^#/, "")));
