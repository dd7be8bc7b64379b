// SPDX-License-Identifier: GPL-3.0-or-later
// What the page promises, in one browser: each claim throws with what it found. It has a page; show() shows it with a case.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { cpus, loadavg, tmpdir } from "node:os";
import { dirname } from "node:path";
import { assertNear, chance, ofPads, optionsOf, parabola, rowsOf, usual } from "./shared.mjs";
import { enter, inEachScheme, openTab, pause, savedBy, seen, settled, shownNumbers, statusOf } from "./drive.mjs";

const tabs = ["contact", "stress", "strength", "cycle", "batch", "compare", "about"];
const idOf = (name) => `in-${{ theta_deg: "theta", radius: "a" }[name] ?? name}`;
const textOf = (page, selector) => page.$eval(selector, (part) => part.textContent);
const inTable = (rows, between = "\t") => rows.map((row) => row.join(between)).join("\n");

const run = (tool, args, input) => spawnSync(tool, args, { encoding: "utf8", input, maxBuffer: 1 << 28 });

/** What the tool says of a case, by name, to so many digits. */
function solvedBy(tool, texts, digits) {
    const told = run(tool, ["solve", ...optionsOf(texts), "--format", "json", "--digits", digits]).stdout;
    return Object.fromEntries(JSON.parse(told).map(({ quantity, value }) => [quantity, value]));
}

/** Sizes as far as they are allowed: an answer or a reason, and no error of the page (the claim about what is said would fail). */
export async function extreme_cases_have_an_answer_or_a_reason({ page, show }) {
    const next = chance(99);
    let answered = 0;
    for (let i = 0; i < 20; i++) {
        const some = (size) => ((i % 2 ? size : 1) * 10 ** ((i % 2 ? 12 : 120) * (next() - 0.5))).toPrecision(3);
        const texts = {
            ...usual,
            P: some(190),
            E1: some(210000),
            k: some(400),
            f: (2 * next()).toPrecision(2),
            Q: "0",
        };
        Object.assign(texts, { a: i % 9 ? some(0.05) : "0", M: i % 3 ? "" : some(2), sigma: i % 5 ? "" : some(20) });
        await show(texts);
        for (const tab of ["contact", "stress", "strength", "cycle"]) {
            await openTab(page, tab);
            await settled(page);
            const [colour, status] = await statusOf(page);
            assert.ok(status.length > 1, `${JSON.stringify(texts)}: no status`);
            if (!/red/.test(colour) && (await textOf(page, `${seen} [role="alert"]`)) === "") answered++;
        }
    }
    assert.ok(answered > 10, `only ${answered} of 80 are answered`);
    return `${answered} of 80 answered`;
}

/** One case typed key by key. */
export async function a_case_is_typed_by_keyboard({ page, tool }) {
    await page.focus("#in-P");
    await page.keyboard.press("End");
    for (let i = 0; i < 3; i++) await page.keyboard.press("Backspace");
    await page.keyboard.type("250,5");
    const shown = await shownNumbers(page);
    for (const [name, value] of Object.entries(solvedBy(tool, { ...usual, P: "250.5" }, "4")))
        if (typeof value === "number") assert.equal(Number(shown[name]), value, name);
    await page.focus("#tab-contact");
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.evaluate(() => document.activeElement.id), "tab-stress");
    const order = [];
    await page.evaluate(() => document.activeElement.blur());
    for (let i = 0; i < 60; i++) {
        await page.keyboard.press("Tab");
        order.push(await page.evaluate(() => document.activeElement.id));
    }
    for (const id of ["in-P", "in-Q", "in-theta", "in-E1", "tab-stress"])
        assert.ok(order.includes(id), `Tab does not reach ${id}: ${order}`);
}

/** Of each way to give an input one, beside its field and in the status; test/model_claims.js has the words for all. */
const bad = { E1: "-1", nu2: "-0.1", theta_deg: "90", radius: "x", Q: "20 N" };

export async function each_bad_input_is_named({ page, show }) {
    for (const [name, text] of Object.entries(bad)) {
        const texts = { ...usual, E2: "70000", nu2: "0.3", rotation: "similar", [name]: "5" };
        delete texts[{ theta_deg: "theta", radius: "a" }[name]];
        await show(texts);
        await enter(page, { [idOf(name)]: text });
        const [colour, status] = await statusOf(page);
        const note = await textOf(page, `#${idOf(name)}-note`);
        assert.match(colour, /red/, `${name} = ${text}: ${status}`);
        assert.ok(note.startsWith(`${name} ${text}: `) && status === `CHECK THE INPUTS: ${note}`, `${status}; ${note}`);
        assert.equal(await page.$eval(`#${idOf(name)}`, (part) => part.getAttribute("aria-invalid")), "true");
    }
}

