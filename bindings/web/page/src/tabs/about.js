// SPDX-License-Identifier: GPL-3.0-or-later
// The tab About: the theory in a page, accuracy, errata, licences, how to cite. The texts are those of the READMEs.
import { html } from "lit-html";
import { escaped } from "../parts.js";
import { rwedge } from "../answers/library.js";
import { unitsRemark } from "../units.js";
import { texts } from "texts";

const licences = texts.licences
    .map(({ name, text }) => `<h3>${escaped(name)}</h3><pre>${escaped(text)}</pre>`)
    .join("");

const text = () => `
<h2>What this is</h2>
<p>A wedge with a rounded apex, a cylinder, a flat pad with rounded edges or any convex profile is pressed onto a half-plane: contact law, pressure, partial slip, stresses, first yield, cycles of loads. The library
<b>rwedge ${escaped(rwedge.version())}</b> is inside this file and computes every number here. The file asks for nothing from a network, and its security policy forbids it to.</p>
<p>Source: M. Ciavarella, D. A. Hills, G. Monno, \u201cContact problems for a wedge with rounded apex\u201d, Int. J. Mech. Sci. 40 (1998) 977\u2013988.</p>
<p>It holds for plane strain, small angles and bodies that are large beside the contact. ${escaped(unitsRemark)} In a field, decimal points and commas are both read; a comma that may separate thousands is refused unless the comma is the chosen sign, which is that of pasted rows.</p>
<p>Status: green is OK; amber says what makes the numbers doubtful; red says what is wrong and what is allowed. Q below f P, and \u03c3, are taken to have grown together from 0 under constant P and M;
other histories are in the tab Cycle.</p>
<h2>Conventions</h2>${texts.conventions}
<h2>The formulas</h2><div class="wide" tabindex="0" role="region" aria-label="The formulas">${texts.formulas}</div>
<h2>Accuracy</h2>${texts.accuracy}
<h2>Errata of the paper</h2><div class="wide" tabindex="0" role="region" aria-label="Errata">${texts.errata}</div>
<h2>How to cite</h2><pre>${escaped(texts.citation)}</pre>
<h2>Licences</h2><p>rwedge is free software, GPL-3.0-or-later. Its source: the repository that this file came with. Parts of other packages are inside:</p>
<details><summary>Licences of these packages</summary>${licences}</details>
<details><summary>GNU General Public License, version 3</summary><pre>${escaped(texts.licence)}</pre></details>`;

export const about = () => html`<div class="about" .innerHTML=${text()}></div>`;
