// SPDX-License-Identifier: GPL-3.0-or-later
// The library as WebAssembly, and its statuses as values where they are no mistake.
import * as rwedge from "rwedge";

export { rwedge };
export const { Contact, statuses } = rwedge;

/** The number of the status that an error of the library has. Any other error is a mistake of the page. */
function statusOf(error) {
    if (error instanceof rwedge.RwedgeError) return statuses[error.status];
    throw error;
}

export const status = {
    /** What an action ends with. */
    of(action) {
        try {
            action();
            return statuses.RWEDGE_OK;
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
