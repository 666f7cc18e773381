// SPDX-License-Identifier: Apache-2.0
// node page.mjs FILE.glb OUT.png [--with three|babylon] [--eye X,Y,Z] [--target X,Y,Z] [--fov DEGREES] [--size 800x600]
//   [--like PICTURE.png]
// Shows the file on the page of examples/web (three.js or Babylon.js, in Debian's Chromium, headless) and photographs it. Eye
// and target are in glTF's axes, Y up. Fails if the page has an error, or the picture is black or of one colour, or differs from
// PICTURE by 1 % of the display's range or more, in the mean over the pixels that surfaces cover.
import { readFile, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { dirname, extname, join, normalize } from 'node:path';
import { exit } from 'node:process';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { difference, launch } from './browser.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const types = { '.html': 'text/html', '.js': 'text/javascript', '.glb': 'model/gltf-binary' };

const examples = join(here, '..', '..', 'examples', 'web');

// Each surface has its light with it: shadeless, from a lightmap, or black and shining. Run in the page.
const findings = {
  three: async () => {
    const { scene, triangles } = await window.shown;
    const isAlone = ({ isMeshBasicMaterial, lightMap, emissiveMap, emissive, color, opacity }) =>
      isMeshBasicMaterial || lightMap || opacity === 0 || ((emissiveMap || emissive.getHex() > 0) && color.getHex() === 0);
    let alone = true;
    scene.traverse((part) => (alone &&= !part.isMesh || Boolean(isAlone(part.material))));
    return { alone, triangles };
  },
  babylon: async () => {
    const { scene } = await window.shown;
    const isAlone = ({ unlit, emissiveTexture, emissiveColor, albedoColor }) =>
      unlit || emissiveTexture || (emissiveColor?.toLuminance() > 0 && albedoColor.toLuminance() === 0);
    const triangles = scene.meshes.reduce((sum, mesh) => sum + (mesh.getTotalIndices?.() ?? 0) / 3, 0);
    return { alone: scene.materials.every((material) => Boolean(isAlone(material))), triangles };
  },
};

// Serves the page, the model and the libraries to this machine alone; nothing else can be asked for.
function serve(glb, page) {
  const server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
    const file =
      path === '/' ? join(examples, page)
      : path === '/model.glb' ? glb
      : /^\/node_modules\/(three|babylonjs|babylonjs-loaders)\//.test(path) ? join(here, path)
      : null;
    const bytes = file && (await readFile(file).catch(() => null));
    response.writeHead(bytes ? 200 : 404, { 'content-type': types[extname(file ?? '')] ?? 'text/plain' });
    response.end(bytes ?? '');
  });
  return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(server)));
}

// Mean and spread of the brightness in the drawn picture, 0 to 255, as the page itself sees it.
function statistics(page) {
  return page.evaluate(() => {
    const source = document.querySelector('canvas');
    const copy = new OffscreenCanvas(source.width, source.height).getContext('2d');
    copy.drawImage(source, 0, 0);
    const { data } = copy.getImageData(0, 0, source.width, source.height);
    let sum = 0, squares = 0;
    for (let i = 0; i < data.length; i += 4) {
      const grey = (data[i] + data[i + 1] + data[i + 2]) / 3;
      sum += grey;
      squares += grey * grey;
    }
    const count = data.length / 4;
    const mean = sum / count;
    return { mean, spread: Math.sqrt(Math.max(0, squares / count - mean * mean)) };
  });
}

async function photograph(url, out, library, size, like) {
  const browser = await launch();
  try {
    const page = await browser.newPage({ viewport: { width: size[0], height: size[1] } });
    const complaints = [];
    page.on('pageerror', (error) => complaints.push(String(error)));
    page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
    await page.goto(url);
    await page.waitForFunction('window.shown', null, { timeout: 60_000 });
    const result = await page.evaluate(findings[library]).catch((error) => ({ error: error.message }));
    const shot = await page.screenshot({ path: out });
    const off = like ? await difference(page, shot, await readFile(like), true) : 0;
    return { ...result, ...(await statistics(page)), off, complaints };
  } finally {
    await browser.close();
  }
}

function verdict({ error, alone, triangles, mean, spread, off, complaints }) {
  if (error) return `the page failed: ${error}`;
  if (complaints.length > 0) return `the page complained: ${complaints.join('; ')}`;
  if (!alone) return 'a material waits for a lamp';
  if (triangles === 0) return 'no triangle was drawn';
  if (mean < 1) return 'the picture is black';
  if (spread < 1) return 'the picture is of one colour';
  if (off >= 0.01) return 'that is not the picture it should be like';
  return null;
}

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    with: { type: 'string', default: 'three' }, eye: { type: 'string' }, target: { type: 'string' }, fov: { type: 'string' },
    size: { type: 'string', default: '800x600' }, like: { type: 'string' },
  },
});
const [glb, out] = positionals;
if (positionals.length !== 2 || !findings[values.with] || !(await stat(glb).catch(() => null))) {
  console.error('usage: node page.mjs FILE.glb OUT.png [--with three|babylon] [--eye X,Y,Z] [--target X,Y,Z] [--fov DEGREES] [--size WxH] [--like PNG]');
  exit(2);
}
const { with: library, size, like, ...view } = values;
const server = await serve(glb, `${library}.html`);
const address = `http://127.0.0.1:${server.address().port}/?${new URLSearchParams(view)}`;
const seen = await photograph(address, out, library, size.split('x').map(Number), like);
server.close();
const wrong = verdict(seen);
console.log(
  `${glb}: ${seen.triangles ?? 0} triangles drawn, brightness ${seen.mean.toFixed(1)} +- ${seen.spread.toFixed(1)}` +
    `${like ? `, ${(100 * seen.off).toFixed(3)} % from ${like}` : ''}${wrong ? `: ${wrong}` : ''}`,
);
exit(wrong ? 1 : 0);