export async function a_thousand_pasted_rows_are_solved({ page, show, tool }) {
    const next = chance(7),
        { E1, nu1, k } = usual;
    const row = (_, i) => {
        const [P, f] = [50 + 400 * next(), 0.1 + 0.5 * next()];
        return [i, 0.005 + 0.03 * next(), 0.02 + 0.5 * next(), P, (i % 50 === 49 ? 2 : 0.8) * f * P, f];
    };
    const rows = [["case", "theta", "a", "P", "Q", "f"], ...Array.from({ length: 1000 }, row)],
        args = ["solve", "--input", "-", "--format", "csv", ...optionsOf({ E1, nu1, k })],
        cellsOf = (text) => Array.from(text.trimEnd().split("\n"), (line) => line.split(","));
    const told = cellsOf(run(tool, args, `${inTable(rows, ",")}\n`).stdout);
    await show({ E1, nu1, k }, { tab: "batch" });
    const began = Date.now();
    await enter(page, { batch: inTable(rows) });
    await settled(page);
    const took = Date.now() - began,
        [{ text }] = await savedBy(page, "#panel-batch .tools button:last-child"),
        saved = cellsOf(text);
    assert.deepEqual([saved.length, saved[0]], [1001, told[0]]);
    saved.forEach((cells, i) =>
        cells.forEach((cell, k) => {
            if (cell !== told[i][k]) assertNear(cell, Number(told[i][k]), 1e-11, `row ${i}, ${told[0][k]}`);
        }),
    );
    assert.equal(saved.filter((cells) => cells.at(-1) === "").length, 980);
    return `${took} ms`;
}

export async function an_address_brings_the_state_back({ page, show }) {
    const numbers = { "in-P": "123,5", "in-M": "2", "in-sigma": "7" };
    const seenNow = () =>
        page.evaluate(
            (panel) => ({
                inputs: [...document.querySelectorAll("input[type=text], select")].map((e) => [e.id, e.value]),
                text: document.querySelector("main").innerText,
                plot: document.querySelector(`${panel} svg`).outerHTML,
            }),
            seen,
        );
    await enter(page, { ...numbers, "set-units": "in", "set-digits": "14", "set-sign": ",", "find-input": "f" });
    await openTab(page, "stress");
    await enter(page, { measure: "tau_max", "probe-x": "0,01", "probe-y": "0,02" });
    await pause(600);
    const before = await seenNow(),
        hash = await page.evaluate(() => location.hash.slice(1));
    await show(Object.fromEntries(new URLSearchParams(hash)));
    assert.deepEqual(await seenNow(), before);
}

/** 80 frames of a drag, sorted, in milliseconds; the field is drawn with all its detail at the end. */
const dragged = (page) =>
    page.evaluate(() => {
        const slider = document.querySelector("input[type=range]"),
            times = [];
        for (let i = 0; i < 80; i++) {
            slider.value = String((i * 37) % 120);
            slider.dispatchEvent(new Event("input"));
            times.push(Number(document.body.dataset.milliseconds));
            if (!document.querySelector('[role="tabpanel"]:not([hidden]) svg')) throw new Error("nothing is drawn");
        }
        const coarse = document.querySelector("svg.field")?.outerHTML.length;
        slider.dispatchEvent(new Event("change"));
        if (document.querySelector("svg.field")?.outerHTML.length < 1.2 * coarse) throw new Error("it stays coarse");
        return times.sort((a, b) => a - b);
    });

/** The processor's time of 60 frames of a drag, sorted, in milliseconds: other programs do not count. Nothing where the browser does not tell it. */
async function processorTimes(page) {
    const client = await page.createCDPSession().catch(() => null),
        times = [];
    if (!client) return null;
    await client.send("Performance.enable", { timeDomain: "threadTicks" });
    const now = async () => (await client.send("Performance.getMetrics")).metrics.find(({ name }) => name === "ScriptDuration").value;
    for (let i = 0; i < 60; i++) {
        const began = await now();
        await page.$eval("input[type=range]", (slider, i) => {
            slider.value = String((i * 37) % 120);
            slider.dispatchEvent(new Event("input"));
        }, i);
        times.push(1000 * ((await now()) - began));
    }
    return times.sort((a, b) => a - b);
}

/** On each tab: the processor's time of a frame, and where the machine has time the time that passes. */
export async function a_slider_redraws_at_once({ page, show }) {
    const busy = loadavg()[0] > 1.5 * cpus().length,
        told = [];
    for (const tab of ["contact", "stress", "strength", "cycle"]) {
        await show(usual, { tab });
        await settled(page);
        const times = await dragged(page),
            ofProcessor = await processorTimes(page);
        if (ofProcessor) assert.ok(ofProcessor[0] > 0.1 && ofProcessor[57] < 50, `${tab}: the processor needs ${ofProcessor[57]} ms, the allowed are 50`);
        assert.ok(busy || times[76] < 50, `${tab}: of 100 frames 5 take ${times[76]} ms or more, the allowed are 50`);
        told.push(`${tab} ${ofProcessor ? `${ofProcessor[57].toFixed(0)} of the processor, ` : ""}${times[76]}`);
    }
    return `${busy ? "the passing time is not judged, this machine is busy: " : ""}95 of 100 frames take, in ms: ${told.join("; ")}`;
}

