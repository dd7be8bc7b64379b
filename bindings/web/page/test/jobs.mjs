// SPDX-License-Identifier: GPL-3.0-or-later
// The jobs of a designer, each as a person does it: a click, a choice in a menu, a field filled, a paste, a key or a file opened is one
// action, and a job has ten. Each begins with the page as it opens.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { constants, inflateSync } from "node:zlib";
import { assertNear, chance, optionsOf, usual } from "./shared.mjs";
import { enter, savedBy, seen, settled, shownNumbers, statusOf } from "./drive.mjs";

const MOST = 10;

/** Does what a person does, and counts it. */
function handOf(page) {
    let count = 0;
    const act = async (action) => {
        count++;
        await action();
        await settled(page);
    };
    return {
        click: (selector) => act(() => page.click(selector)),
        choose: (id, value) => act(() => page.select(`#${id}`, value)),
        fill: (id, text) =>
            act(async () => {
                await page.click(`#${id}`, { count: 3 });
                await page.keyboard.type(text);
                await page.keyboard.press("Tab");
            }),
        paste: (id, text) => act(() => enter(page, { [id]: text })),
        open: (file) => act(async () => (await page.$("#open-case")).uploadFile(file)),
        /** What a key of the browser does, such as printing. */
        key: (action) => act(action),
        finished: (said) => {
            assert.ok(count <= MOST, `${count} actions`);
            return `${count} actions${said ? `: ${said}` : ""}`;
        },
    };
}

const sentenceOf = (page) => page.$eval(`${seen} .sentence`, (part) => part.textContent);
const run = (tool, args, input) => {
    const { stdout, stderr, status } = spawnSync(tool, args, { encoding: "utf8", input, maxBuffer: 1 << 28 });
    assert.equal(status, 0, stderr);
    return stdout;
};
const inJson = ["--format", "json", "--digits", "17"];
const solved = (tool, texts, ...more) =>
    Object.fromEntries(
        JSON.parse(run(tool, ["solve", ...optionsOf(texts), ...more, ...inJson])).map(({ quantity, value }) => [quantity, value]),
    );
const worstOf = (tool, log, ...more) =>
    Object.fromEntries(
        JSON.parse(run(tool, ["fretting", "-", ...more, "--at-worst", ...inJson], log)).map((row) => [row.measure, row]),
    );
const inFolder = async (action) => {
    const folder = mkdtempSync(`${tmpdir()}/rwedge-jobs-`);
    try {
        return await action(folder);
    } finally {
        rmSync(folder, { recursive: true });
    }
};

/** Does it yield, and with which R has it a factor of 2 on the stress? */
export async function yield_and_R_for_a_safety({ page, tool }) {
    const hand = handOf(page);
    await hand.fill("in-P", "300");
    await hand.fill("in-Q", "50");
    const sentence = await page.$eval("#verdict .sentence", (part) => part.textContent),
        before = solved(tool, { ...usual, P: "300", Q: "50" }, "--yield-factor");
    assertNear(sentence.match(/^Elastic with a factor of (\S+) on the stress/)[1], before.yield_factor, 1e-3, sentence);
    await hand.choose("find-factor", "stress");
    await hand.fill("find-safety", "2");
    await hand.click(".find button");
    const radius = (await page.$eval("#in-a", (input) => input.value)).trim(),
        { a, ...others } = usual,
        after = solved(tool, { ...others, radius, P: "300", Q: "50" }, "--yield-factor");
    assertNear(after.yield_factor, 2, 1e-9, `R = ${radius}`);
    return hand.finished();
}

