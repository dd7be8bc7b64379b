// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles a module of the page, with what build.sh has made: the JavaScript package, whose WebAssembly holds the model too, and texts.
import { createRequire } from "node:module";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const page = resolve(dirname(fileURLToPath(import.meta.url)), "..");
export const esbuildOf = (folder) => createRequire(`${folder}/page/node_modules/`)("esbuild");

/** The text of a module with all that it imports; folder is that of build.sh. */
export async function bundle(folder, entry, options) {
    const made = (name) => `${folder}/page/${name}.mjs`;
    const built = await esbuildOf(folder).build({
        entryPoints: [entry],
        bundle: true,
        target: "es2022",
        charset: "ascii",
        alias: { rwedge: made("rwedge"), "rwedge-runtime": made("runtime"), texts: made("texts") },
        nodePaths: [`${folder}/page/node_modules`],
        loader: { ".css": "text" },
        legalComments: "none",
        write: false,
        logLevel: "warning",
        ...options,
    });
    return built.outputFiles[0].text;
}
