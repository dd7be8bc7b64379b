// SPDX-License-Identifier: GPL-3.0-or-later
// The library as WebAssembly, and its statuses as values where they are no mistake.
import * as rwedge from "rwedge";

export { rwedge };
export const { Contact } = rwedge;

function statusOf(error) {
    if (error instanceof rwedge.RwedgeError) return error.status;
    throw error;
}

export const status = {
    OK: "RWEDGE_OK",
    EDOMAIN: "RWEDGE_EDOMAIN",
    ESLIDING: "RWEDGE_ESLIDING",
    EPATH: "RWEDGE_EPATH",

    /** What an action ends with. */
    of(action) {
        try {
            action();
            return status.OK;
        } catch (error) {
            return statusOf(error);
        }
    },

    /** What an action gives; null where the library refuses. */
    orNull(action) {
        try {
            return action();
        } catch (error) {
            statusOf(error);
            return null;
        }
    },
};

/** The library's words for a status: strerror() takes numbers. */
export function reason(name) {
    const numbers = {
        RWEDGE_EDOMAIN: 1,
        RWEDGE_ERANGE: 3,
        RWEDGE_ENOCONV: 4,
        RWEDGE_ENOMEM: 5,
        RWEDGE_ESLIDING: 6,
        RWEDGE_EABSENT: 8,
        RWEDGE_EPATH: 9,
    };
    return rwedge.strerror(numbers[name] ?? 0);
}