/** A flat pad that a moment tilts, while Q goes to and fro. */
export async function a_pad_with_a_moment_under_a_cycle({ page, tool }) {
    const hand = handOf(page),
        { theta, a, P, Q, ...body } = usual;
    await hand.choose("pad", "flat");
    await hand.fill("in-flat", "0.5");
    await hand.fill("in-a", "10");
    await hand.fill("in-M", "10");
    await hand.click("#tab-cycle");
    const { swt, fatemi_socie } = await shownNumbers(page),
        log = `P,M,Q\n${P},10,${Q}\n${P},10,-${Q}\n`,
        worst = worstOf(tool, log, "--load", `${P},10,0,0`, ...optionsOf({ ...body, flat: "0.5", radius: "10" }));
    assertNear(swt, worst.swt.value, 1e-3, "swt");
    assertNear(fatemi_socie, worst.fatemi_socie.value, 1e-3, "fatemi_socie");
    return hand.finished();
}

/** Does it last a million cycles, of which material? */
export async function a_million_cycles_with_a_named_material({ page, tool }) {
    const hand = handOf(page),
        { P, Q, ...body } = usual;
    await hand.click("#tab-cycle");
    await hand.choose("material-name", "sae-1015-normalized");
    await hand.click("#modulus button"); // E1 becomes that of the material
    await hand.fill("wanted", "1e6");
    const sentence = await sentenceOf(page),
        { cycle_life: life } = await shownNumbers(page),
        { E1, nu1, k, ...others } = body,
        steel = ["--material", "sae-1015-normalized", "--units", "mm,N,MPa"],
        told = worstOf(tool, `P,Q\n${P},${Q}\n${P},-${Q}\n`, "--load", `${P},0`, ...optionsOf(others), ...steel);
    const expected = told.swt.life === "inf" ? Infinity : told.swt.life;
    assert.equal(Number(life), Number(expected.toPrecision(4)), "life");
    assert.match(sentence, expected >= 1e6 ? /enough for the 1e6 wanted/ : /fewer than the 1e6 wanted/);
    return hand.finished(sentence);
}

/** As an instrument writes it: decimal commas, semicolons, names with a row of units below, forces of the whole width. */
export async function a_log_of_500_rows_with_decimal_commas({ page, tool }) {
    const hand = handOf(page),
        { P, Q, ...body } = usual,
        comma = (value) => value.toFixed(4).replace(".", ","),
        points = (text) => text.replaceAll(",", ".").replaceAll(";", ",");
    const rows = Array.from({ length: 500 }, (_, i) =>
        [comma(i / 100), comma(1.52 + 0.05 * Math.sin(i / 40)), comma(160 * Math.sin((i + 7) / 9))].join(";"));
    const log = ["Rig 7, specimen 12", "logged by hand", "Time;P;Q", "s;kN;N", ...rows].join("\n");
    await hand.choose("set-sign", ",");
    await hand.fill("in-width", "8");
    await hand.fill("in-P", "1520");
    await hand.fill("in-Q", "160");
    await hand.click("#tab-cycle");
    await hand.fill("cycles", "1");
    await hand.paste("loads", log);
    const { swt } = await shownNumbers(page),
        told = worstOf(tool, points(log), "--units", "mm,N,MPa", "--width", "8", "--cycles", "1", ...optionsOf(body));
    assertNear(swt.replace(",", "."), told.swt.value, 1e-3, "swt");
    return hand.finished();
}

/** Heights of a stylus in micrometres, with noise: a cylinder of R 40, whose pressure Hertz knows. */
export async function a_noisy_profile_in_micrometres({ page, tool }) {
    const hand = handOf(page),
        next = chance(11),
        { theta, a, ...others } = usual,
        normal = () => Math.sqrt(-2 * Math.log(next())) * Math.cos(2 * Math.PI * next());
    const rows = Array.from({ length: 400 }, (_, i) => {
        const x = -1 + (2 * i) / 399;
        return `${x.toFixed(5)}\t${((1000 * x * x) / 80 + 0.1 * normal()).toFixed(4)}`;
    });
    await hand.choose("pad", "profile");
    await hand.paste("in-profile", ["Stylus 2 um", "x [mm]\theight [um]", ...rows].join("\n"));
    await hand.choose("making", "fit");
    const [, status] = await statusOf(page),
        note = await page.$eval("#in-profile-note", (part) => part.textContent),
        { p0 } = await shownNumbers(page);
    assertNear(p0, solved(tool, { ...others, radius: "40" }).p0, 0.02, `${status}; ${note}`);
    assertNear(note.match(/the noise is (\S+) mm/)[1], 1e-4, 0.15, note);
    return hand.finished(note);
}

