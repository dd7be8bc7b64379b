// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles a module of the page: with the JavaScript package, whose WebAssembly holds the model too, and with the texts of the READMEs.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { texts } from "./texts.mjs";

export const page = resolve(dirname(fileURLToPath(import.meta.url)), "..");
const top = resolve(page, "../../..");

/** Modules that are made here. */
const made = (folder, modules) => ({
    name: "made",
    setup(build) {
        build.onResolve({ filter: /^texts$/ }, ({ path }) => ({ path, namespace: "made" }));
        build.onLoad({ filter: /.*/, namespace: "made" }, () => ({
            contents: `export const texts = ${JSON.stringify(texts(top, modules, folder))};`,
        }));
        build.onLoad({ filter: /\/web\/package\/wasm\.mjs$/ }, () => {
            const text = readFileSync(`${folder}/page/page.wasm`).toString("base64");
            return {
                contents: `export const wasm = Uint8Array.from(atob("${text}"), (letter) => letter.charCodeAt(0));`,
            };
        });
    },
});

export const esbuildOf = (folder) => createRequire(`${folder}/page/node_modules/`)("esbuild");

/** The text of a module with all that it imports; folder is that of build.sh. */
export async function bundle(folder, entry, options) {
    const modules = `${folder}/page/node_modules`;
    const built = await esbuildOf(folder).build({
        entryPoints: [entry],
        bundle: true,
        target: "es2022",
        charset: "ascii",
        alias: { rwedge: `${folder}/web/package/rwedge.mjs`, "rwedge-runtime": `${folder}/web/package/runtime.mjs` },
        nodePaths: [modules],
        plugins: [made(folder, modules)],
        loader: { ".css": "text" },
        legalComments: "none",
        write: false,
        logLevel: "warning",
        ...options,
    });
    return built.outputFiles[0].text;
}