/** What a file begins with, by the end of its name. */
const beginnings = {
    svg: /^<svg(?!.*(var\(--|light-dark))/s,
    png: /^.PNG/,
    csv: /^(# .*\n)+\w+( \[[^\]]+\])?(,\w+( \[[^\]]+\])?)+\n(.*\n){20}/,
};

/** How far texts reach beyond the right edge of a saved SVG, in pixels. */
async function beyondEdge(page, text) {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`);
    writeFileSync(`${folder}/saved.svg`, text);
    await page.goto(`file://${folder}/saved.svg`);
    rmSync(folder, { recursive: true });
    return page.evaluate(() => Math.max(...[...document.querySelectorAll("text")].map((part) => part.getBBox().x + part.getBBox().width)) - document.documentElement.viewBox.baseVal.width);
}

export async function a_saved_plot_has_all_inputs_in_its_width({ page, show }) {
    for (const width of widths) {
        await page.setViewport({ width, height: 900 });
        await show({ ...usual, M: "0.5", sigma: "12", E2: "70000", nu2: "0.33", similar: "yes" }, { name: "pad 7", tab: "stress", rotation: "similar" });
        await settled(page);
        const [svg] = await savedBy(page, `${seen} .save button[aria-label$="SVG"]`);
        assert.match(svg.text, /pad 7; E1 = 210000 MPa.*sigma = 12 MPa.*k = 400 MPa/s);
        const beyond = await beyondEdge(page, svg.text);
        assert.ok(beyond <= 0, `${width}: ${beyond} pixels beyond`);
    }
}

export async function plots_are_saved({ page, show }) {
    for (const tab of ["contact", "stress", "strength", "cycle"]) {
        await show(usual, { tab });
        await settled(page);
        const files = await savedBy(page, `${seen} .save button[aria-label]`);
        assert.equal(files.length, tab === "cycle" ? 9 : 3, tab);
        for (const { name, text } of files)
            assert.ok(text.length > 800 && beginnings[name.slice(-3)].test(text), `${name}: ${text.slice(0, 200)}`);
    }
}

/** test/model_claims.js has its numbers and its command beside the tool. */
export async function a_cycle_shows_its_worst_places({ page, show }) {
    await show(usual, { tab: "cycle", digits: "6", material: "swt_limit,0.05" });
    const { swt, cycle_safety: safety } = await shownNumbers(page);
    assertNear(safety, 0.05 / swt, 1e-5, "cycle_safety");
    assert.equal(await textOf(page, ".drawing .worst"), "worst");
    assert.match(await textOf(page, "#as-fretting"), /^printf .* \| rwedge fretting /);
}

/** The compliance is asked where loads have a displacement; both go from unit to unit, and to a file and back. */
export async function a_rig_prescribes_a_displacement_in_place_of_Q({ page, show }) {
    const asked = () => page.$$eval("#compliance", ([field]) => Boolean(field?.checkVisibility())),
        rig = inTable([["P", "displacement"], [190, 0], [190, 0.002], [190, -0.002], [190, 0.002]]);
    await show(usual, { tab: "cycle" });
    assert.equal(await asked(), false);
    await enter(page, { loads: rig });
    await settled(page);
    assert.match(await textOf(page, "#loads-note"), /a displacement in its place needs the compliance of the rig/);
    assert.equal(await asked(), true);
    await enter(page, { compliance: "1e-6" });
    const { Q_min, Q_max, slip_range } = await shownNumbers(page);
    assert.deepEqual([Q_min, Q_max], ["-38", "38"]); // f P
    assert.ok(slip_range > 0.002);
    assert.match(await textOf(page, "#plot-loop"), /displacement of the rig/);
    const [{ text }] = await savedBy(page, "#save-case");
    const { P, displacement, compliance, Q } = JSON.parse(text).loads;
    assert.deepEqual({ P, displacement, compliance, Q }, { P: Array(4).fill(190), displacement: [0, 0.002, -0.002, 0.002], compliance: 1e-6, Q: undefined });
    await enter(page, { "set-units": "m" });
    assert.match(await page.$eval("#compliance", (field) => field.value), /^1e-12$/);
    assert.match(await page.$eval("#loads", (field) => field.value), /\t2e-0?6\n/);
    assert.equal(Number((await shownNumbers(page)).Q_max), 38000);
}

/** Its sentence and picture are there once both lengths are; a new length makes them anew. test/model_claims.js has the numbers. */
export async function a_crack_shows_whether_it_stops({ page, show }) {
    const texts = { E1: "72100", nu1: "0.33", radius: "60", P: "120", Q: "65", sigma: "20", f: "0.6" };
    await show(texts, { tab: "cycle", material: "dK_th 45 MPa sqrt(mm)\nds0 150", crack_from: "0.02" });
    await settled(page);
    assert.match(await textOf(page, "#crack-note"), /both lengths are given/);
    await enter(page, { crack_to: "1" });
    await settled(page);
    assert.match(await textOf(page, "#crack-sentence"), /^By mode I the crack arrests at 0\.2474 mm; .*; with K_II of free faces it grows through/);
    const drawn = await textOf(page, "#plot-crack");
    assert.match(drawn, /mode I.*locked faces.*free faces.*threshold.*stops: 0\.\d/s);
    const files = await savedBy(page, '.save button[aria-label*="crack"]');
    assert.deepEqual(files.length, 3);
    await enter(page, { material: "dK_th 45" });
    await settled(page);
    assert.match(await textOf(page, "#loads-note"), /^dK_th 45: needs its unit/);
}

/** The drawing and all tabs; test/model_claims.js has the numbers, the command and the program. */
export async function each_pad_is_drawn({ page, show }) {
    for (const [pad, texts] of Object.entries(ofPads)) {
        await show(texts);
        const drawn = await textOf(page, ".drawing svg");
        assert.ok(/b.*yields first/.test(drawn) && drawn.includes("R") === (pad !== "profile"), `${pad}: ${drawn}`);
        for (const tab of ["stress", "strength", "cycle"]) {
            await openTab(page, tab);
            assert.equal(await textOf(page, `${seen} [role="alert"]`), "", `${pad}, ${tab}`);
        }
    }
}

/** Changing the pad keeps its sizes; a profile that is not convex is refused with the place, and its hull is taken where asked for. */
export async function a_pad_begins_with_the_sizes_of_the_one_before({ page }) {
    for (const pad of ["flat", "cylinder", "profile", "wedge"]) {
        await enter(page, { pad });
        const [colour, status] = await statusOf(page);
        assert.ok(!/CHECK/.test(status), `${pad}: ${colour}: ${status}`);
        const seen = await page.$$eval("#case .field", (fields) => fields.filter((f) => f.offsetHeight).length);
        assert.ok(seen >= 8 && seen <= 15, `${pad}: ${seen} fields`);
    }
    await enter(page, { pad: "profile" });
    const dented = [...parabola.slice(0, 20), [0, 0.02], ...parabola.slice(21)];
    await enter(page, { "in-profile": rowsOf(dented) });
    assert.match((await statusOf(page))[1], /not convex/);
    await enter(page, { making: "hull" });
    assert.ok(!/CHECK/.test((await statusOf(page))[1]), (await statusOf(page))[1]);
    assert.match(await textOf(page, "#in-profile-note"), /hull/);
}

/** 120 loads, each with another P, at each of several keystrokes: the page answers at once, and the last question is answered. */
export async function long_work_freezes_nothing({ page, show }) {
    await show(usual, { tab: "cycle" });
    const rows = Array.from({ length: 120 }, (_, i) => `${100 + ((i * 37) % 90)}\t${((i * 53) % 30) - 15}`);
    const longest = await page.evaluate(
        async (text) => {
            const area = document.getElementById("loads"),
                times = [];
            for (let i = 1; i <= 5; i++) {
                const began = performance.now();
                area.value = `${text}\n${150 + i}\t${i}`;
                area.dispatchEvent(new Event("input"));
                await new Promise(requestAnimationFrame);
                times.push(performance.now() - began);
            }
            area.value = "P\tQ\n190\t20\n190\t-20";
            area.dispatchEvent(new Event("input"));
            return Math.max(...times);
        },
        ["P\tQ", ...rows].join("\n"),
    );
    const began = Date.now();
    const { swt } = await shownNumbers(page);
    const took = Date.now() - began;
    assert.ok(longest < 1000 && took < 5000, `a keystroke takes ${longest} ms, the last answer ${took} ms`);
    assert.ok(Number(swt) > 0);
    return `a keystroke ${longest.toFixed(0)} ms, the last answer ${took} ms`;
}

/** Words of an address that every object knows are no units, tabs or measures. */
export async function an_address_with_foreign_words_is_shown({ page, show }) {
    for (const more of [{ units: "constructor" }, { tab: "__proto__" }, { tab: "stress", measure: "toString" }]) {
        await show(usual, more);
        assert.equal((await statusOf(page))[1], "OK", JSON.stringify(more));
        assert.equal((await page.$$(seen)).length, 1);
    }
}

/** Rows that are too long for an address: it is said, and a file keeps them. */
export async function rows_that_no_link_takes_are_told_and_saved({ page, show }) {
    await show(usual, { tab: "batch" });
    const said = () => page.$eval("#too-long", (part) => (part.hidden ? "" : part.textContent));
    assert.equal(await said(), "");
    const rows = Array.from({ length: 3000 }, (_, i) => `${100 + i / 100}\t0.${i}`).join("\n");
    await enter(page, { batch: `P\tQ\n${rows}` });
    await settled(page);
    assert.match(await said(), /too long for the address/);
    const [saved] = await savedBy(page, "#too-long button"),
        file = `${mkdtempSync(`${tmpdir()}/rwedge-page-`)}/${saved.name}`;
    writeFileSync(file, saved.text);
    await enter(page, { batch: "" });
    await (await page.$("#open-case")).uploadFile(file);
    await pause(300);
    rmSync(dirname(file), { recursive: true });
    assert.equal((await page.$eval("#batch", (area) => area.value)).split("\n").length, 3001);
}

/** Wrong inputs: the pictures of the last case stay, greyed, and show what is chosen. */
export async function a_wrong_input_keeps_the_last_picture({ page }) {
    const drawnNow = () => page.$eval("#panel-contact svg", (svg) => [svg.outerHTML, Boolean(svg.closest(".old"))]);
    const [drawn, greyed] = await drawnNow();
    await enter(page, { "in-P": "x" });
    assert.deepEqual([greyed, await drawnNow()], [false, [drawn, true]]);
    await openTab(page, "stress"); // which has not been drawn yet
    await enter(page, { measure: "txy" });
    const canSave = () => page.$$eval(`${seen} .save button`, (all) => all.some((button) => button.checkVisibility()));
    assert.ok(!(await canSave()), "what is saved is of the inputs on view");
    const field = await page.$eval("#panel-stress svg", (svg) => [svg.ariaLabel, Boolean(svg.closest(".old"))]);
    assert.deepEqual(field, ["shear stress txy below the surface", true]);
    await enter(page, { "in-P": "190" });
    await openTab(page, "contact");
    assert.deepEqual(await drawnNow(), [drawn, false]);
    assert.ok(await canSave());
}

/** While loads are computed nothing is shown or saved as their result that is of other loads; and that can be stopped. */
export async function no_result_is_of_other_inputs({ page, show }) {
    const visible = (selector) => page.$$eval(`${seen} ${selector}`, (all) => all.some((part) => part.checkVisibility()));
    await show(usual, { tab: "cycle" });
    await settled(page);
    assert.ok((await visible(".sentence")) && (await visible(".save button")));
    const log = Array.from({ length: 300 }, (_, i) => [190 + 20 * Math.sin(i / 9), 15 * Math.cos(i / 9), 30 * Math.sin(i / 7)]);
    await enter(page, { loads: inTable([["P", "Q", "sigma"], ...log]) });
    assert.ok(await visible("progress"), "it says that it computes");
    assert.deepEqual([await visible(".sentence"), await visible(".save button")], [false, false]);
    await page.waitForSelector(`${seen} progress[value]`); // and how much is done
    await page.$eval(`${seen} progress + button`, (button) => button.click());
    assert.match(await textOf(page, "#loads-note"), /^Stopped\./);
    assert.deepEqual([await visible("progress"), await visible(".sentence")], [false, false]);
    await enter(page, { loads: "" });
    await settled(page);
    assert.ok(await visible(".sentence"));
}

/** A long text makes no tall rows: theta = 0.5 has warnings. */
export async function long_warnings_wrap_under_the_table({ page, show }) {
    await page.setViewport({ width: 1366, height: 900 });
    await show({ ...usual, theta: "0.5", E1: "210" });
    const height = await page.evaluate(() => document.documentElement.scrollHeight);
    assert.ok(height < 2500, `${height} pixels`);
}

/** With a decimal comma: ticks, what is typed, the saved tables. */
export async function one_decimal_sign_is_everywhere({ page }) {
    await enter(page, { "set-sign": "," });
    assert.equal(await page.$eval("#in-theta", (input) => input.value), "0,01");
    const ticks = await page.$$eval("#panel-contact .tick", (texts) => texts.map((text) => text.textContent));
    assert.ok(ticks.some((text) => text.includes(",")) && !ticks.some((text) => text.includes(".")), ticks.join(" "));
    const [{ text }] = await savedBy(page, '#panel-contact .save button[aria-label$="CSV"]');
    assert.match(text.split("\n").filter((line) => !line.startsWith("#"))[5], /^-\d,\d+;\d+,\d+;/);
}

const widths = [360, 1366, 1920]; // a telephone, a small and a large screen

/** Nothing is wider than the page, and no text that matters is lost. */
export async function each_width_shows_all({ page, show, schemes, isDark }) {
    for (const width of widths) {
        await page.setViewport({ width, height: 900 });
        for (const tab of tabs)
            await inEachScheme(page, schemes, async (scheme) => {
                await show(usual, { tab, batch: "case\tP\none\t190" });
                await settled(page);
                const scrolled = await page.evaluate(() => document.documentElement.scrollWidth);
                assert.ok(scrolled <= width, `${tab}, ${width}, ${scheme}: ${scrolled}`);
                const dark = await page.evaluate(() => matchMedia("(prefers-color-scheme: dark)").matches),
                    ground = await page.$eval("body", (body) => getComputedStyle(body).backgroundColor.match(/\d+/g).map(Number));
                assert.equal(dark, scheme === "dark" || isDark === true);
                assert.equal(ground[0] < 128, dark, `${tab}, ${width}, ${scheme}: ground ${ground}`);
                if (tab !== "cycle") return;
                const heights = await page.$$eval("#panel-cycle .meaning", (cells) => cells.map((cell) => cell.offsetHeight));
                assert.ok(heights.length >= 5 && heights.every((height) => height > 5), heights.join());
            });
    }
}

/** What axe-core finds serious on the page. */
const seriousOf = (page) =>
    page.evaluate(async () =>
        (await window.axe.run()).violations
            .filter((v) => ["serious", "critical"].includes(v.impact))
            .map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((n) => n.html.slice(0, 120))}`),
    );

/** Nothing serious by axe-core, at each width, in light and in dark. */
export async function nothing_serious_stands_in_the_way({ page, show, axe, schemes }) {
    const source = readFileSync(axe, "utf8");
    for (const width of widths) {
        await page.setViewport({ width, height: 900 });
        for (const tab of tabs)
            await inEachScheme(page, schemes, async (scheme) => {
                await show(usual, { tab, batch: "case\tP\none\t190\ntwo\t50\nthree\t900" });
                await settled(page);
                await page.evaluate(source);
                assert.deepEqual(await seriousOf(page), [], `${tab}, ${width}, ${scheme}`);
            });
    }
}

/** The page of "rwedge report" too: of a load, and of a cycle with a material. */
export async function a_report_has_nothing_serious({ page, axe, tool, schemes }) {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`),
        source = readFileSync(axe, "utf8"),
        { E1, nu1, f, k, theta, a, P, Q } = Object.fromEntries(Object.entries(usual).map(([name, text]) => [name, Number(text)]));
    for (const [loads, ...more] of [[{ P, Q }, "--equations"], [{ P, Q: [Q, -Q] }]]) {
        const file = { rwedge_case: 1, name: "pad 7", units: "mm,N,MPa", bodies: { E1, nu1, f, k }, pad: { theta, a }, loads };
        writeFileSync(`${folder}/case.json`, JSON.stringify(file));
        const told = run(tool, ["report", `${folder}/case.json`, ...more, "-o", `${folder}/report.html`]);
        assert.equal(told.status, 0, told.stderr);
        for (const width of widths) {
            await page.setViewport({ width, height: 900 });
            await inEachScheme(page, schemes, async (scheme) => {
                await page.goto(`file://${folder}/report.html`);
                await page.evaluate(source);
                assert.deepEqual(await seriousOf(page), [], `${JSON.stringify(loads)}, ${width}, ${scheme}`);
                const scrolled = await page.evaluate(() => document.documentElement.scrollWidth);
                assert.ok(scrolled <= width, `${width}: ${scrolled}`);
            });
        }
    }
    rmSync(folder, { recursive: true });
}

