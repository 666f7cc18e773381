// SPDX-License-Identifier: Apache-2.0
// node page_clicks.mjs desk|phone FOLDER PHOTOGRAPHS TITLE [NAME=ADDRESS...]
// Clicks through FOLDER/box.html as a person would, and photographs it. Each NAME.png, which Luxel drew, is held against
// the page at that address. Ends with 1 after the first thing that is not as it should be.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { argv } from 'node:process';
import { pathToFileURL } from 'node:url';
import { atRest, difference, drawn, launch, run, settled } from './browser.mjs';

const [screen, folder, photographs, title, ...pictures] = argv.slice(2);
const address = pathToFileURL(join(folder, 'box.html')).href;
const complaints = [];

async function open(browser, options, hash = '', file = address) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  page.setDefaultTimeout(15_000);
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  page.on('request', (asked) => /^(file|data|blob):/.test(asked.url()) || complaints.push(`the page asked for ${asked.url()}`));
  await page.goto(file + (hash && `#${hash}`));
  await settled(page);
  return page;
}

async function photograph(page, name) {
  await drawn(page);
  return page.screenshot({ path: join(photographs, `${screen}-${name}.png`) });
}

// Of a desk's window what is beside the panel, whose own marks change with every click.
const beside = screen === 'desk' ? { clip: { x: 0, y: 0, width: 970, height: 800 } } : {};

async function scene(page, name) {
  await atRest(page);
  return page.screenshot({ path: join(photographs, `${screen}-${name}.png`), ...beside });
}

// The scene must look otherwise than before: by a mean difference, where it is given; else at all, for the software
// renderer draws the same twice.
async function changes(page, before, name, least = 0) {
  const after = await scene(page, name);
  const change = least > 0 ? await difference(page, before, after) : before.equals(after) ? 0 : 1;
  assert.ok(change > least, `${name}: nothing changed (${change})`);
  return after;
}

const numberIn = (text) => Number(text.match(/-?[\d.]+/)[0]);

async function compare(browser) {
  const page = await open(browser, { viewport: { width: 640, height: 480 } }, 'panel=off');
  for (const each of pictures) {
    const [name, hash] = [each.slice(0, each.indexOf('=')), each.slice(each.indexOf('=') + 1)];
    await page.evaluate((to) => (location.hash = to), `panel=off&${hash}`);
    await drawn(page);
    const shot = await photograph(page, `as-${name}`);
    const off = await difference(page, shot, await readFile(join(folder, `${name}.png`)));
    console.log(`${name}: mean difference to Luxel's picture ${(100 * off).toFixed(3)} %`);
    assert.ok(off < 0.01, `${name}: the page differs from Luxel's picture by ${(100 * off).toFixed(2)} %`);
  }
  await page.context().close();
}

// Textures within patches, holes, and the sky behind them; the hole lets a click through.
async function compareTextures(browser) {
  const file = pathToFileURL(join(folder, 'textured.html')).href;
  const page = await open(browser, { viewport: { width: 640, height: 480 } }, 'panel=off&seeThrough=off', file);
  const shot = await photograph(page, 'textured');
  const off = await difference(page, shot, await readFile(join(folder, 'textured.png')));
  console.log(`textures and sky: mean difference to Luxel's picture ${(100 * off).toFixed(3)} %`);
  assert.ok(off < 0.01, `textures: the page differs from Luxel's picture by ${(100 * off).toFixed(2)} %`);
  // Light that is not divided among lamps has a slider, too.
  assert.equal(await page.locator('#lamp-list input[type=range]').count(), 1);
  for (const [x, y, material] of [[285, 210, 'screen'], [254, 270, 'wall'], [120, 250, 'wall']]) {
    await page.mouse.click(x, y);
    assert.equal(await page.locator('#card-material').innerText(), material);
    await page.waitForTimeout(400); // no double click
  }
  await page.context().close();
}

