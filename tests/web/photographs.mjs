// SPDX-License-Identifier: Apache-2.0
// node photographs.mjs PAGE.html FOLDER
// The pictures of docs/html-pages.md: what a person sees at a desk and on a phone.
import { join, resolve } from 'node:path';
import { argv } from 'node:process';
import { pathToFileURL } from 'node:url';
import { atRest, launch, settled } from './browser.mjs';

const [html, folder] = argv.slice(2);
const desk = { viewport: { width: 1120, height: 800 } };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const pictures = {
  'sharing-light': { screen: desk },
  'sharing-illuminance': { screen: desk, hash: 'show=illuminance', clicks: (page) => page.mouse.click(330, 640) },
  'sharing-lamps': { screen: desk, hash: 'lamps=0.15,0.15,0.15;1.2,0.5,0.2' },
  'sharing-walk': { screen: desk, hash: 'mode=walk&eye=0.2,0.3,-0.05&target=-0.2,0.2,-0.5&fov=65' },
  'sharing-phone': { screen: phone },
  'sharing-phone-sheet': { screen: phone, hash: 'lamps=1,0.6,0.3;0.4,0.4,0.4', clicks: (page) => page.locator('#fold').tap() },
  'sharing-phone-probe': { screen: phone, hash: 'show=illuminance', clicks: (page) => page.touchscreen.tap(90, 420) },
};

const browser = await launch();
for (const [name, { screen, hash = '', clicks }] of Object.entries(pictures)) {
  const context = await browser.newContext(screen);
  const page = await context.newPage();
  await page.goto(`${pathToFileURL(resolve(html)).href}#${hash}`);
  await settled(page, 'html[data-state=ready]');
  await clicks?.(page);
  await atRest(page);
  await page.screenshot({ path: join(folder, `${name}.png`) });
  await context.close();
}
await browser.close();