/** Values under the pointer, curves that stay beside the next case, units that convert, the name in files, one sheet of paper. */
export async function a_plot_is_read_pinned_and_saved_by_name({ page, tool }) {
    const middle = await page.$eval("#panel-contact .frame", (frame) => {
        frame.scrollIntoView();
        const { left, top, width, height } = frame.getBoundingClientRect();
        return [left + width / 2, top + height / 2];
    });
    await page.mouse.move(...middle);
    const read = await textOf(page, "#panel-contact .under-pointer");
    assertNear(read.match(/pressure \S+ (\S+);/)[1], solvedBy(tool, usual, "17").p0, 2e-3, read);
    const pin = await page.$("#panel-contact [aria-pressed]");
    await pin.click();
    await enter(page, { "in-P": "120", "case-name": "pad 7" });
    const curves = await page.$$eval(
        "#panel-contact .pinned, #panel-contact .curve.one:not(.pinned)",
        (all) => all.length,
    );
    assert.ok(curves >= 4, `${curves} curves`);
    const [{ name }] = await savedBy(page, '#panel-contact .save button[aria-label$="CSV"]');
    assert.equal(name, "pad-7-tractions.csv");
    const safety = (await shownNumbers(page)).safety;
    await enter(page, { "set-units": "in" });
    assert.equal((await shownNumbers(page)).safety, safety);
    assertNear(await page.$eval("#in-a", (input) => input.value), 0.05 / 25.4, 1e-6, "a in inches");
}