async function clickLook(page) {
  let last = await scene(page, 'begin');
  const set = async (label, value) => page.getByLabel(label, { exact: true }).fill(value);
  await set('Exposure, stops', '2');
  assert.match(await page.locator('#exposure-text').innerText(), /\+2\.00/);
  last = await changes(page, last, 'brighter');
  assert.ok(await page.locator('#white-row').isHidden());
  await page.getByText('More', { exact: true }).click();
  await page.getByLabel('Tone curve').selectOption('reinhard');
  last = await changes(page, last, 'reinhard');
  await set('White at', '1.5');
  last = await changes(page, last, 'white');
  await page.getByLabel('Tone curve').selectOption('clamp');
  last = await changes(page, last, 'clamp');
  assert.ok(await page.locator('#white-row').isHidden());
  await page.getByLabel('Tone curve').selectOption('maximum');
  last = await changes(page, last, 'maximum');
  await page.getByLabel('Tone curve').selectOption('reinhard');
  await set('Exposure, stops', '0');
  await set('White at', '0');
  last = await scene(page, 'again');
  await set('Brightness of lamp', '0');
  last = await changes(page, last, 'lamp-off');
  await page.getByText('Adapt to the view').click();
  last = await changes(page, last, 'adapted');
  await set('Colour of side', '#ff3020');
  last = await changes(page, last, 'tinted');
  assert.match(await page.locator('#lamp-list').innerText(), /side\s*100 %/);
  await page.getByRole('button', { name: 'Reset' }).click();
  assert.ok(await page.getByRole('button', { name: 'Reset' }).isDisabled());
  await page.getByText('Adapt to the view').click();
}

async function clickFalseColours(page) {
  await page.locator('#panel').getByText('Illuminance', { exact: true }).click();
  let last = await scene(page, 'illuminance');
  assert.match(await page.locator('#legend').innerText(), /Illuminance, lux/);
  const marks = (await page.locator('#legend-marks').innerText()).split(/\s+/).map(Number);
  const step = marks[2] - marks[1];
  assert.ok(marks.length >= 5 && marks.every((value) => Math.abs(value / step - Math.round(value / step)) < 0.01), `marks at ${marks}`);
  assert.match(String(step), /^0?\.?0*(1|2|25|5)0*$/, `marks at ${marks}`);
  const numbers = page.locator('#line-numbers.rests');
  await numbers.waitFor();
  assert.ok(Number(await numbers.getAttribute('data-numbers')) >= 5, 'few numbers on the lines');
  await page.locator('#panel').getByText('Logarithmic').click();
  last = await changes(page, last, 'logarithmic');
  await page.locator('#panel').getByText('Contour lines').click();
  last = await changes(page, last, 'no-lines');
  await page.locator('#panel').getByText('Automatic scale').click();
  await page.locator('#panel').getByText('Logarithmic').click();
  await page.locator('#low').fill('50');
  await page.locator('#high').fill('20');
  assert.match(await page.getByRole('alert').innerText(), /more than/);
  await page.locator('#high').fill('150');
  assert.ok(await page.locator('#scale-fault').isHidden());
  last = await changes(page, last, 'own-scale');
  assert.match(await page.locator('#legend-marks').innerText(), /150/);
  await photograph(page, 'scale');
  await page.locator('#unit-choice').getByText('W/m²').click();
  assert.match(await page.locator('#legend').innerText(), /Irradiance, W\/m²/);
  await page.locator('#panel').getByText('Picture', { exact: true }).click();
  assert.ok(await page.locator('#legend').isHidden());
}

// What the card says of a point: { lux, error, watts, material }.
async function card(page) {
  const [, lux, error] = (await page.locator('#card-value').innerText()).match(/([\d.]+) ± ([\d.]+) lux/);
  return { lux: Number(lux), error: Number(error), watts: numberIn(await page.locator('#card-watts').innerText()),
           material: await page.locator('#card-material').innerText() };
}

