// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the page: node page.mjs BINDING NODE_MODULES OUTPUT COMPILER. BINDING is the JavaScript package as COMPILER made it.
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { texts } from "./texts.mjs";
import { words } from "./words.mjs";

const [binding, modules, output] = process.argv.slice(2, 5).map((name) => resolve(name));
const compiler = process.argv[5];
const page = resolve(dirname(fileURLToPath(import.meta.url)), ".."),
    top = resolve(page, "../../..");
const require = createRequire(`${modules}/`);
const esbuild = require("esbuild");

/** A module that is made here: the words of the tool, the texts of the READMEs. */
const asModule = (name, value) => {
    const json = JSON.stringify(value, (_, v) => (v === Infinity ? "@inf" : v === -Infinity ? "@-inf" : v));
    return `export const ${name} = ${json.replaceAll('"@inf"', "Infinity").replaceAll('"@-inf"', "-Infinity")};`;
};
const made = {
    name: "made",
    setup(build) {
        build.onResolve({ filter: /^(words|texts)$/ }, ({ path }) => ({ path, namespace: "made" }));
        build.onLoad({ filter: /.*/, namespace: "made" }, ({ path }) => ({
            contents: asModule(path, path === "words" ? words(top) : texts(top, modules, binding)),
        }));
    },
};

async function bundle() {
    const built = await esbuild.build({
        entryPoints: [`${page}/src/main.js`],
        bundle: true,
        minify: true,
        format: "iife",
        target: "es2022",
        charset: "ascii",
        alias: { rwedge: `${binding}/rwedge.mjs` },
        nodePaths: [modules],
        plugins: [made],
        loader: { ".css": "text" },
        legalComments: "none",
        write: false,
        logLevel: "warning",
    });
    return built.outputFiles[0].text.trim().replaceAll("</script", "<\\/script");
}

function style() {
    const text = ["plot.css", "page.css"].map((name) => readFileSync(`${page}/src/${name}`, "utf8")).join("\n");
    return esbuild.transformSync(text, { loader: "css", minify: true }).code.trim();
}

/** Of a part that stands in the page, for the policy: nothing else may run or be applied. */
const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

const [script, css] = [await bundle(), style()];
const policy = [
    "default-src 'none'",
    `script-src ${hash(script)} 'wasm-unsafe-eval'`,
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