/** How many sheets a PDF has: its objects may be in streams that are compressed. */
function sheetsOf(pdf) {
    const text = pdf.toString("latin1"),
        inflated = [...text.matchAll(/stream\r?\n([^]*?)\r?\nendstream/g)].map(([, stream]) => {
            try {
                return inflateSync(Buffer.from(stream, "latin1"), { finishFlush: constants.Z_SYNC_FLUSH }).toString("latin1");
            } catch {
                return ""; // is compressed in another way
            }
        });
    const counts = [text, ...inflated].flatMap((part) => [...part.matchAll(/\/Count (\d+)/g)].map(([, count]) => Number(count)));
    return Math.max(...counts);
}

/** On one sheet of paper, by the template of the report: with the results that are on view, and three pictures; of a cycle too. */
export async function the_case_is_printed({ page, show }) {
    const hand = handOf(page);
    await hand.fill("case-name", "pad 7");
    let pdf;
    await hand.key(async () => (pdf = Buffer.from(await page.pdf({ format: "A4" }))));
    assert.equal(sheetsOf(pdf), 1);
    const printed = () =>
        page.$eval("#report", ({ shadowRoot }) => [shadowRoot.querySelector("h1").textContent, shadowRoot.textContent, shadowRoot.querySelectorAll("svg").length]);
    const [name, text, pictures] = await printed(),
        { b } = await shownNumbers(page);
    assert.deepEqual([name, pictures], ["pad 7", 3]);
    for (const words of [/Elastic with a factor of/, new RegExp(`half-width of the contact b${b}mm`), /Plane strain: a long contact\./, /All is in closed form/])
        assert.match(text, words);
    assert.ok(!/\{\{|undefined|--[a-z]/.test(text), text);
    await show(usual, { tab: "cycle" });
    await settled(page);
    assert.equal(sheetsOf(Buffer.from(await page.pdf({ format: "A4" }))), 1);
    assert.match((await printed())[1], /The cycle.*swt/s);
    return hand.finished();
}

/** A case goes to a colleague, and is the same there. */
export async function a_case_is_saved_and_reopened({ page, show }) {
    const hand = handOf(page),
        shown = () => page.$eval("#verdict", (part) => part.innerText);
    await hand.fill("in-P", "260");
    await hand.fill("case-name", "pad 7");
    const before = await shown();
    let saved;
    await hand.key(async () => ([saved] = await savedBy(page, "#save-case")));
    await inFolder(async (folder) => {
        writeFileSync(`${folder}/${saved.name}`, saved.text);
        await show();
        assert.notEqual(await shown(), before);
        await hand.open(`${folder}/${saved.name}`);
        await page.waitForFunction(() => document.getElementById("case-name").value === "pad 7");
    });
    assert.equal(await shown(), before);
    return hand.finished();
}

/** How much more pressure has another radius? */
export async function two_cases_are_compared({ page, tool }) {
    const hand = handOf(page);
    await hand.click("#tab-compare");
    await hand.click("#pin-case");
    await hand.fill("in-P", "380");
    const cells = await page.$$eval("#side-by-side tr", (rows) =>
        rows.map((row) => [...row.cells].map((cell) => cell.textContent)).find(([name]) => /^p/.test(name) && name.includes("₀")));
    const [first, second] = ["190", "380"].map((P) => solved(tool, { ...usual, P }).p0);
    assertNear(cells.at(-1).replace(" %", ""), 100 * (second / first - 1), 1e-2, cells.join(" | "));
    return hand.finished();
}