async function clickProbe(page) {
  await page.mouse.click(500, 420); // the tall block, or the wall behind
  assert.ok(await page.locator('#card').isVisible());
  const solved = await card(page);
  assert.equal(solved.material, 'white');
  assert.ok(solved.error > 0 && solved.error < solved.lux, `an error of ${solved.error} at ${solved.lux} lux`);
  const lumens = solved.lux / solved.watts; // of a watt: between those of blue and of green
  assert.ok(lumens > 179 * 0.0722 && lumens < 179 * 0.7152, `${lumens} lm/W`);
  await photograph(page, 'probe');
  const slider = (name) => page.getByLabel(`Brightness of ${name}`);
  await slider('lamp').fill('0');
  const side = (await card(page)).lux;
  await slider('side').fill('0');
  await slider('lamp').fill('1');
  const lamp = (await card(page)).lux;
  assert.ok(Math.abs(side + lamp - solved.lux) < 0.01 * solved.lux, `${side} + ${lamp} is not ${solved.lux}`);
  await slider('lamp').fill('2');
  assert.ok(Math.abs((await card(page)).lux - 2 * lamp) < 0.01 * lamp);
  await page.getByRole('button', { name: 'Reset' }).click();
  await page.keyboard.press('Escape');
  assert.ok(await page.locator('#card').isHidden());
}

async function clickCamera(page) {
  let last = await scene(page, 'home');
  await page.mouse.move(420, 500);
  await page.mouse.down();
  await page.mouse.move(640, 420, { steps: 5 });
  await page.mouse.up();
  last = await changes(page, last, 'turned');
  await page.getByText('See through walls').click();
  last = await changes(page, last, 'solid');
  await page.getByText('See through walls').click();
  await page.mouse.wheel(0, -300);
  last = await changes(page, last, 'closer');
  await page.keyboard.press('h');
  last = await changes(page, last, 'home-again');
  await page.mouse.move(400, 500);
  await page.keyboard.press('f');
  last = await changes(page, last, 'focused');
  await page.getByRole('button', { name: 'Start view' }).click();
  await page.locator('#panel').getByText('Walk', { exact: true }).click();
  await page.locator('#view').focus();
  await page.keyboard.down('w');
  await page.waitForTimeout(600);
  await page.keyboard.up('w');
  last = await changes(page, last, 'walked', 0.01);
  await page.mouse.move(300, 480);
  await page.mouse.down();
  await page.mouse.move(500, 460, { steps: 4 });
  await page.mouse.up();
  last = await changes(page, last, 'looked-around', 0.02);
  await page.getByRole('button', { name: 'Copy link' }).click();
  const link = page.url();
  assert.match(link, /eye=.*mode=walk/);
  const shot = await photograph(page, 'linked');
  await page.goto('about:blank');
  await page.goto(link);
  await settled(page);
  assert.equal(await page.locator('input[name=mode]:checked').inputValue(), 'walk');
  await page.getByLabel('Exposure, stops').focus();
  const again = await photograph(page, 'from-link');
  assert.ok((await difference(page, shot, again)) < 0.15, 'the link shows another place');
  await page.locator('#view').focus();
  await page.keyboard.press('i');
  assert.ok(await page.locator('#legend').isVisible());
  await page.keyboard.press('?');
  assert.match(await page.getByRole('dialog').innerText(), /Measure[^]*click or tap[^]*Walk/);
  await photograph(page, 'help');
  await page.keyboard.press('Escape');
  assert.ok(await page.locator('#help').isHidden());
  await page.keyboard.press('p');
  assert.equal(await page.locator('#fold').getAttribute('aria-expanded'), 'false');
}

async function desk(browser) {
  await compare(browser);
  await compareTextures(browser);
  const page = await open(browser, { viewport: { width: 1280, height: 800 } });
  assert.equal(await page.title(), title);
  assert.equal(await page.locator('h1').innerText(), title);
  assert.match(await page.locator('#made').innerText(), /Made with Luxel .*\d\u00a0%.*triangles/);
  assert.match(await page.locator('#mode-help').innerText(), /wheel.*[Cc]lick/);
  await photograph(page, 'whole');
  await clickLook(page);
  await clickFalseColours(page);
  await clickProbe(page);
  await clickCamera(page);
  await page.context().close();
}