/** Forces of the whole contact and a tension that is a force: units convert them as such, and a slider goes on from them. */
export async function whole_forces_are_converted_and_dragged({ page, show, tool }) {
    const texts = { ...usual, P: "1520", Q: "160", sigma: "800" };
    await enter(page, { "in-sigma": "800 N" }); // it is refused, and what it needs appears
    await page.waitForSelector("#in-section", { visible: true });
    await show(texts, { width: "8", section: "80", digits: "10" });
    const { b, p0 } = await shownNumbers(page),
        told = solvedBy(tool, { ...texts, units: "mm,N,MPa", width: "8", section: "80" }, "10"),
        valueOf = (id) => page.$eval(id, (input) => Number(input.value));
    assert.deepEqual([Number(b), Number(p0)], [told.b, told.p0]);
    await enter(page, { "set-units": "in" });
    const inches = await shownNumbers(page);
    assertNear(inches.b, told.b / 25.4, 1e-9, "b in inches");
    for (const [id, expected] of [["#in-P", 1520 / 4.4482216152605], ["#in-width", 8 / 25.4], ["#in-section", 80 / 25.4 ** 2], ["#in-sigma", 800 / 4.4482216152605]])
        assertNear(await valueOf(id), expected, 1e-11, id);
    await enter(page, { "set-units": "mm" });
    assertNear((await shownNumbers(page)).b, told.b, 1e-9, "b again");
    const middle = await page.$eval("#in-P", (input) => {
        const slider = input.closest(".field").querySelector("input[type=range]");
        slider.value = "0";
        slider.dispatchEvent(new Event("input"));
        return input.value;
    });
    assert.equal(middle, "1000"); // the power of ten next to 1520 N
}

