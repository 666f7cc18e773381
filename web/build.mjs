// SPDX-License-Identifier: Apache-2.0
// node build.mjs SOURCES MODULES OUT.cpp
// Bundles the page with what npm put into MODULES, and writes it as C++ that the program is built with.
import { createHash } from 'node:crypto';
import { readFile, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { argv } from 'node:process';

const [sources, modules, out] = argv.slice(2);
const require = createRequire(join(modules, 'here.js'));
const { build } = require('esbuild');
const source = (name) => readFile(join(sources, name), 'utf8');

const bundle = await build({
  entryPoints: [join(sources, 'main.js')],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  legalComments: 'none', // the whole licence stands above the script
  nodePaths: [modules],
  logLevel: 'error',
  write: false,
});
const licence = (await readFile(join(modules, 'three', 'LICENSE'), 'utf8')).trim();
const version = JSON.parse(await readFile(join(modules, 'three', 'package.json'), 'utf8')).version;
const script = `/*\nthree.js ${version}, in this script:\n\n${licence}\n\nAll else: Luxel, Apache-2.0.\n*/\n${bundle.outputFiles[0].text}`;

// A function, so that no $ of the text is read as a pattern; and nothing may end the script but its own tag.
let page = (await source('index.html')).replaceAll('\n\n', '\n');
const style = (await source('style.css')).trim();
const code = script.trim().replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
// Nothing runs, and nothing is fetched, but what stands in the file.
const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
page = page.replace('@POLICY@', () => `default-src 'none'; script-src ${hash(code)}; style-src ${hash(style)}; img-src data: blob:; base-uri 'none'; form-action 'none'`);
page = page.replace('@STYLE@', () => style);
page = page.replace('@SCRIPT@', () => code);

// Words of eight bytes: a compiler reads a hundred thousand numbers, not a million.
const bytes = Buffer.from(page);
const words = [];
for (let i = 0; i < bytes.length; i += 8) {
  const word = Buffer.alloc(8);
  bytes.copy(word, 0, i, Math.min(i + 8, bytes.length));
  words.push(`0x${word.readBigUInt64LE().toString(16)}`);
}
await writeFile(out, `// SPDX-License-Identifier: Apache-2.0
// Made by web/build.mjs.
#include "luxel/export/page_template.h"

#include <cstdint>

namespace luxel {
namespace {

constexpr std::uint64_t words[] = {
${words.join(',').replace(/(.{1,110}),/g, '$1,\n')}};

}  // namespace

std::string_view page_template() { return {reinterpret_cast<const char*>(words), ${bytes.length}}; }
std::string_view page_obstacle() { return {}; }

}  // namespace luxel
`);
