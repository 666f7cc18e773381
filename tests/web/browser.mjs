// SPDX-License-Identifier: Apache-2.0
// A headless browser that draws in software: the same picture on every machine, with no need for a graphics card.
import { env } from 'node:process';
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

// Mean difference of two pictures of one size, all channels alike, as a share of the display's range; computed by the
// browser, which can read every picture. a, b: bytes of PNG files; area: of the first, or null; to leave out at the rim.
export function difference(page, a, b) {
  return page.evaluate(async ([first, second]) => {
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
    let sum = 0;
    for (let i = 0; i < p.data.length; ++i) if (i % 4 !== 3) sum += Math.abs(p.data[i] - q.data[i]);
    return sum / (255 * 3 * (p.data.length / 4));
  }, [a.toString('base64'), b.toString('base64')]);
}