/** A case is saved as the tool's case file, by its name, and opened again; a file that is none is refused with its reason. */
export async function a_case_is_saved_and_opened({ page, show, tool }) {
    const texts = { E1: "210 GPa", nu1: "0.3", radius1: "10", radius2: "40", P: "1.9 kN", Q: "200", M: "", f: "0.3", yield_stress: "700" };
    const shownNow = () =>
        page.evaluate(() => [document.querySelector("#verdict").innerText, document.title, document.querySelector("#in-width").value]);
    await show(texts, { name: "pad 7", width: "8", digits: "10", tab: "stress", measure: "s1" });
    const before = await shownNow();
    assert.match(before[1], /^pad 7 /);
    const [saved] = await savedBy(page, "#save-case");
    assert.equal(saved.name, "pad-7.json");
    const folder = mkdtempSync(`${tmpdir()}/rwedge-page-`),
        open = async (name, text) => {
            writeFileSync(`${folder}/${name}`, text);
            await (await page.$("#open-case")).uploadFile(`${folder}/${name}`);
            await pause(400);
        };
    await show();
    await open(saved.name, saved.text);
    assert.deepEqual(await shownNow(), before);
    const [quantity] = JSON.parse(run(tool, ["solve", "--case", `${folder}/${saved.name}`, "--format", "json", "--digits", "10"]).stdout)
        .filter((row) => row.quantity === "b");
    await openTab(page, "contact");
    assert.equal(Number((await shownNumbers(page)).b), quantity.value);
    for (const [text, words] of [
        ['{"E1": 1}', /no "rwedge_case": 1, so it is no case file/],
        ['{"rwedge_case": 1, "bodies": {"E3": 1}}', /bodies: E3: unknown; allowed: E1, /],
        ['{"rwedge_case": 1, "units": "mm,N,MPa", "loads": {"P": "3 kg"}}', /P 3 kg: /],
        ["{", /JSON/],
    ]) {
        await open("wrong.json", text);
        assert.match(await textOf(page, "#open-fault"), words);
    }
    rmSync(folder, { recursive: true });
}