async function phone(browser) {
  const page = await open(browser, { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true });
  let last = await scene(page, 'begin');
  const widest = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(widest <= 390, `the page is ${widest} pixels wide`);
  assert.ok(await page.locator('#sheet').isHidden());
  await page.locator('#fold').tap();
  last = await changes(page, last, 'sheet');
  assert.doesNotMatch(await page.locator('#mode-help').innerText(), /mouse|wheel|Shift/, 'a finger has none of these');
  await page.locator('#panel').getByText('Illuminance', { exact: true }).tap();
  await page.locator('#fold').tap();
  last = await changes(page, last, 'illuminance');
  const [picture, legend] = await Promise.all(['#view', '#legend'].map((id) => page.locator(id).boundingBox()));
  assert.ok(legend.y >= picture.y + picture.height - 0.5 && legend.y + legend.height <= 844, 'the legend covers the picture');
  assert.ok(picture.height > 600, `the picture is ${picture.height} pixels high`);
  await page.touchscreen.tap(195, 420);
  assert.ok((await card(page)).lux > 0);
  last = await changes(page, last, 'probe');
  await page.getByRole('button', { name: 'Close the measurement' }).tap();
  const touch = await page.context().newCDPSession(page);
  const finger = (type, ...points) => touch.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  await finger('touchStart', [120, 400]);
  for (let i = 1; i <= 5; ++i) await finger('touchMove', [120 + 25 * i, 400 + 8 * i]);
  await finger('touchEnd');
  last = await changes(page, last, 'turned');
  await finger('touchStart', [170, 420], [220, 420]);
  for (let i = 1; i <= 5; ++i) await finger('touchMove', [170 - 15 * i, 420], [220 + 15 * i, 420]);
  await finger('touchEnd');
  last = await changes(page, last, 'pinched');
  await page.locator('#fold').tap();
  await page.locator('#panel').getByText('Walk', { exact: true }).tap();
  await page.getByRole('button', { name: 'Start view' }).tap();
  await page.locator('#panel').getByText('Picture', { exact: true }).tap();
  await page.locator('#fold').tap();
  last = await scene(page, 'walk');
  const pad = await page.locator('#pad').boundingBox();
  const middle = [pad.x + pad.width / 2, pad.y + pad.height / 2];
  await finger('touchStart', middle);
  await finger('touchMove', [middle[0] + 5, middle[1] - 50]);
  await page.waitForTimeout(700);
  await finger('touchEnd');
  last = await changes(page, last, 'walked');
  await page.context().close();

  const without = await open(await launch(['--disable-3d-apis']), { viewport: { width: 390, height: 844 } });
  assert.match(await without.locator('#message').innerText(), /needs WebGL 2/);
  await photograph(without, 'without-webgl');
  await without.context().browser().close();
}

// Its policy lets no script run but its own, whatever a name in the scene holds, and no address be asked.
async function refusal(browser) {
  const page = await open(browser, { viewport: { width: 640, height: 480 } });
  const before = complaints.splice(0);
  const found = await page.evaluate(async () => {
    const script = document.createElement('script');
    script.textContent = 'window.intruder = true';
    document.body.append(script);
    document.body.insertAdjacentHTML('beforeend', '<b id="bait" onclick="window.intruder = true">x</b>');
    document.getElementById('bait').click();
    const refused = new Promise((tell) =>
      document.addEventListener('securitypolicyviolation', ({ effectiveDirective }) => effectiveDirective === 'connect-src' && tell(true)));
    fetch('http://127.0.0.1:9/').catch(() => {});
    return { refused: await refused, intruder: window.intruder ?? false };
  });
  assert.deepEqual(found, { refused: true, intruder: false });
  complaints.splice(0, complaints.length, ...before);
  await page.context().close();
}

await run(screen, complaints, async (browser) => {
  await (screen === 'desk' ? desk : phone)(browser);
  if (screen === 'desk') await refusal(browser);
}, ['--force-color-profile=srgb']);
