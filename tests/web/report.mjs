// SPDX-License-Identifier: Apache-2.0
// node report.mjs FOLDER PHOTOGRAPHS
// FOLDER/report.html: one file that asks for nothing else, whole on a phone, on a desk and on paper.
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { argv } from 'node:process';
import { pathToFileURL } from 'node:url';
import { run } from './browser.mjs';

const [folder, photographs] = argv.slice(2);
const address = pathToFileURL(join(folder, 'report.html')).href;
const complaints = [];

async function open(browser, viewport) {
  const page = await (await browser.newContext({ viewport })).newPage();
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  page.on('request', (request) => {
    if (request.url() !== address && !request.url().startsWith('data:')) complaints.push(`asked for ${request.url()}`);
  });
  await page.goto(address);
  return page;
}

// What reaches beyond the sheet sideways: its tag, and by how much.
const beyond = (page) => page.evaluate(() => {
  const width = document.documentElement.clientWidth;
  const found = [];
  for (const element of document.body.querySelectorAll('h1, h2, h3, p, li, table, svg, img, div')) {
    const scrolls = element.closest('.scroll') && element !== element.closest('.scroll');
    const box = element.getBoundingClientRect();
    if (!scrolls && box.width > 0 && box.right > width + 1) found.push(`${element.tagName}.${element.className.baseVal ?? element.className}: ${Math.round(box.right - width)} px`);
  }
  return found;
});

async function on(browser, name, viewport) {
  const page = await open(browser, viewport);
  assert.deepEqual(await beyond(page), [], `${name}: this reaches beyond the sheet`);
  const drawings = await page.locator('svg').all();
  assert.ok(drawings.length >= 5, `${name}: ${drawings.length} drawings`);
  for (const drawing of drawings) assert.ok((await drawing.boundingBox()).height > 40, `${name}: a drawing is not seen`);
  assert.ok(await page.locator('text=met').count() > 0, `${name}: there is no verdict`);
  await page.screenshot({ path: join(photographs, `report-${name}.png`), fullPage: true });
  await page.context().close();
}

async function onPaper(browser) {
  const page = await open(browser, { width: 1280, height: 800 });
  const sheet = await page.pdf({ preferCSSPageSize: true });
  const pages = sheet.toString('latin1').match(/\/Type\s*\/Page[^s]/g).length;
  assert.ok(pages >= 3 && pages <= 12, `${pages} pages of paper`);
  await writeFile(join(photographs, 'report.pdf'), sheet);
  await page.context().close();
}

await run('report', complaints, async (browser) => {
  await on(browser, 'phone', { width: 390, height: 844 });
  await on(browser, 'desk', { width: 1280, height: 800 });
  await onPaper(browser);
});
