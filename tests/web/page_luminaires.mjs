// SPDX-License-Identifier: Apache-2.0
// node page_luminaires.mjs FOLDER PHOTOGRAPHS
// FOLDER/luminaires.html: openings are those of Luxel's pictures, solids are on a key, sliders dim, colours keep lumens.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { argv } from 'node:process';
import { pathToFileURL } from 'node:url';
import { atRest, difference, run, settled } from './browser.mjs';

const [folder, photographs] = argv.slice(2);
const address = pathToFileURL(join(folder, 'luminaires.html')).href;
const complaints = [];

async function open(browser, hash, viewport = { width: 640, height: 480 }) {
  const page = await (await browser.newContext({ viewport })).newPage();
  page.setDefaultTimeout(15_000);
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  await page.goto(`${address}#${hash}`);
  await settled(page);
  return page;
}

async function photograph(page, name) {
  await atRest(page);
  return page.screenshot({ path: join(photographs, `luminaires-${name}.png`) });
}

// Where everything but an opening is dark, and with light of other colours.
async function compare(browser) {
  for (const [name, hash] of [['plain', ''], ['dark', 'op=clamp&exposure=-6'], ['relit', 'op=clamp&exposure=-6&lamps=0.5,0.5,0.5;0,0,0']]) {
    const page = await open(browser, `panel=off&${hash}`);
    const off = await difference(page, await photograph(page, name), await readFile(join(folder, `luminaires-${name}.png`)));
    console.log(`${name}: mean difference to Luxel's picture ${(100 * off).toFixed(3)} %`);
    assert.ok(off < 0.005, `${name}: the page differs from Luxel's picture by ${(100 * off).toFixed(2)} %`);
    await page.context().close();
  }
}

const lumensIn = (text) => Number(text.match(/, (\d+) lm/)[1]);

async function click(browser) {
  const page = await open(browser, '', { width: 1280, height: 800 });
  const plain = await photograph(page, 'panel');
  await page.keyboard.press('c');
  const solids = await photograph(page, 'solids');
  assert.ok(await difference(page, plain, solids) > 2e-3, 'C shows no solids');
  assert.ok(await page.locator('#solids').isChecked());
  await page.keyboard.press('c');
  assert.ok(plain.equals(await photograph(page, 'again')), 'C does not hide the solids');
  // The lamp is named, and its colour changes no lumens.
  const [x, y] = [165, 240];
  await page.mouse.click(x, y);
  const named = async () => page.locator('#card-luminaire').innerText();
  assert.match(await named(), /^panel, /);
  const own = lumensIn(await named());
  await page.getByLabel('Colour of panel').fill('#ff4020');
  assert.ok(Math.abs(lumensIn(await named()) - own) <= 1, `coloured: ${await named()}, not ${own} lm`);
  const coloured = await photograph(page, 'coloured');
  assert.ok(await difference(page, plain, coloured) > 5e-3, 'the colour is not seen');
  await page.getByLabel('Brightness of panel').fill('0.5');
  assert.ok(Math.abs(lumensIn(await named()) - 0.5 * own) <= 1, `dimmed: ${await named()}, not half of ${own} lm`);
  assert.match(await page.locator('#lamp-list output').first().innerText(), /^50 %$/);
  await page.keyboard.press('c');
  await photograph(page, 'dimmed');
  await page.context().close();
}

await run('luminaires', complaints, async (browser) => {
  await compare(browser);
  await click(browser);
}, ['--force-color-profile=srgb']);