/** A material by its name: its source, its constants as fields, its life beside the cycles that are wanted, a modulus that differs. */
export async function a_million_cycles_are_judged_by_a_named_material({ page, show, tool }) {
    await show({ ...usual, E1: "206800" }, { tab: "cycle", digits: "6" });
    await enter(page, { "material-name": "sae-1015-normalized", wanted: "1e7" });
    await settled(page);
    assert.match(await textOf(page, "#panel-cycle"), /Source: J\. A\. Bannantine/);
    assert.equal(await page.$eval("#constant-sf", (input) => input.value), "827");
    assert.match(await textOf(page, ".sentence"), /passes of the loads to failure; fewer than the 1e7 wanted/);
    const { cycle_life: life } = await shownNumbers(page);
    assert.equal(await page.$("#modulus"), null);
    await enter(page, { "in-E1": "70000" });
    await page.click("#modulus button");
    assert.equal(await page.$eval("#in-E1", (input) => input.value), "206800");
    await page.evaluate(() => {
        const field = document.getElementById("constant-sf");
        field.value = "900";
        field.dispatchEvent(new Event("change", { bubbles: true }));
    });
    const isLonger = (before) => Number(document.querySelector('[data-name="cycle_life"]')?.textContent) > before;
    await page.waitForFunction(isLonger, { timeout: 60000 }, Number(life));
    await enter(page, { "material-name": "sae-1015-normalized" });
    const [saved] = await savedBy(page, "#save-case"),
        folder = mkdtempSync(`${tmpdir()}/rwedge-page-`);
    assert.equal(JSON.parse(saved.text).material, "sae-1015-normalized");
    writeFileSync(`${folder}/case.json`, saved.text);
    writeFileSync(`${folder}/log.csv`, "P,Q\n190,20\n190,-20\n");
    const told = run(tool, ["fretting", `${folder}/log.csv`, "--load", "190,0", "--case", `${folder}/case.json`, "--at-worst", "--format", "json"]).stdout;
    assertNear(life, JSON.parse(told).find(({ measure }) => measure === "swt").life, 1e-5, "life");
    rmSync(folder, { recursive: true });
}

