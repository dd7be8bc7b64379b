// SPDX-License-Identifier: GPL-3.0-or-later
// Processor time of calls of the package, in ns a point or call: what speed.c does.
import * as rwedge from "rwedge";

const POINTS = 20000, CALLS = 1000, TRIALS = 15;
const x = Float64Array.from({ length: POINTS }, (_, i) => -2 + 4 * i / POINTS);
const y = Float64Array.from({ length: POINTS }, (_, i) => 0.01 + 2 * ((i * 7919) % POINTS) / POINTS);
const friction = Float64Array.from({ length: CALLS }, (_, i) => 0.1 + 1e-4 * i), near = x.map((place) => place / 3);
const contact = new rwedge.Contact(0.01, 0.5, 1.8e-5, 0.3);
contact.load(1000, 0);
contact.load(1000, 200);

function report(what, run, count) {
    let best = Infinity;
    for (let trial = 0; trial < TRIALS; trial++) {
        const began = process.cpuUsage();
        run();
        const { user, system } = process.cpuUsage(began);
        best = Math.min(best, 1e3 * (user + system));
    }
    console.log(`${what}: ${(best / count).toFixed(2)}`);
}

report("stresses in an array, full sliding", () => rwedge.stresses(0.25, 0.3, 0, x, y), POINTS);
report("stresses in an array, partial slip", () => rwedge.stresses(0.25, 0.3, 0.5, x, y), POINTS);
report("stresses of a contact in an array", () => contact.stresses(x, y), POINTS);
report("elastic limit", () => rwedge.elastic_limit(0.25, friction, 0.3), CALLS);
report("pressure at many points", () => rwedge.pressure(0.25, near), POINTS);
