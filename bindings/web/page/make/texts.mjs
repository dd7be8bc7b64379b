// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the texts of the tab About as a module, from the READMEs and licences of the project and of what is in the page:
// node texts.mjs TOP FOLDER. FOLDER has what build.sh fetched.
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";

const [top, folder] = process.argv.slice(2).map((name) => resolve(name)),
    modules = `${folder}/page/node_modules`,
    need = createRequire(`${modules}/`),
    { marked } = need("marked"),
    temml = need("temml");

/** One section of a README: from its heading to the next of that level. */
function section(text, heading) {
    const at = text.indexOf(`\n## ${heading}\n`);
    if (at < 0) throw new Error(`no section "${heading}"`);
    const body = text.slice(at + heading.length + 5);
    const end = body.search(/\n## /);
    return end < 0 ? body : body.slice(0, end);
}

/** Links lead to files that are not beside the page: their text stays. */
const withoutLinks = (text) => text.replace(/\[([^\]]*)\]\([^)]*\)/g, "$1");

/** TeX between dollars as MathML. A line over letters would be a style, as others are: the page's policy forbids them; a bar is a letter. */
function withFormulas(text) {
    const mathML = (tex) =>
        temml.renderToString(tex.replaceAll("\\overline", "\\bar"), { throwOnError: true }).replace(/ style="[^"]*"/g, "");
    return text.replace(/\$([^$\n]+)\$/g, (_, tex) => mathML(tex).replaceAll("|", "&#124;"));
}

/** The packages that are in the bundle: of those that were fetched the ones that are no tool. */
function namesOfPackages() {
    const { packages } = JSON.parse(readFileSync(`${modules}/../package-lock.json`, "utf8"));
    const paths = Object.keys(packages).filter((path) => /^node_modules\/[^@]/.test(path) && !packages[path].dev);
    return paths.map((path) => path.replace("node_modules/", ""));
}

function licences() {
    const ofPackages = namesOfPackages().map((name) => {
        const { version, license } = JSON.parse(readFileSync(`${modules}/${name}/package.json`, "utf8"));
        return {
            name: `${name} ${version} (${license})`,
            text: readFileSync(`${modules}/${name}/LICENSE`, "utf8").trim(),
        };
    });
    const read = (name) => readFileSync(`${folder}/web/${name}`, "utf8").trim();
    return [
        { name: "in the library", text: read("package/NOTICE") },
        { name: "libcsv, reading of rows (LGPL-2.1-or-later)", text: read("sources/libcsv/COPYING.LESSER") },
        ...ofPackages,
    ];
}

/** Those that the tool has by name. */
function materials() {
    const folder = `${top}/tables/materials`,
        files = readdirSync(folder).filter((file) => file.endsWith(".json")).sort();
    return Object.fromEntries(files.map((file) => [file.replace(".json", ""), JSON.parse(readFileSync(`${folder}/${file}`, "utf8"))]));
}

const read = (name) => readFileSync(`${top}/${name}`, "utf8");
const html = (text) => marked.parse(withoutLinks(withFormulas(text)), { async: false });
const library = read("lib/README.md"),
    front = read("README.md");
const texts = {
    errata: html(section(library, "Errata").split("\n`tests/")[0]),
    accuracy: html(section(front, "Accuracy and speed").split("\nHow all this")[0]),
    conventions: html(section(library, "Conventions")),
    formulas: html(section(library, "The paper's formulas")),
    citation: read("CITATION.cff"),
    licence: read("LICENSE"),
    licences: licences(),
    report: read("cli/report/page.html"),
    materials: materials(),
};
console.log(`export const texts = ${JSON.stringify(texts)};`);
