// SPDX-License-Identifier: GPL-3.0-or-later
// What the page computes, beside the tool: cases of each pad, numbers as they are pasted, refusals, verdicts, cycles of loads.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { test } from "node:test";
import { cycleOf } from "../src/answers/last_cycle.js";
import { constantFactorOf, factorOf, rwedge } from "../src/answers/library.js";
import { asCommand, asFretting, asPython } from "../src/export.js";
import { readNumber } from "../src/number.js";
import { findInput, solveHolding } from "../src/answers/solution.js";
import { fieldOf, gridOf, measures, valuesAt } from "../src/answers/stresses.js";
import { solveRows } from "../src/answers/tables.js";
import { convertedMaterial, convertedTable } from "../src/convert.js";
import { wordsOf } from "../src/units.js";
import { inputs } from "../src/answers/words.js";
import { readCase, writtenCase } from "../src/answers/case_file.js";
import { assertNear, chance, ofPads, optionsOf, parabola, rowsOf, usual } from "./shared.mjs";

const bodies = { E1: "210000", nu1: "0.3", theta_deg: "2", radius: "10", f: "0.3" };
const inchesOfMm = ["mm", "in"].map(wordsOf);
const swt = { name: "swt", isPlaneStress: false, material: "" };

const run = (args, input) => spawnSync(process.env.TOOL, args, { encoding: "utf8", input });

/** A command that the page shows, in the folder of what it names. */
const runCommand = (command, cwd) =>
    spawnSync("sh", ["-c", command.replace("rwedge", `'${process.env.TOOL}'`)], { encoding: "utf8", cwd });

/** What the tool says of a row of these texts. */
function toolError(texts) {
    const rows = [Object.keys(texts), Object.values(texts)].map((cells) => cells.join("\t"));
    const told = run(["solve", "--input", "-", "--format", "tsv"], `${rows.join("\n")}\n`).stdout.split("\n");
    const [names, cells] = told.map((line) => line.split("\t"));
    return cells[names.indexOf("error")];
}

test("a thousands comma in pasted rows is refused, not read as a decimal comma", () => {
    const { rows } = solveRows("P\tQ\n12,000\t1,200\n", { ...bodies, yield_stress: "900" }, ".");
    assert.match(rows[0].error, /^P 12,000: the normal force must be a number above 0; the decimal sign is a point/);
    assert.deepEqual(rows[0].values, []);
});

test("a thousands comma in a field is refused, a decimal comma is read", () => {
    const [{ input, text }] = solveHolding({ ...bodies, P: "12,000" }, ".").faults;
    assert.match(`${input}: ${text}`, /^P: .*the decimal sign is a point, or a comma that separates no thousands/);
    assert.equal(solveHolding({ ...bodies, P: "12,5" }, ".").inputs.P, 12.5);
    assert.equal(solveHolding({ ...bodies, P: "12,500" }, ",").inputs.P, 12.5);
});

test("under the decimal comma a point that may separate thousands is refused, another is read", () => {
    const [{ input, text }] = solveHolding({ ...bodies, P: "1.900" }, ",").faults;
    assert.match(`${input}: ${text}`, /^P: P 1\.900: .*the decimal sign is a comma/);
    assert.equal(readNumber("1.900", ","), NaN);
    assert.equal(readNumber("1.900", "."), 1.9);
    for (const [typed, P] of [["1.9", 1.9], ["1900.125", 1900.125], ["1,900", 1.9]])
        assert.deepEqual([solveHolding({ ...bodies, P: typed }, ",").inputs.P, readNumber(typed, ",")], [P, P]);
    const loads = "P\tQ\n300\t20\n300\t-20\n";
    assert.match(cycleOf(bodies, loads, ",", "2", { ...swt, material: "sf\t1.900" }).complaint, /sf.*number/);
});

test("the decimal comma is read in pasted rows where it is chosen", () => {
    const texts = { ...bodies, yield_stress: "900" },
        told = solveRows("P\tQ\n300.5\t40.25\n", texts, ".");
    assert.deepEqual(solveRows("P;Q\n300,5;40,25\n", texts, ",").rows[0].values, told.rows[0].values);
    assert.ok(Number(told.rows[0].values[told.results.indexOf("safety")]) > 1);
});

test("a thousands comma, words and surplus cells in the loads of a cycle are refused; each line counts", () => {
    for (const [loads, complaint] of [
        ["P\tQ\n3,000\t1,000\n3,000\t-1,000\n", "line 2: P 3,000: must be a number, with a decimal point"],
        ["P,Q\n300,25,20,5\n300,75,-20,5\n", "line 2: 4 cells in this row, 2 in the header"],
        ["\r\n \nP Q\n300 20\n\n300 x\n", "line 6: Q x: must be a number, with a decimal point"],
        ["\n\n300\t20\n300\tx\n", "line 4: Q x: must be a number, with a decimal point"],
    ])
        assert.equal(cycleOf(bodies, loads, ".", "3", swt).complaint, complaint);
});

test("a column that nearly has an input's name is refused, though the form gives the input", () => {
    for (const name of ["Q / N", "Q [N/mm]", "Q in N", "Q_N", "mu"]) {
        const { complaint } = solveRows(`P\t${name}\n300\t80\n`, { ...usual }, ".");
        assert.match(complaint, new RegExp(`^column '${name.replace(/[[\]/]/g, "\\$&")}': `), name);
    }
});

test("columns that are not used are named once, above the rows", () => {
    const solved = solveRows("P\tT\n300\t80\n", usual, ".");
    assert.equal(solved.unused, "columns with numbers that are not used: 'T'");
    assert.ok(!solved.rows[0].values.at(-1).includes("not used"));
    assert.equal(cycleOf(bodies, "P\tQ\tT\n300\t20\t7\n300\t-20\t7\n", ".", "3", swt).unused, solved.unused);
});

test("an empty cell, too few cells and misplaced quotes cost their row alone", () => {
    const { rows } = solveRows('case,P,Q\nfirst,300,\nsecond,300\n"third"x,300,20\nlast,300,20\n', usual, ".");
    assert.deepEqual(
        rows.map(({ error }) => error),
        ["Q: the cell is empty", "2 cells in this row, 3 in the header", "misplaced quotes", ""],
    );
});

