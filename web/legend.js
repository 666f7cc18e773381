// SPDX-License-Identifier: Apache-2.0
import { heat, levelsOf, numberText, shareOf } from './tone.js';

const element = (id) => document.getElementById(id);
const closest = 0.085; // of the bar, between two numbers

// The bar of colours with the values of the lines of equal light.
export function drawLegend(look, scale) {
  element('legend').hidden = look.show !== 'illuminance';
  const colours = heat.map((rgb) => `#${rgb.toString(16).padStart(6, '0')}`);
  element('legend-title').textContent = look.unit === 'lux' ? 'Illuminance, lux' : 'Irradiance, W/m²';
  element('legend-bar').style.setProperty('--colours', colours.join(','));
  const marks = element('legend-marks');
  marks.replaceChildren();
  let last = -1;
  const values = [scale.low, ...levelsOf(scale, look.logarithmic), scale.high];
  values.forEach((value, i) => {
    const share = shareOf(value, scale, look.logarithmic);
    const isEnd = i === values.length - 1;
    if (share - last < closest || (!isEnd && i > 0 && 1 - share < closest)) return;
    last = share;
    const mark = document.createElement('span');
    mark.textContent = numberText(value);
    mark.style.setProperty('--at', `${100 * share}%`);
    marks.append(mark);
  });
}
