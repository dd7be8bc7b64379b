// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the package beside those of the library in C, in one run: speed.mjs BENCH, which is tests/speed/bench. Fails where
// an array takes more than six times as long: WebAssembly has vectors of two numbers, a processor of up to eight.
import { spawnSync } from "node:child_process";
import * as rwedge from "rwedge";

const [bench] = process.argv.slice(2), POINTS = 20000, CALLS = 1000, TRIALS = 100, MOST = 6;
const x = Float64Array.from({ length: POINTS }, (_, i) => -2 + 4 * i / POINTS);
const y = Float64Array.from({ length: POINTS }, (_, i) => 0.01 + 2 * ((i * 7919) % POINTS) / POINTS);
const friction = Float64Array.from({ length: CALLS }, (_, i) => 0.1 + 1e-4 * i), near = x.map((place) => place / 3);
const contact = new rwedge.Contact(0.01, 0.5, 1.8e-5, 0.3);
contact.load(1000, 0);
contact.load(1000, 200);

/** By the names of bench: what does the same, and how many points or calls that is. */
const works = {
    "stress in an array, full sliding": [() => rwedge.stresses(0.3, 0.4, 0, x, y), POINTS],
    "stress in an array, partial slip": [() => rwedge.stresses(0.3, 0.4, 0.4, x, y), POINTS],
    "stress after P and then Q": [() => contact.stresses(x, y), POINTS],
    "elastic limit, in an array": [() => rwedge.elastic_limit(0.25, friction, 0.3), CALLS],
    "pressure": [() => rwedge.pressure(0.25, near), POINTS],
};

/** The shortest processor time, in ns. */
function timeOf([run, count]) {
    const times = Array.from({ length: TRIALS }, () => {
        const began = process.cpuUsage();
        run();
        const { user, system } = process.cpuUsage(began);
        return 1e3 * (user + system) / count;
    });
    return Math.min(...times);
}

const inC = (name) => Number(spawnSync(bench, [name], { encoding: "utf8" }).stdout.split(name)[1].trim().split(/\s/)[0]);

console.log("ns a point or call                            C  JavaScript");
for (const [name, work] of Object.entries(works)) {
    const [here, there] = [timeOf(work), inC(name)];
    console.log(name.padEnd(36), there.toFixed(1).padStart(10), here.toFixed(1).padStart(11));
    if (!(here < MOST * there) && name.includes("array")) {
        console.log(`FAILED: more than ${MOST} times as long`);
        process.exitCode = 1;
    }
}