/** The results and the sentence on strength, by the page and by the command that it shows. */
function assertTold(pad, texts, folder) {
    const options = optionsOf("profile" in texts ? { ...texts, profile: `${folder}/profile.csv` } : texts),
        how = ["--verdict", "--format", "json", "--digits", "17"],
        told = run(["solve", ...options, "--yield-factor", ...how]);
    const { results, verdict, ...model } = solveHolding(texts, "."),
        all = JSON.parse(told.stdout),
        numbers = all.filter(({ value }) => typeof value === "number");
    for (const { quantity, value } of numbers) assertNear(results[quantity], value, 2e-13, `${options}: ${quantity}`);
    assert.ok(numbers.length > 12 && told.stderr.endsWith(`${verdict.strength}\n`), told.stderr);
    assert.equal(results.warnings ?? "", all.find(({ quantity }) => quantity === "warnings").value ?? "");
    const command = asCommand({ ...model, texts });
    assert.equal(runCommand(`${command} ${how.join(" ")}`, folder).stdout, told.stdout, command);
    return { ...model, pad, results };
}

/** What the program prints, a name and a number a line, where the package for Python is built. */
function assertPrinted(model) {
    const { stdout, stderr } = spawnSync(process.env.PYTHON, ["-c", asPython(model)], { encoding: "utf8" }),
        lines = [...stdout.matchAll(/^(\w+) (.+)$/gm)];
    assert.ok(lines.length >= 6, stderr);
    for (const [line, name, value] of lines) assertNear(value, model.results[name], 1e-9, `${model.pad}: ${line}`);
}

/** Of a wedge: each way to give an input, other materials, each load. */
const ofWedge = [
    { theta: undefined, theta_deg: "1.5", sigma: "12" },
    { a: undefined, radius: "4", M: "3" },
    { theta: undefined, theta_deg: "0.3", a: undefined, radius: "40", k: undefined, yield_stress: "700" },
    { a: "0", Q: "-30", M: "0.5" },
    { E2: "70000", nu2: "0.33", P: "1300", Q: "200", similar: "yes" },
    { E2: "inf", nu2: "0.3", M: "2", sigma: "5", k: "150", similar: "yes" },
    { f: "0", Q: "0", nu1: "0.45" },
    { f: "0.75", Q: "-200", sigma: "-9" },
].map((more) => JSON.parse(JSON.stringify({ ...ofPads.wedge, ...more })));

test("cases of each pad and each input have the tool's results; so have their commands and programs", () => {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`);
    writeFileSync(`${folder}/profile.csv`, ofPads.profile.profile);
    for (const [pad, texts] of Object.entries(ofPads)) {
        const model = assertTold(pad, texts, folder);
        if (process.env.PYTHON) assertPrinted(model);
    }
    for (const texts of ofWedge) assertTold("wedge", texts, folder);
    rmSync(folder, { recursive: true });
});

/** Texts by chance: of each pad, with the ways to give an input, units, a width, plane stress, a tilt. */
function caseByChance(next, i) {
    const size = (least, most) => (least * (most / least) ** next()).toPrecision(4),
        one = (...ways) => ways[Math.floor(next() * ways.length)],
        radius = size(5, 50);
    const pad = [
        { theta: size(0.005, 0.05), a: size(0.01, 0.5) },
        { theta_deg: size(0.3, 3), radius },
        { radius },
        { radius1: radius, radius2: size(60, 90) },
        { flat: size(0.1, 1), radius },
        { profile: rowsOf(parabola), ...one({}, { hull: "yes" }, { origin: "lowest" }) },
    ][i % 6];
    const f = size(0.1, 0.6),
        P = size(50, 400),
        width = one("", "", "8"),
        section = one("", "80"),
        ofWidth = (load) => String(width ? load * Number(width) : load);
    return {
        ...pad,
        ...one({ E1: "210000" }, { E1: "210 GPa" }),
        nu1: "0.3",
        ...one({}, { E2: "70000", nu2: "0.33", similar: "yes" }, { E2: "inf", similar: "yes" }),
        f,
        P: ofWidth(Number(P)),
        Q: ofWidth(0.7 * Number(f) * Number(P) * (2 * next() - 1)),
        ...one({}, { M: ofWidth(Number(P) * 0.01) }, { tilt: "1e-4" }, { sigma: size(1, 20) }, { sigma: section ? "900" : "9" }),
        ...one({ k: "400" }, { yield_stress: "0.7 GPa" }, {}),
        units: "mm,N,MPa",
        ...(width && { width }),
        ...(section && { section }),
        ...one({}, {}, { plane_stress: "stress" }),
    };
}

const inPython = `import sys, rwedge
for name in sys.argv[1:]:
    case = rwedge.read_case(name)
    contact, loads = case.contact(), case.loads
    contact.apply(loads["P"], loads.get("M", 0), 0, 0)
    contact.apply(loads["P"], loads.get("M", 0), loads.get("Q", 0), loads.get("sigma", 0))
    print(*contact.edges, contact.stick_half_width)
`;

test("forty cases by chance go from the page to a file, to the tool, to Python, and back, with the same numbers", () => {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`),
        next = chance(17),
        answers = [];
    for (let i = 0; i < 40; i++) {
        const texts = caseByChance(next, i),
            { results, verdict } = solveHolding(texts, "."),
            about = `${JSON.stringify(texts)}: ${verdict?.text}`;
        assert.ok(results, about);
        const file = writtenCase({ name: `case ${i}`, texts, sign: ".", material: "su\t900", settings: { digits: "6" } });
        writeFileSync(`${folder}/${i}.json`, file);
        const told = run(["solve", "--case", `${folder}/${i}.json`, "--format", "json", "--digits", "17"]);
        assert.equal(told.status, 0, `${about}: ${told.stderr}`);
        const numbers = JSON.parse(told.stdout).filter(({ value }) => typeof value === "number");
        const width = results.right - results.left;
        for (const { quantity, value } of numbers) {
            const isEdge = /^(left|right|stick_left|stick_right|p0_x)$/.test(quantity),
                isTop = /^yield_[xy]$/.test(quantity), // flat there: its place is that of a search, to about 1e-7
                least = (isTop ? 1e-7 : isEdge ? 1e-9 : 0) * width;
            const side = quantity === "p0_x" ? Math.abs : Number; // a flat pad has two equal peaks
            assert.ok(Math.abs(side(results[quantity]) - side(value)) <= 2e-11 * Math.abs(value) + least, `${about}: ${quantity}: ${results[quantity]}, not ${value}`);
        }
        const { units, width: total, section, plane, rotation, name, digits, material, ...read } = readCase(file, String),
            others = { ...(total && { width: total }), ...(section && { section }), ...(plane && { plane_stress: plane }), ...(rotation === "similar" && { similar: "yes" }) },
            again = solveHolding({ ...read, units, ...others }, ".");
        for (const quantity of ["b", "p0", "left", "right", "c", "tilt", "max_tension"])
            if (results[quantity] !== null)
                assert.ok(Math.abs(again.results[quantity] - results[quantity]) <= 1e-12 * Math.max(Math.abs(results[quantity]), width), `${about}: again: ${quantity}`);
        assert.deepEqual([name, digits, JSON.parse(material)], [`case ${i}`, "6", { su: 900 }]);
        answers.push(results);
    }
    if (process.env.PYTHON) {
        const { stdout, stderr } = spawnSync(process.env.PYTHON, ["-c", inPython, ...answers.map((_, i) => `${folder}/${i}.json`)],
            { encoding: "utf8", env: { ...process.env, RWEDGE_TOOL: process.env.TOOL } });
        const lines = stdout.trim().split("\n").map((line) => line.split(" ").map(Number));
        assert.equal(lines.length, 40, stderr);
        lines.forEach(([left, right, c], i) => {
            const { left: l, right: r, c: zone } = answers[i];
            assert.ok(Math.abs(left - l) + Math.abs(right - r) <= 1e-9 * (r - l), `edges of case ${i}`);
            if (zone !== null) assert.ok(Math.abs(c - zone) <= 1e-6 * (r - l), `stick zone of case ${i}: ${c}, not ${zone}`);
        });
    }
    rmSync(folder, { recursive: true });
});

