// SPDX-License-Identifier: GPL-3.0-or-later
// What is said while something is computed aside: that it computes, for how long, how far it is, and how it is stopped.
import { html, nothing } from "lit-html";

const barOf = ({ share }) =>
    share === undefined
        ? html`<progress aria-label="Computing"></progress>`
        : html`<progress aria-label="Loads done" max="1" .value=${share}></progress> ${Math.floor(100 * share)} % of the loads`;

export const waiting = (aside) =>
    aside.busy
        ? html`<p class="note" role="status">Computing${aside.seconds > 0 ? `: ${aside.seconds} s` : ""}
              ${barOf(aside)}
              <button type="button" @click=${() => aside.stop()}>Stop</button></p>`
        : nothing;
