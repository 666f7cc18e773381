// SPDX-License-Identifier: Apache-2.0
// node validate.mjs FILE.glb...
// Asks the Khronos validator about each file. Any error or warning fails; infos and hints are only printed.
import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import { argv, exit } from 'node:process';
import validator from 'gltf-validator';

const mostOfAKind = 10; // issues that are printed
const severities = ['error', 'warning', 'info', 'hint'];

async function isValid(file) {
  const bytes = new Uint8Array(await readFile(file));
  // All of them: what is beyond a limit is not counted either.
  const { issues, info } = await validator.validateBytes(bytes, { uri: basename(file), maxIssues: 0 });
  const seen = new Map();
  for (const { severity, code, message, pointer } of issues.messages) {
    const count = (seen.get(code) ?? 0) + 1;
    seen.set(code, count);
    if (count <= mostOfAKind)
      console.log(`${file}: ${severities[severity]}: ${pointer ?? ''} ${code}: ${message}`);
  }
  for (const [code, count] of seen)
    if (count > mostOfAKind) console.log(`${file}: ${code}: ${count} of these`);
  console.log(
    `${file}: ${issues.numErrors} errors, ${issues.numWarnings} warnings; ` +
      `${info.totalTriangleCount} triangles, ${info.totalVertexCount} vertices, ${info.materialCount} materials`,
  );
  return issues.numErrors === 0 && issues.numWarnings === 0;
}

const files = argv.slice(2);
if (files.length === 0) {
  console.error('usage: node validate.mjs FILE.glb...');
  exit(2);
}
let allValid = true;
for (const file of files) allValid = (await isValid(file)) && allValid;
exit(allValid ? 0 : 1);