test("the strength of the pad is the tool's; what has a side is refused; cycles and rows are of the half-plane", () => {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`),
        bodies2 = { E2: "70000", nu2: "0.33", similar: "yes", strength_of: "2" };
    for (const [pad, k] of [["wedge", "100"], ["cylinder", "900"], ["flat", "30"]]) {
        const texts = { ...ofPads[pad], ...bodies2, k },
            { strength_of, ...ofTool } = texts,
            { results, hardest, verdict, ...model } = solveHolding(texts, "."),
            how = ["--verdict", "--format", "json", "--digits", "17"];
        const told = run(["solve", ...optionsOf(ofTool), "--strength-of", "2", "--yield-factor", ...how]);
        for (const { quantity, value } of JSON.parse(told.stdout))
            if (typeof value === "number") assertNear(results[quantity], value, 2e-13, `${pad}: ${quantity}`);
        assert.ok(told.stderr.endsWith(`${verdict.strength}\n`) && /^The strength of body 2/.test(verdict.strength), told.stderr);
        assert.equal(runCommand(`${asCommand({ ...model, texts })} ${how.join(" ")}`, folder).stdout, told.stdout);
        assert.ok(hardest.y < 0 || Math.abs(hardest.y) < 1e-9, `${pad}: yields at ${hardest.y}`);
        const there = valuesAt({ ...model, contact: model.contact }, { x: hardest.x, y: -hardest.y });
        assertNear(there.von_mises, hardest.von_mises, 1e-9, `${pad}: the stress where it yields`);
        if (process.env.PYTHON) assertPrinted({ ...model, texts, pad, results });
        const file = writtenCase({ name: "", texts, sign: ".", material: "", settings: {} });
        writeFileSync(`${folder}/pad.json`, file);
        const again = JSON.parse(run(["solve", "--case", `${folder}/pad.json`, "--yield-factor", "--format", "json", "--digits", "17"]).stdout);
        assertNear(again.find(({ quantity }) => quantity === "yield_factor").value, results.yield_factor, 2e-13, `${pad}: by its file`);
        assert.equal(readCase(file, String).body, "2");
    }
    for (const [more, words] of [[{ sigma: "5" }, /^the strength of the pad: not with sigma; allowed/], [{ E2: "inf" }, /^the strength of the pad: body 2 is rigid/]]) {
        const { faults, verdict } = solveHolding({ ...usual, ...bodies2, ...more }, ".");
        assert.match(faults[0].text, words);
        assert.equal(verdict.colour, "red");
    }
    const { strength_of, ...ofHalfPlane } = bodies2,
        { k, ...others } = usual,
        loads = "P,Q\n190,20\n190,-20";
    assert.deepEqual(cycleOf({ ...usual, ...bodies2 }, loads, ".", "3", swt).worst, cycleOf({ ...others, ...ofHalfPlane }, loads, ".", "3", swt).worst);
    assert.deepEqual(solveRows("P\n190\n", { ...usual, ...bodies2 }, ".").rows, solveRows("P\n190\n", { ...others, ...ofHalfPlane }, ".").rows);
    for (const name of ["radius", "P", "f"]) {
        const swapped = { ...usual, E1: bodies2.E2, nu1: bodies2.nu2, E2: usual.E1, nu2: usual.nu1, similar: "yes" };
        assertNear(findInput({ ...usual, ...bodies2 }, ".", name, 1.5).value, findInput(swapped, ".", name, 1.5).value, 1e-12, name);
    }
    rmSync(folder, { recursive: true });
});

test("a log of a case goes to a file and back; the tool has its cycle", () => {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`),
        pasted = "Rig 7\nlogged by hand\n\nTime;P;Q\ns;kN;N\n0;1,6;160\n1;1,6;-160\n2;1,28;80\n",
        texts = { ...usual, P: "1600", Q: "0", units: "mm,N,MPa", width: "8" },
        cycle = cycleOf(texts, pasted, ",", "3", swt);
    assert.equal(cycle.complaint, undefined);
    assert.deepEqual(cycle.loads.map(({ P, Q }) => [P, Q]), [[200, 20], [200, -20], [160, 10]]);
    const file = writtenCase({ name: "", texts, sign: ".", material: "", loads: cycle.loads, settings: {} });
    writeFileSync(`${folder}/log.json`, file);
    const told = run(["fretting", "--case", `${folder}/log.json`, "--at-worst", "--format", "json"]);
    assertNear(JSON.parse(told.stdout).find(({ measure }) => measure === "swt").value, cycle.worst.swt.value, 1e-11, told.stderr);
    const { loads, tab } = readCase(file, String);
    assert.deepEqual([tab, loads.split("\n").length], ["cycle", 4]);
    assert.equal(cycleOf(texts, loads, ".", "3", swt).worst.swt.value, cycle.worst.swt.value);
    rmSync(folder, { recursive: true });
});

