// SPDX-License-Identifier: GPL-3.0-or-later
// The page in the browsers of this machine: node [--test-name-pattern=CLAIM] browsers.mjs PAGE TOOL AXE
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import * as claims from "./claims.mjs";
import * as jobs from "./jobs.mjs";
import { browsers, openBrowser, openPage, programOf, reopen } from "./drive.mjs";

const [file, tool, axe] = process.argv.slice(2);

const all = { ...claims, ...jobs };

async function tryClaim(name, session, browser) {
    const page = await openPage(session),
        show = (...state) => reopen(page, file, ...state);
    await show();
    const said = await all[name]({ page, show, tool, axe, schemes: browsers[browser].schemes, isDark: browsers[browser].isDark });
    if (said) console.log(`${browser}: ${name}: ${said}`);
    await page.close();
}

for (const [browser, about] of Object.entries(browsers))
    describe(browser, { skip: !programOf(about) && `SKIPPED: ${browser} is not here` }, () => {
        let session;
        before(async () => (session = await openBrowser(about)));
        for (const name of about.only ?? Object.keys(all)) test(name, () => tryClaim(name, session, browser));

        /** In all the others: axe-core's own letters are data, and ask no one. */
        test("nothing_is_said_and_nothing_asked_for", () => {
            const allowed = /^(file:\/\/[^#]*(rounded-wedge\.html|report\.html|saved\.svg)|about:|data:|blob:)/;
            assert.deepEqual([session.said, session.asked.filter((url) => !allowed.test(url))], [[], []]);
        });
        after(() => session.browser.close());
    });
if (!Object.values(browsers).some(programOf)) process.exit(77);
