// SPDX-License-Identifier: Apache-2.0
import { heat, numberText } from './tone.js';

const element = (id) => document.getElementById(id);

// The bar of colours with its numbers, at the steps of the lines of equal light.
export function drawLegend(look, scale) {
  element('legend').hidden = look.show !== 'illuminance';
  const colours = heat.map((rgb) => `#${rgb.toString(16).padStart(6, '0')}`);
  element('legend-title').textContent = look.unit === 'lux' ? 'Illuminance, lux' : 'Irradiance, W/m²';
  element('legend-bar').style.background = `linear-gradient(to top, ${colours.join(',')})`;
  const marks = element('legend-marks');
  marks.replaceChildren();
  for (let i = 0; i <= 10; i += 2) {
    const share = i / 10;
    const value = look.logarithmic ? scale.low * (scale.high / scale.low) ** share
      : scale.low + share * (scale.high - scale.low);
    const mark = document.createElement('span');
    mark.textContent = numberText(value);
    mark.style.bottom = `${100 * share}%`;
    marks.append(mark);
  }
}
