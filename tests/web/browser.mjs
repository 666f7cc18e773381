// SPDX-License-Identifier: Apache-2.0
// A headless browser that draws in software: the same picture on every machine, with no need for a graphics card.
import assert from 'node:assert/strict';
import { env, exit } from 'node:process';
import { chromium } from 'playwright-core';

export function launch(more = []) {
  return chromium.launch({
    executablePath: env.CHROMIUM ?? '/usr/bin/chromium',
    headless: true,
    args: [
      '--no-sandbox',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--disable-background-networking',
      '--disable-component-update',
      '--no-first-run',
      ...more,
    ],
  });
}

// Runs checks(browser), of which `what` is said at the end; what fails, and what pages complained of, ends the program with 1.
export async function run(what, complaints, checks, more = []) {
  const browser = await launch(more);
  try {
    await checks(browser);
    assert.deepEqual(complaints, []);
  } catch (error) {
    console.error(error.message, complaints);
    exit(1);
  } finally {
    await browser.close();
  }
  console.log(`${what}: all as it should be`);
}

// Waits until Luxel's page has said how it is. Not page.waitForFunction, which evaluates a string in the page: its content
// security policy refuses that.
export function settled(page, state = 'html[data-state]') {
  return page.waitForSelector(state, { state: 'attached', timeout: 60_000 });
}

// Two frames later: what was asked for is drawn then.
export const drawn = (page) => page.evaluate(() => new Promise((done) =>
  requestAnimationFrame(() => requestAnimationFrame(done))));

// What was asked for is drawn, smoothed and shown: the same picture every time, however long the frames take.
export async function atRest(page) {
  await drawn(page);
  await settled(page, 'html[data-picture=smooth]');
  await drawn(page);
}

// Mean difference of two pictures of one size, all channels alike, as a share of the display's range; computed by the
// browser, which can read every picture. a, b: bytes of PNG files; covered: count only the pixels that surfaces cover
// on the page's transparent canvas.
export function difference(page, a, b, covered = false) {
  return page.evaluate(async ([first, second, isMasked]) => {
    const pixels = async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }), { colorSpaceConversion: 'none' });
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      canvas.drawImage(bitmap, 0, 0);
      return canvas.getImageData(0, 0, bitmap.width, bitmap.height);
    };
    const [p, q] = await Promise.all([pixels(first), pixels(second)]);
    if (p.width !== q.width || p.height !== q.height)
      throw new Error(`pictures of ${p.width} x ${p.height} and ${q.width} x ${q.height}`);
    let mask = null;
    if (isMasked) {
      const copy = new OffscreenCanvas(p.width, p.height).getContext('2d');
      copy.drawImage(document.querySelector('canvas'), 0, 0);
      mask = copy.getImageData(0, 0, p.width, p.height).data;
    }
    let sum = 0, count = 0;
    for (let i = 0; i < p.data.length; i += 4) {
      if (mask && mask[i + 3] < 255) continue;
      for (let c = i; c < i + 3; ++c) sum += Math.abs(p.data[c] - q.data[c]);
      count += 3;
    }
    return sum / (255 * Math.max(1, count));
  }, [a.toString('base64'), b.toString('base64'), covered]);
}