/** Cases that are pinned stand beside the present one, with names and differences in percent, in the units of the page. */
export async function pinned_cases_are_compared({ page, show }) {
    await show(usual, { tab: "compare", name: "first", digits: "6" });
    await page.click("#pin-case");
    await enter(page, { "in-P": "380", "pin-0": "pad A" });
    const row = (name) =>
        page.$$eval("#side-by-side tr", (rows, name) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)).find(([first]) => first === name), name);
    const [, unit, present, pinned, percent] = await row("b");
    assert.equal(unit, "mm");
    assertNear(percent.replace(" %", ""), 100 * (present / pinned - 1), 5e-3, "percent");
    assert.equal((await row(""))[3], "pad A");
    await enter(page, { "set-units": "in" });
    const [, , , inInches, same] = await row("b");
    assertNear(inInches, pinned / 25.4, 1e-5, "b in inches");
    assert.equal(same, percent);
    await page.click(".pins button");
    assert.equal((await row("")).length, 3);
}

/** A profile with noise: the page says how well it is resolved, is green for none that is not, and names no option of the tool. */
export async function a_noisy_profile_is_not_green({ page, show }) {
    const next = chance(5),
        normal = () => Math.sqrt(-2 * Math.log(next())) * Math.cos(2 * Math.PI * next());
    const rows = Array.from({ length: 300 }, (_, i) => {
        const x = -1.8 + (3.6 * i) / 299;
        return [x.toFixed(5), (100 * Math.max(0, Math.abs(x) - 1.5) ** 2 + 0.05 * normal()).toFixed(4)];
    });
    const pasted = ["Stylus 2 um, by hand", "", "x [mm]\theight [um]", ...rows.map((row) => row.join("\t"))].join("\n"),
        { theta, a, ...body } = { ...usual, k: "4000" };
    for (const making of ["hull", "fit"]) {
        await show({ ...body, profile: pasted, [making]: "yes" });
        const [colour, status] = await statusOf(page),
            note = await textOf(page, "#in-profile-note");
        assert.match(colour, /amber/, `${making}: ${status}`);
        assert.match(note, /places lie between the highest pressure and the edges; the noise is \S+ mm by a fit of \d arcs; without every second place p0 changes by/);
        assertNear(note.match(/the noise is (\S+) mm/)[1], 5e-5, 0.15, "noise");
        assert.ok(!/--[a-z]/.test(status + note), status + note);
    }
}

/** Changes go back and forth; one that follows an undone one ends what could be redone. */
export async function changes_are_undone_and_redone({ page }) {
    const P = () => page.$eval("#in-P", (input) => input.value),
        isOff = (id) => page.$eval(id, (button) => button.disabled);
    assert.deepEqual([await isOff("#undo"), await isOff("#redo")], [true, true]);
    for (const text of ["200", "210"]) {
        await pause(800); // what is typed faster is one change
        await enter(page, { "in-P": text });
    }
    await page.click("#undo");
    assert.equal(await P(), "200");
    await page.click("#undo");
    assert.deepEqual([await P(), await isOff("#undo")], ["190", true]);
    await page.click("#redo");
    assert.equal(await P(), "200");
    await pause(800);
    await enter(page, { "in-Q": "5" });
    assert.ok(await isOff("#redo"));
    await page.click("#undo");
    assert.deepEqual([await P(), await page.$eval("#in-Q", (input) => input.value)], ["200", "20"]);
}

/** What gives a safety is taken into the form. */
export async function a_safety_is_asked_for({ page, show }) {
    await show(usual, { digits: "10" });
    for (const name of ["radius", "P", "f"]) {
        await enter(page, { "find-input": name, "find-safety": "1.5" });
        await page.click(".find button");
        assertNear((await shownNumbers(page)).safety, 1.5, 1e-8, name);
    }
    for (const [factor, shown] of [["stress", "yield_factor"], ["sliding", "safety_strength"]]) {
        await show(usual, { digits: "10" });
        await enter(page, { "find-input": "radius", "find-factor": factor, "find-safety": "1.5" });
        await page.click(".find button");
        assertNear((await shownNumbers(page))[shown], 1.5, 1e-8, shown);
    }
}
