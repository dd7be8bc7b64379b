// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the page: node page.mjs FOLDER OUTPUT COMPILER. FOLDER has what build.sh made; COMPILER compiled the library.
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { bundle, esbuildOf, page } from "./bundle.mjs";

const [folder, output] = process.argv.slice(2, 4).map((name) => resolve(name));
const compiler = process.argv[4];

async function program() {
    const text = await bundle(folder, `${page}/src/start.js`, { minify: true, format: "iife" });
    return text.trim().replaceAll("</script", "<\\/script");
}

function style() {
    const text = ["plot/plot.css", "page.css"].map((name) => readFileSync(`${page}/src/${name}`, "utf8")).join("\n");
    return esbuildOf(folder).transformSync(text, { loader: "css", minify: true }).code.trim();
}

/** Of a part that stands in the page, for the policy: nothing else may run or be applied. */
const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

const [script, css] = [await program(), style()];
const policy = [
    "default-src 'none'",
    `script-src ${hash(script)} 'wasm-unsafe-eval'`,
    "worker-src blob:", // the same script, aside
    `style-src ${hash(css)}`,
    "img-src data: blob:",
    "base-uri 'none'",
    "form-action 'none'",
].join("; ");
const html = readFileSync(`${page}/src/page.html`, "utf8")
    .replace("POLICY", () => policy)
    .replace("COMPILER", () => compiler)
    .replace("STYLE", () => css)
    .replace("SCRIPT", () => script);
writeFileSync(output, html);
