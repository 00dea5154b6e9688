// Checks .glb files against the glTF specification with Khronos' validator, which must report no error,
// warning or hint. Usage: node validate.mjs FILE.glb...
import { readFile } from "node:fs/promises";
import process from "node:process";
import validator from "gltf-validator";

let faults = 0;
for (const file of process.argv.slice(2)) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(file)), { maxIssues: 10 });
  const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
  const found = numErrors + numWarnings + numInfos + numHints;
  faults += found;
  for (const { code, message, pointer } of messages) console.error(`${file}: ${code}: ${message} (${pointer})`);
  if (found === 0) console.log(`${file}: valid; ${report.info.totalTriangleCount} triangles`);
}
process.exit(faults === 0 ? 0 : 1);
