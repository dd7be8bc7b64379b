// SPDX-License-Identifier: GPL-3.0-or-later
// What is said while something is computed aside: that it computes, for how long, and how it is stopped.
import { html, nothing } from "lit-html";

export const waiting = (aside) =>
    aside.busy
        ? html`<p class="note" role="status">Computing${aside.seconds > 0 ? `: ${aside.seconds} s` : ""}
              <progress aria-label="Computing"></progress>
              <button type="button" @click=${() => aside.stop()}>Stop</button></p>`
        : nothing;