test("twenty thousand digits are refused at once", () => {
    const began = Date.now();
    assert.ok(Number.isNaN(readNumber("1".repeat(20000) + "x", ".")));
    assert.equal(solveHolding({ ...usual, P: "9".repeat(20000) }, ".").verdict.colour, "red");
    assert.ok(Date.now() - began < 500);
});

const wrong = {
    E1: ["-1", "inf"],
    nu1: ["0.6"],
    E2: ["70000"],
    theta: ["2"],
    a: ["-0.1"],
    P: ["0"],
    M: ["1.2.3", "1e12"],
    Q: ["20 N", "50"],
    f: ["-0.1"],
    k: ["1e61"],
};

test("refusals are the tool's", () => {
    for (const [name, texts] of Object.entries(wrong))
        for (const text of texts) {
            const all = { ...usual, [name]: text },
                faults = solveHolding(all, ".").faults.map((fault) => fault.text);
            const told = toolError(all).replace("--units, such as --units mm,N,MPa, converts it", "Units above must name those of the numbers").replace(/ --(?=[A-Z])/g, " ");
            assert.deepEqual(faults, [told], `${name} = ${text}`);
        }
    const tiny = { ...bodies, P: "1e-58", M: "1e-59" }; // refused by the library, with no input at fault
    assert.equal(solveHolding(tiny, ".").faults[0].text, toolError(tiny));
});

test("all wrong fields are named at a time", () => {
    const { faults, verdict } = solveHolding({ ...usual, P: "x", f: "y" }, ".");
    assert.deepEqual(
        faults.map((fault) => fault.input),
        ["P", "f"],
    );
    assert.ok(verdict.text.startsWith("CHECK THE INPUTS: P x: ") && verdict.text.includes("; f y: "));
});

