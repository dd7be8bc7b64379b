// SPDX-License-Identifier: GPL-3.0-or-later
// What is said while something is computed aside: that it computes, for how long, how far it is, and how it is stopped.
import { html, nothing } from "lit-html";

/** One element, which gets its value when that is known: what is swapped is read anew to who cannot see it. */
const barOf = ({ share }) =>
    html`<progress aria-label="Computing" max="1" value=${share ?? nothing}></progress>${share === undefined ? "" : ` ${Math.floor(100 * share)} % of the loads`}`;

export const waiting = (aside) =>
    aside.busy
        ? html`<p class="note" role="status">Computing${aside.seconds > 0 ? `: ${aside.seconds} s` : ""}
              ${barOf(aside)}
              <button type="button" @click=${() => aside.stop()}>Stop</button></p>`
        : nothing;
