// SPDX-License-Identifier: Apache-2.0
// Tone curves: those of image/tone.cpp, so that the page shows what `luxel render` writes.

// Exposure included: what radiance is multiplied by. light: { logAverage, litAverage, bright, largest } of what is in view.
export function toneScale({ op, exposure, key }, light) {
  if (!(light.largest > 0)) return 1;
  const stops = 2 ** exposure;
  if (op === 'maximum') return stops / light.largest;
  if (op === 'clamp') return stops;
  const isNeutral = op === 'neutral', average = isNeutral ? light.litAverage : light.logAverage;
  const automatic = isNeutral ? Math.min(Math.max((0.6 * average) / light.bright, 0.25), 0.5) : 0.18;
  return (stops * (key === 'auto' ? automatic : key)) / average;
}

const roundings = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8];
const simpleRoundings = [1, 2, 5];

// A round number, not below the value; not above where `down`.
export function rounded(value, steps = roundings, down = false) {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  const clean = (step) => Number((step * power).toPrecision(3));
  if (down) return clean(steps.filter((step) => step * power <= value * 1.0001).pop() ?? 1);
  return clean(steps.find((step) => step * power >= value * 0.9999) ?? 10);
}

// sRGB codes at equal steps: "inferno" of N. Smith and S. van der Walt (CC0).
export const heat = [0x000004, 0x210c4a, 0x57106e, 0x8a226a, 0xbc3754, 0xe45a31, 0xf98e09, 0xf9cb35, 0xfcffa4];

// A scale with round ends. Its upper end holds 97 % of the surfaces, so that the surroundings of a lamp do not darken the
// rest. samples: [{ value, area }].
export function automaticScale(samples, logarithmic) {
  const some = samples.filter(({ value }) => Number.isFinite(value) && value > 0).sort((a, b) => a.value - b.value);
  const total = some.reduce((sum, { area }) => sum + area, 0);
  const quantile = (share) => {
    let below = 0;
    return some.find(({ area }) => (below += area) >= share * total)?.value ?? 0;
  };
  const top = quantile(0.97);
  const high = top > 0 ? rounded(top) : 1;
  if (!logarithmic) return { low: 0, high };
  const bottom = quantile(0.03);
  const low = bottom > 0 ? Math.max(rounded(bottom, simpleRoundings, true), high * 1e-6) : high * 1e-3;
  return { low: low < high ? low : high * 0.1, high };
}

// Round values between the ends of a scale: five to ten of them, or on a logarithmic scale 1, 2 and 5 times powers of ten.
export function levelsOf({ low, high }, logarithmic) {
  const levels = [];
  const add = (value) => value > low + 1e-6 * (high - low) && value < high * (1 - 1e-6) && levels.push(value);
  if (logarithmic) {
    const steps = high / low > 2000 ? [1] : simpleRoundings;
    for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power)
      for (const step of steps) add(Number((step * 10 ** power).toPrecision(2)));
  } else {
    const step = rounded((high - low) / 10, [1, 2, 2.5, 5]);
    for (let i = Math.ceil(low / step); i * step <= high; ++i) add(Number((i * step).toPrecision(6)));
  }
  return levels.slice(0, 16);
}

// Where a value lies between the ends, 0 to 1.
export function shareOf(value, { low, high }, logarithmic) {
  return logarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
}

// Three digits.
export function numberText(value) {
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-3) return value.toExponential(2);
  return String(Number(value.toPrecision(3)));
}