test("what is doubtful, missing or too much is the verdict", () => {
    for (const [texts, tone, words] of [
        [{ k: "900" }, "green", /^OK$/],
        [{ k: "330" }, "amber", /^CAUTION: .*full sliding; under these loads it does not yield$/],
        [{ k: "" }, "amber", /^CAUTION: no yield stress is given, so there is no safety/],
        [{ E2: "70000", nu2: "0.3", similar: "yes" }, "amber", /CAUTION: Dundurs' beta is not 0/],
        [{ E2: "70000", nu2: "0.3" }, "red", /^CHECK THE INPUTS: unlike bodies, .* must be said; choose it below the friction$/],
        [{ k: "250" }, "red", /^YIELDS: the stress under these loads/],
        [{ k: "250", theta: "0.5" }, "red", /^YIELDS: .* CAUTION: theta is above 0.1 rad/],
        [{ P: "" }, "red", /^CHECK THE INPUTS: missing: P/],
        [{ Q: "50" }, "red", /^SLIDES: Q is above f P, there is no equilibrium\./],
        [{ M: "1e12" }, "red", /in magnitude: more lays a flank on the surface/],
        [{ sigma: "5000" }, "red", /computed numerically: tractions to about/],
        [{ sigma: "500", k: "900" }, "green", /^OK; computed numerically: tractions to about \S+ of f p0$/],
        [{ sigma: "500", k: "" }, "amber", /^CAUTION: no yield stress is given, .*; computed numerically: /],
    ]) {
        const { colour, text } = solveHolding({ ...usual, ...texts }, ".").verdict;
        assert.match(text, words);
        assert.equal(colour, tone, text);
    }
});

test("the sentence on strength has the unit and the decimal sign", () => {
    const { strength, factor } = solveHolding(usual, ",", "mm").verdict;
    assert.match(strength, /factor of \d,\d+ on the stress, of \d,\d+ if it slid; .*, y = \d,\d+ mm, below/);
    assert.equal(factor, solveHolding(usual, ".").results.yield_factor);
    assert.equal(solveHolding({ ...usual, k: "" }, ".").verdict.factor, null);
});

test("a profile is read with tabs, spaces or decimal commas, with names or as x and height", () => {
    const { theta, a, ...rest } = usual;
    const width = (between, head, sign) => {
        const lines = parabola.map((row) => row.map((cell) => String(cell).replace(".", sign)).join(between));
        const { results, verdict } = solveHolding({ ...rest, profile: [...head, ...lines].join("\n") }, sign);
        return results?.b ?? verdict.text;
    };
    const b = width(",", ["x,height"], ".");
    assertNear(b, solveHolding({ ...rest, radius: "10" }, ".").results.b, 0.02, "b");
    for (const pasted of [width("\t", ["x\theight"], "."), width(" ", [], "."), width(";", ["x;height"], ",")])
        assert.equal(pasted, b);
    assert.match(width(",", ["x,depth"], "."), /^CHECK THE INPUTS: profile .*column slope: missing/);
});

test("what is wrong with a profile has its line as pasted, with names or without; each line counts", () => {
    const { theta, a, ...rest } = usual,
        rows = ["-1 0.05", "-0.5 0.0125", "0 0", "0.5 0.0125", "1 0.05"];
    for (const before of [[], ["x height"], ["", " "], ["", "x height", ""]])
        for (const [row, words, line = 3] of [
            ["0 x", "height x: must be a number"],
            ["0 0 0", "3 cells in this row"],
            ["-0.7 0", "height 0.0125: not convex at 1 place", 2], // places may come in any order
            ['0 "0"x', "misplaced quotes"],
        ])
            for (const end of ["\n", "\r\n"]) {
                const profile = [...before, ...rows.with(2, row)].join(end),
                    { text } = solveHolding({ ...rest, profile }, ".").faults[0];
                assert.ok(text.includes(`: line ${before.length + line}: ${words}`), `${profile}: ${text}`);
            }
    const first = solveHolding({ ...rest, profile: rows.with(0, "-1 x").join("\n") }, ".").faults[0];
    assert.ok(first.text.includes(": line 1: height x: "), first.text);
});

test("rows of flat pads take nothing of the wedge of the form", () => {
    const { theta, a, ...rest } = usual,
        { rows, results } = solveRows("flat\tradius\n0.5\t10\n", usual, ".");
    const alone = solveHolding({ ...rest, flat: "0.5", radius: "10" }, ".");
    assert.equal(Number(rows[0].values[results.indexOf("b")]), alone.results.b, rows[0].error);
});

test("constants of a material are read as lines or JSON; what is unknown is named", () => {
    const read = (material, sign, name = "mcdiarmid") => cycleOf(usual, "", sign, "3", { ...swt, name, material });
    for (const text of ["su\t500\nt_A, 150.5\nsource,a paper", '{"su": 500, "t_A": 150.5, "name": "x\\ny"}'])
        assert.deepEqual(read(text, ".").criterion.constants, { t_A: 150.5, su: 500 });
    assert.deepEqual(read("su;500\nt_A = 150,5", ",").criterion.constants, { t_A: 150.5, su: 500 });
    assert.equal(read("limit 1", ".").complaint, "limit: no constant that is known here");
    assert.equal(read('{"kap\\npa": 1}', ".").complaint, "kap: no constant that is known here; the nearest is kappa");
    assert.equal(read("kappa x", ".").complaint, "kappa x: must be a number");
    assert.equal(read("su 500", ".").complaint, "McDiarmid needs t_A of the material");
    assert.match(read("{", ".").complaint, /^the material: /);
    assert.match(read("dang_van_alpha -1", ".", "dang_van").complaint, /must be a number, 0, or 1e-60 to 1e60/);
});

test("pasted tables go from one set of units to another, each column by its own dimension", () => {
    const inInches = (name) => factorOf(...inchesOfMm, inputs[name]?.unit);
    const [P, M, sigma] = ["P", "M", "sigma"].map(inInches);
    assertNear(P, 25.4 / 4.4482216152605, 1e-14, "N/mm in lbf/in");
    assertNear(M, 1 / 4.4482216152605, 1e-14, "N in lbf");
    assertNear(sigma, 25.4 ** 2 / 4.4482216152605, 1e-14, "MPa in psi");
    const numbersOf = (text) => text.split("\n").map((line) => line.split(/[\t;, ]+/).map(Number));
    for (const [text, sign] of [["t\tP\tM\tsigma\n1\t100\t2.5\t-30\n", "."], ["t,P,M,sigma\n1,100,2.5,-30", "."], ["t;P;M;sigma\n1;100;2,5;-30", ","], ["t P M sigma\n1 100 2.5 -30", "."]]) {
        const [, row] = numbersOf(convertedTable(text, [], inInches, sign).replaceAll(sign === "," ? "," : "none", "."));
        [1, 100 * P, 2.5 * M, -30 * sigma].forEach((value, i) => assertNear(row[i], value, 1e-11, text));
    }
    assert.equal(convertedTable("# by hand\nP [kN/mm],Q\n3,x\n", [], inInches, "."), "# by hand\nP [kN/mm],Q\n3,x\n");
    assert.equal(convertedTable("1 2\n3 4", ["x", "height"], () => 10, "."), "10 20\n30 40");
});

test("constants go from one set of units to another, but for those that have their own", () => {
    const psi = 25.4 ** 2 / 4.4482216152605, // of an MPa
        K = psi / Math.sqrt(25.4), // psi sqrt(in), of an MPa sqrt(mm)
        inInches = (...of) => constantFactorOf(...inchesOfMm, ...of);
    assertNear(inInches("sf", ""), psi, 1e-14, "MPa in psi");
    assertNear(inInches("dK_th", ""), K, 1e-14, "a stress intensity");
    assertNear(inInches("paris_C", "3"), 1 / 25.4 / K ** 3, 1e-13, "the growth of a crack");
    for (const [name, exponent] of [["findley_k", ""], ["paris_C", "x"], ["unknown", ""]])
        assert.equal(inInches(name, exponent), 1, name);
    const ofMaterial = (name, m) => ({ sf: 145, paris_C: 10 ** -m })[name] ?? 1,
        converted = (text, sign = ".") => convertedMaterial(text, ofMaterial, sign);
    assert.equal(converted("sf\t2\nk = 0.3\nsource\ta paper 5"), "sf\t290\nk = 0.3\nsource\ta paper 5");
    assert.equal(converted("sf,2 MPa\nsf;2"), "sf,2 MPa\nsf;290");
    assert.equal(converted("paris_C;500\nparis_m;2,5", ","), `paris_C;${String(500 * 10 ** -2.5).slice(0, 13).replace(".", ",")}\nparis_m;2,5`);
    assert.deepEqual(JSON.parse(converted('{"sf": 2, "k": 0.3, "su": "2 MPa"}')), { sf: 290, k: 0.3, su: "2 MPa" });
    for (const text of ['{"units": "m,N,Pa", "sf": 2}', "units;m,N,Pa\nsf;2"]) assert.equal(converted(text), text);
});

test("constants have their units, as in the tool", () => {
    const valueOf = (material, units = "mm,N,MPa") =>
        cycleOf(usual, "", ".", "3", { ...swt, name: "mcdiarmid", material, units });
    for (const text of ["su 0.5 GPa\nt_A 150500000 Pa", '{"su": "500 MPa", "t_A": 150.5}', "units,m,N,Pa\nsu,5e8\nt_A,1.505e8"])
        assert.deepEqual(valueOf(text).criterion?.constants, { t_A: 150.5, su: 500 }, `${text}: ${valueOf(text).complaint}`);
    assert.match(valueOf("su 5 GPa", "length,force,stress").complaint, /^su 5 GPa: has the unit 'GPa', and no working units/);
    assert.match(valueOf("su 5 mm").complaint, /^su 5 mm: the unit 'mm' has the wrong dimension/);
    assert.match(valueOf("dK_th 4.2").complaint, /^dK_th 4.2: needs its unit, such as "4.2 MPa sqrt\(m\)"/);
});

test("a field and the hardest place have the stresses of their places", () => {
    const model = solveHolding(usual, "."),
        grid = gridOf(model.results, false),
        i = 200 * 20 + 131;
    for (const measure of Object.keys(measures)) {
        const told = valuesAt(model, { x: grid.x[i], y: grid.y[i] })[measure];
        assertNear(fieldOf(model, grid, measure).values[i], told, 1e-12, measure);
    }
    assertNear(valuesAt(model, model.hardest).von_mises, model.hardest.von_mises, 1e-12, "the hardest");
});

test("what gives a safety is what the tool finds", () => {
    for (const name of ["radius", "a", "P", "f"]) {
        const texts = { ...usual };
        delete texts[{ radius: "a" }[name] ?? name];
        const told = run(["solve", ...optionsOf(texts), "--for", name, "--safety", "1.5"]).stdout;
        assertNear(findInput(usual, ".", name, 1.5).value, Number(told.match(`\n${name},([^,]*)`)[1]), 1e-12, name);
    }
    assert.match(findInput(usual, ".", "f", 9).complaint, /^no solution: even without friction the safety is \d/);
});

test("converted to other units a case is the same", () => {
    const inInches = ([name, text]) => [name, String(text * factorOf(...inchesOfMm, inputs[name].unit))],
        inches = Object.fromEntries(Object.entries(usual).map(inInches));
    const [here, there] = [usual, inches].map((texts) => solveHolding(texts, ".").results);
    for (const name of ["safety", "yield_factor", "a_over_b", "c_over_b"])
        assertNear(there[name], here[name], 1e-12, name);
    assertNear(there.b * 25.4, here.b, 1e-12, "b");
    assertNear(there.p0 * 0.006894757293168361, here.p0, 1e-12, "p0");
    assert.equal(factorOf(wordsOf("mm"), wordsOf("any"), "length"), 1);
});

test("bodies of two materials under tension: body 1 is stretched by its own compliance", () => {
    const pad = { E2: "inf", theta: ".1", radius: "100" },
        texts = { E1: "10", nu1: ".5", ...pad, P: "1", Q: ".2", f: ".5", sigma: ".04" };
    const answer = solveHolding(texts, "."),
        { results } = answer;
    assert.match(asPython({ ...answer, pad: "wedge" }), /^contact\.set_strain\(\(1 - nu1\*\*2\) \/ E1\)/m);
    assertNear((results.stick_left + results.stick_right) / 2, 0.6, 1e-6, "R strain sigma/f");
});

test("unlike bodies with friction: partial slip is the tool's; a case, a command and a program keep the rotation", () => {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`),
        texts = { ...ofPads.cylinder, E2: "70000", nu2: "0.33", P: "300", Q: "40", f: "0.3", rotation: "held" },
        { results, verdict, ...model } = solveHolding(texts, "."),
        told = run(["solve", ...optionsOf(texts), "--format", "json", "--digits", "17"]);
    assert.match(verdict.text, /unlike bodies: the contact swings by/);
    for (const { quantity, value } of JSON.parse(told.stdout))
        if (["b", "left", "right", "moment", "mu", "swing", "stick_left", "stick_right", "P_yield"].includes(quantity) && typeof value === "number")
            assert.ok(Math.abs(results[quantity] - value) <= 1e-3 * Math.max(Math.abs(value), results.b), `${quantity}: ${results[quantity]}, not ${value}`);
    const file = writtenCase({ name: "", texts, sign: ".", material: "", settings: {} });
    assert.equal(readCase(file, String).rotation, "held");
    writeFileSync(`${folder}/case.json`, file);
    const again = JSON.parse(run(["solve", "--case", `${folder}/case.json`, "--format", "json", "--digits", "17"]).stdout);
    assert.deepEqual(again, JSON.parse(told.stdout));
    assert.match(asCommand({ ...model, texts }), / --rotation held( |$)/);
    assert.match(asPython({ ...model, texts, pad: "cylinder" }), /^contact\.set_beta\(beta\).*\ncontact\.allow_error\(1e-3\)\ncontact\.set_rotation\(1\)/m);
    const slides = { ...texts, Q: "90" },
        sliding = solveHolding(slides, "."),
        ofSliding = JSON.parse(run(["solve", ...optionsOf(slides), "--format", "json", "--digits", "17"]).stdout);
    for (const { quantity, value } of ofSliding)
        if (["b", "left", "right", "moment", "swing", "max_tension", "P_yield", "P_shakedown"].includes(quantity) && typeof value === "number")
            assertNear(sliding.results[quantity], value, 1e-10, quantity);
    if (process.env.PYTHON) assertPrinted({ ...sliding, texts: slides, pad: "cylinder" });
    const loads = "P,Q\n300,0\n300,40\n300,-40\n";
    assert.equal(cycleOf(texts, loads, ".", "1", swt).complaint, undefined);
    assert.equal(cycleOf(texts, "P,M,Q\n300,1,0\n300,1,40\n", ".", "1", swt).complaint, "line 2: M 1: of a pad that is held M is a result");
    rmSync(folder, { recursive: true });
});

test("a crack has the tool's ranges, threshold, verdict and sentence", () => {
    const texts = { E1: "72100", nu1: "0.33", radius: "60", f: "0.6", P: "120" },
        loads = "P,Q,sigma\n120,65,50\n120,0,0\n120,-65,-50\n120,0,0\n",
        material = "dK_th 2.1 MPa sqrt(m)\nds0 248\nparis_C 1e-7 mm/(MPa sqrt(m))^3\nparis_m 3",
        crack = { edge: "left", angle: "0", from: "0.02", to: "3", unit: "mm" };
    const { crack: found, complaint } = cycleOf(texts, loads, ".", "3", { ...swt, material, units: "mm,N,MPa" }, crack);
    assert.equal(complaint ?? found.complaint, undefined);
    const law = "--dK-th 2.1 --ds0 248 --C 1e-7 --m 3 --K-in m --units mm,N,MPa".split(" "),
        how = ["--edge", "left", "--format", "json", "--digits", "17"],
        lengths = ["--lengths", found.length.join()];
    const tool = (...more) => run(["crack", "-", ...optionsOf({ E1: "72100", nu1: "0.33", radius: "60", f: "0.6" }), ...law, ...how, ...more], loads);
    for (const row of JSON.parse(tool(...lengths).stdout)) {
        const j = found.length.findIndex((length) => Math.abs(length / row.length - 1) < 1e-12);
        assertNear(found.threshold[j], row.threshold, 1e-12, `threshold at ${row.length}`);
        assertNear(found.dK[row.shear][j], row.closing_dK, 1e-10, `${row.shear} at ${row.length}`);
    }
    const told = tool("--from", "0.02", "--to", "3", "--verdict");
    for (const { shear, arrest_length, cycles, least_ratio } of JSON.parse(told.stdout)) {
        const { arrest, cycles: life, least } = found.verdict[shear];
        for (const [name, value, expected] of [["arrest", arrest, arrest_length], ["cycles", life, cycles], ["least", least, least_ratio]])
            if (typeof expected === "number") assertNear(value, expected, 1e-8, `${shear}: ${name}`);
    }
    assert.equal(told.stderr.split("\n")[0], `rwedge crack: ${found.sentence}.`);
    assert.match(found.doubt, /^the contact is taken as if there were no crack/);
});

test("a crack is refused with what is wrong: a K without its unit, lengths, lonely constants", () => {
    const crack = { edge: "left", angle: "0", from: "0.02", to: "3", unit: "mm" };
    const told = (material, more = {}, units = "mm,N,MPa") => {
        const answer = cycleOf(usual, "", ".", "3", { ...swt, material, units }, { ...crack, ...more });
        return answer.complaint ?? answer.crack.complaint;
    };
    for (const [material, more, words] of [
        ["dK_th 66", {}, /^dK_th 66: needs its unit, such as "4.2 MPa sqrt\(m\)"/],
        ["paris_m 3", {}, /^paris_C: missing; needed beside paris_m/],
        ["ds0 248", {}, /^dK_th: missing; needed beside ds0/],
        ["", { to: "0.01" }, /^the last length must be above the first/],
        ["", { from: "x" }, /^the first length x: must be a number/],
        ["", { angle: "80" }, /^the angle 80: must be a number from -75 to 75/],
    ])
        assert.match(told(material, more), words);
    assert.match(told("dK_th 2.1 MPa sqrt(m)", {}, ""), /no working units are known/);
    assert.equal(told(""), undefined);
    assert.equal(cycleOf(usual, "", ".", "3", swt).crack, null);
});

/** 1600 N on 8 mm, in gross slip both ways. */
const rig = "P [N];displacement [um]\n1600;0\n1600;2\n1600;-2\n1600;2\n",
    rigTexts = { ...usual, P: "1600", Q: "0", units: "mm,N,MPa", width: "8", compliance: "1e-6" };

test("a rig that prescribes displacements has the tool's forces, slip and energy, and its loop their area", () => {
    const cycle = cycleOf(rigTexts, rig, ".", "2", swt),
        { P, Q, width, units, compliance, ...bodiesAlone } = rigTexts,
        like = ["-", "--units", units, "--width", width, "--compliance", compliance, "--cycles", "2", ...optionsOf(bodiesAlone)],
        told = run(["fretting", ...like], rig.replaceAll(";", ",")).stderr,
        history = JSON.parse(run(["history", ...like, "--format", "json"], rig.replaceAll(";", ",")).stdout);
    for (const [line, name, value] of told.matchAll(/(\w+) (\S+) at x = /g)) assertNear(cycle.worst[name]?.value, Number(value), 5e-6, line);
    cycle.loads.forEach((load, i) => assertNear(load.Q + 1, history[4 + i].Q + 1, 1e-12, `Q of load ${i}`));
    assert.deepEqual(cycle.displacements, [0, 0.002, -0.002, 0.002]);
    assertNear(cycle.compliance, 8e-6, 1e-15, "per unit length");
    const { x, y, isDriven } = cycle.loop,
        area = x.reduce((sum, _, i) => sum + ((y[i] + y.at(i - 1)) / 2) * (x[i] - x.at(i - 1)), 0);
    assert.deepEqual([isDriven, x.length], [true, 96]);
    assertNear(area, history[7].energy - history[3].energy, 0.02, "a cycle of 96 states");
    const command = asFretting(solveHolding(rigTexts, "."), cycle, "2", true);
    assert.equal(runCommand(command).stderr.match(/energy_per_area \S+/)[0], told.match(/energy_per_area \S+/)[0], command);
});

test("the case of a rig goes to a file and back; the tool has its cycle", () => {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`),
        cycle = cycleOf(rigTexts, rig, ".", "3", swt),
        loads = cycle.loads.map((load, i) => ({ ...load, displacement: cycle.displacements[i] }));
    const file = writtenCase({ name: "", texts: rigTexts, sign: ".", material: "", loads, compliance: "1e-6", settings: {} });
    writeFileSync(`${folder}/rig.json`, file);
    const told = JSON.parse(run(["history", "--case", `${folder}/rig.json`, "--format", "json"]).stdout);
    told.forEach(({ Q }, i) => assertNear(Q + 1, cycleOf(rigTexts, rig, ".", "1", swt).loads[i].Q + 1, 1e-12, `Q of load ${i}`));
    const { loads: table, compliance, tab } = readCase(file, String);
    assert.deepEqual([tab, compliance, table.split("\n")[0]], ["cycle", "0.000001", "P\tM\tdisplacement\tsigma"]);
    assert.deepEqual(cycleOf(rigTexts, table, ".", "3", swt).worst, cycle.worst);
    rmSync(folder, { recursive: true });
});

