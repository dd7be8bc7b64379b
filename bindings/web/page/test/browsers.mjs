// SPDX-License-Identifier: GPL-3.0-or-later
// The page in the browsers of this machine: node browsers.mjs PAGE TOOL AXE [BROWSER [CLAIM ...]]
import * as claims from "./claims.mjs";
import { browsers, openBrowser, openPage, programOf, reopen } from "./drive.mjs";

const [file, tool, axe, only, ...wanted] = process.argv.slice(2);
const last = "nothing_is_said_and_nothing_asked_for"; // of all the others
const order = [...Object.keys(claims).filter((name) => name !== last), last];
let failed = 0,
    tried = 0;
for (const [name, about] of Object.entries(browsers).filter(([name]) => !only || name === only)) {
    if (!programOf(about)) {
        console.log(`SKIPPED: ${name} is not here`);
        continue;
    }
    const session = await openBrowser(about);
    for (const claim of order.filter((name) => wanted.length === 0 || wanted.includes(name))) {
        const began = Date.now(),
            page = await openPage(session),
            show = (...state) => reopen(page, file, ...state);
        try {
            await show();
            const said = await claims[claim]({ page, show, session, tool, axe, dark: name === "chromium" });
            console.log(`ok: ${name}: ${claim}${said ? `: ${said}` : ""} (${Date.now() - began} ms)`);
        } catch (error) {
            failed++;
            console.log(`FAILED: ${name}: ${claim}: ${error.message.slice(0, 1500)}`);
        }
        tried++;
        await page.close();
    }
    await session.browser.close();
}
process.exit(failed > 0 ? 1 : tried > 0 ? 0 : 77);
