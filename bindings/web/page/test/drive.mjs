// SPDX-License-Identifier: GPL-3.0-or-later
// A browser of the system with the page in it, opened as a file.
import { existsSync } from "node:fs";
import puppeteer from "puppeteer-core";

export const browsers = {
    chromium: {
        names: ["chromium", "chromium-browser", "google-chrome"],
        browser: "chrome",
        args: ["--no-sandbox", "--disable-background-networking"],
        schemes: ["light", "dark"], // which a page of it can be asked for
    },
    firefox: { names: ["firefox-esr", "firefox"], browser: "firefox", args: [], schemes: [] },
    "firefox in the dark": {
        names: ["firefox-esr", "firefox"],
        browser: "firefox",
        args: [],
        prefs: { "layout.css.prefers-color-scheme.content-override": 0 },
        schemes: [],
        isDark: true,
        only: ["nothing_serious_stands_in_the_way", "each_width_shows_all"],
    },
};

/** Its program; nothing where this machine does not have it. */
export const programOf = ({ names }) =>
    names.flatMap((name) => process.env.PATH.split(":").map((folder) => `${folder}/${name}`)).find(existsSync);

/** The browser, and what it said and asked for since it began. */
export async function openBrowser(about) {
    const browser = await puppeteer.launch({
        browser: about.browser,
        executablePath: programOf(about),
        args: about.args,
        extraPrefsFirefox: about.prefs,
        headless: true,
        protocolTimeout: 300000,
    });
    return { browser, said: [], asked: [] };
}

/** A page, empty as yet. */
export async function openPage({ browser, said, asked }) {
    const page = await browser.newPage();
    page.on("console", (message) => said.push(`${message.type()}: ${message.text()}`));
    page.on("pageerror", (error) => said.push(`error: ${error.message}`));
    page.on("request", (request) => asked.push(request.url()));
    await page.setViewport({ width: 1300, height: 900 });
    return page;
}

/** Loads the file anew, with a case and more of its state. */
export async function reopen(page, file, texts = {}, more = {}) {
    await page.goto("about:blank");
    await page.goto(`file://${file}#${new URLSearchParams({ ...texts, ...more })}`);
    await page.waitForSelector("#status");
}

/** What is shown in light or in dark, where the browser can be asked; else as it is. */
export async function inEachScheme(page, schemes, action) {
    for (const scheme of schemes.length > 0 ? schemes : [null]) {
        if (scheme) await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
        await action(scheme ?? "its own");
    }
}

/** Types into a field as a whole: the field hears of it as of a paste. */
export const enter = (page, texts) =>
    page.evaluate((entries) => {
        for (const [id, text] of Object.entries(entries)) {
            const input = document.getElementById(id);
            input.value = text;
            input.dispatchEvent(new Event(input.tagName === "SELECT" ? "change" : "input", { bubbles: true }));
        }
    }, texts);

/** The panel of the tab that is seen. */
export const seen = '[role="tabpanel"]:not([hidden])';

/** Waits for what is computed aside. */
export const settled = (page) =>
    page.waitForFunction(() => !document.querySelector('[aria-busy="true"]'), { timeout: 60000 });

/** The numbers of the tab that is seen, by their names. */
export async function shownNumbers(page) {
    await settled(page);
    const named = (cells) => cells.map((cell) => [cell.dataset.name, cell.textContent]);
    return Object.fromEntries(await page.$$eval(`${seen} [data-name]`, named));
}

/** The files that buttons save, [{ name, text }]; nothing is downloaded. */
export const savedBy = (page, selector) =>
    page.evaluate(async (selector) => {
        const files = [],
            buttons = document.querySelectorAll(selector);
        URL.createObjectURL = (blob) => (files.push({ blob }), "#");
        HTMLAnchorElement.prototype.click = function () {
            files.at(-1).name = this.download;
        };
        buttons.forEach((button) => button.click());
        while (files.length < buttons.length) await new Promise((done) => setTimeout(done, 50));
        return Promise.all(files.map(async ({ name, blob }) => ({ name, text: await blob.text() })));
    }, selector);

export const statusOf = (page) => page.$eval("#status", (status) => [status.className, status.textContent]);
export const openTab = (page, name) => page.evaluate((id) => document.getElementById(id).click(), `tab-${name}`);
export const pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
