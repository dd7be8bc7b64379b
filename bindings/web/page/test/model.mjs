// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles what the page computes, without a document, and tries it in Node: node model.mjs FOLDER TOOL [PYTHON]. FOLDER is that of
// build.sh; PYTHON runs the programs that the page shows.
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { bundle, page } from "../make/bundle.mjs";

const [folder, TOOL, PYTHON = ""] = process.argv.slice(2).map((name) => name && resolve(name));
const file = `${folder}/page/model_claims.mjs`;
writeFileSync(file, await bundle(folder, `${page}/test/model_claims.js`, { format: "esm", platform: "node" }));
const done = spawnSync("node", ["--test", "--test-reporter=tap", file], {
    encoding: "utf8",
    env: { ...process.env, TOOL, PYTHON },
});
console.log(done.status === 0 ? done.stdout.match(/^# pass.*$/m)[0] : done.stdout);
process.exit(done.status);