test("what is missing or wrong of a rig is said", () => {
    const { compliance, ...noRig } = rigTexts,
        both = "P;displacement;Q\n1600;0;0\n1600;0,002;8\n",
        of = (more, loads, sign = ".") => cycleOf({ ...noRig, ...more }, loads, sign, "1", swt);
    for (const [more, loads, complaint] of [
        [{}, rig, /^column Q: missing; a displacement in its place needs the compliance of the rig$/],
        [{ compliance: "1e-6" }, "P,Q\n1600,1\n", /^column displacement: missing; with a compliance loads have it in place of Q/],
        [{ compliance: "-1" }, rig, /^the compliance of the rig must be a number not below 0$/],
        [{ compliance: "stiff" }, rig, /^the compliance of the rig must be a number, with a decimal point$/],
        [{ compliance: "1 N" }, rig, /^the compliance of the rig .*N/],
        [{ compliance: "1e-3 um/N", width: "" }, rig.replaceAll("[N]", "[N/mm]"), /is of the whole contact; needed: its width too$/],
    ])
        assert.match(of(more, loads).complaint ?? "", complaint);
    assert.equal(of({ compliance: "1e-3 um/N" }, rig).worst.swt.value, of({ compliance: "1e-6" }, rig).worst.swt.value);
    assert.match(of({ compliance: "1,0e-6" }, both, ",").unused, /column Q is not used: the displacement stands in its place/);
    assert.match(of({}, both, ",").unused, /displacement/);
});

test("a cycle, with a table or without, has the tool's worst places; so has its command", () => {
    for (const [more, loads] of [
        [{}, "P\tQ\n190\t20\n190\t-20"],
        [{}, "P,Q\n100,10\n150,20\n60,-10\n"],
        [{}, "P\tM\tQ\tsigma\n190\t2\t0\t0\n190\t2\t20\t0\n190\t2\t-20\t0"],
        [{}, ""],
        [{ M: "1" }, ""],
        [{ sigma: "10" }, ""],
        [{}, "P,Q,sigma\n190,20,0\n190,14,100\n190,-20,0\n190,-14,-100"], // a tension that lags has no closed form
    ]) {
        const texts = { ...usual, ...more },
            { P, M = "0", Q, sigma = "0", ...bodiesAlone } = texts;
        const table =
                loads.replaceAll("\t", ",") || `P,M,Q,sigma\n${P},${M},${Q},${sigma}\n${P},${M},-${Q},-${sigma}\n`,
            first = loads ? [] : ["--load", `${P},${M},0,0`];
        const told = run(["fretting", "-", ...first, ...optionsOf(bodiesAlone)], table).stderr,
            worst = [...told.matchAll(/(\w+) (\S+) at x = /g)];
        const answer = cycleOf(texts, loads, ".", "3", swt);
        assert.ok(worst.length >= 3, told);
        for (const [line, name, value] of worst) assertNear(answer.worst[name]?.value, Number(value), 5e-6, line);
        assert.equal(told.includes("computed numerically"), answer.computed !== "");
        assert.ok(told.includes(answer.computed), told);
        const command = asFretting(solveHolding(texts, "."), answer, "3", loads !== "");
        assert.equal(runCommand(command).stderr, told, command);
    }
    assert.match(cycleOf({ ...usual, Q: "0" }, "", ".", "3", swt).complaint, /both are 0$/);
});

test("a cycle tells the share of the loads that is done, up to 1", () => {
    const shares = [],
        hear = (share) => shares.push(share);
    cycleOf(usual, "P,Q\n190,20\n190,-20", ".", "4", swt, null, hear);
    assert.deepEqual(shares, [1, 2, 3, 4, 5, 6, 7, 8].map((done) => done / 8));
    shares.length = 0;
    const refused = cycleOf(usual, "P,Q\n190,20\n190,-2000", ".", "4", swt, null, hear);
    assert.match(refused.complaint, /^line 3: /);
    assert.deepEqual(shares, [1 / 8, 1]);
});

test("the loop of the whole contact encloses the energy of its cycle", () => {
    const { x, y } = cycleOf(usual, "", ".", "3", swt).loop,
        parts = Array.from(x, (_, i) => (i === 0 ? 0 : ((y[i] + y[i - 1]) / 2) * (x[i] - x[i - 1])));
    const contact = new rwedge.Contact(0.01, 0.05, rwedge.compliance(210000, 0.3, 210000, 0.3), 0.2);
    const energies = [0, 20, -20, 20].map((Q) => (contact.load(190, Q), contact.dissipated_energy()));
    const area = Math.abs(parts.reduce((sum, part) => sum + part));
    assertNear(area, energies[3] - energies[1], 2e-3, "of trapezia");
});

/** The answer on a criterion, which has the tool's worst value, safety and life; and the tool's row, of the verdicts. */
function assertVerdict(loads, name, material, ...plane) {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`),
        { P, Q, ...bodiesAlone } = usual;
    writeFileSync(`${folder}/material.csv`, material);
    const args = ["--material", `${folder}/material.csv`, "--at-worst", "--format", "json", ...plane],
        rows = JSON.parse(run(["fretting", "-", ...optionsOf(bodiesAlone), ...args], loads).stdout);
    rmSync(folder, { recursive: true });
    const told = rows.find((row) => row.measure === name),
        answer = cycleOf(usual, loads, ".", "3", { name, isPlaneStress: plane.length > 0, material });
    assertNear(answer.worst[name].value, told.value, 1e-9, name);
    for (const what of ["safety", "life"])
        if (typeof told[what] === "number") assertNear(answer[what], told[what], 1e-8, `${what} by ${name}: ${loads}`);
        else assert.equal(answer[what], told[what] === "inf" ? Infinity : null, name);
    return told;
}

const strainLife = "sf,1000\nb,-0.1\nef,0.5\nc,-0.6";

test("a criterion comes to what the tool says: the worst value, the safety against its limit, the life", () => {
    for (const verdict of [
        ["swt", `swt_limit,0.05\n${strainLife}`, "--plane-stress"],
        ["findley", "findley_k,0.3\nfindley_limit,200"],
        ["mcdiarmid", "t_A,150\nsu,800"],
        ["dang_van", "dang_van_alpha,0.3"],
    ])
        assertVerdict("P,Q\n190,20\n190,-20", ...verdict);
});

test("a life is the tool's passes of the loads: each cycle of a pass counts, but for run-outs", () => {
    const shearLife = "G,80769\ntf,600\nb0,-0.1\ngf,0.6\nc0,-0.6";
    for (const [loads, cycles] of [
        ["P,Q\n190,20\n190,-20", 1],
        ["P,Q\n190,20\n190,-20\n190,18\n190,-18", 2],
        ["P,Q\n190,20\n190,-20\n190,20\n190,-20\n190,20\n190,-20", 3],
        ["P,Q\n190,20\n120,-15\n160,10\n190,-20\n100,5", 2],
        ["P,M,Q,sigma\n190,2,20,5\n190,2,-20,-5\n190,2,10,0\n190,2,-15,0", 2],
    ])
        for (const verdict of [
            ["swt", strainLife],
            ["swt", `swt_limit,0.1\n${strainLife}`],
            ["swt", `swt_limit,5\n${strainLife}`, "--plane-stress"],
            ["fatemi_socie", shearLife],
        ])
            assert.equal(assertVerdict(loads, ...verdict).cycles, cycles, `${verdict}: ${loads}`);
});

test("the formulas with the numbers put in are those of the tool's report", () => {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`),
        { E1, nu1, f, k, theta, a, P, Q } = usual,
        file = { rwedge_case: 1, bodies: { E1: +E1, nu1: +nu1, f: +f, k: +k }, pad: { theta: +theta, a: +a }, loads: { P: +P, Q: +Q } };
    writeFileSync(`${folder}/case.json`, JSON.stringify(file));
    const told = run(["report", `${folder}/case.json`, "--equations"]).stdout,
        lines = [...told.matchAll(/^<p><b>(.*?)<\/b> = (.*?) = <code>(.*?)<\/code>/gm)].map(([, ...parts]) => parts),
        { equations, results } = solveHolding(usual, ".");
    rmSync(folder, { recursive: true });
    assert.ok(lines.length > 5, told);
    assert.deepEqual(equations.map(({ name, symbols, numbers }) => [name, symbols, numbers]), lines);
    assertNear(equations.find(({ name }) => name === "Q/(fP)").value, results.Q_over_fP, 1e-14, "Q/(fP)");
});
