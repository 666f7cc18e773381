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

function neutral(scaled) {
  const start = 0.76, peak = Math.max(...scaled);
  if (peak <= start) return scaled;
  const top = 1 - (1 - start) ** 2 / (peak + 1 - 2 * start);
  const toWhite = 1 - 1 / (0.15 * (peak - top) + 1);
  return scaled.map((c) => (c * top) / peak + (top - (c * top) / peak) * toWhite);
}

const encode = (c) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);

// A linear colour as the curve shows it, sRGB codes in [0, 1]: for what no surface is drawn on.
export function shown(colour, { op, white }, scale) {
  const [r, g, b] = colour.map((c) => Math.max(0, c));
  if (op === 'neutral') return neutral([r, g, b].map((c) => scale * c)).map((c) => encode(Math.min(1, c)));
  const L = scale * (0.2126 * r + 0.7152 * g + 0.0722 * b);
  const factor = op === 'reinhard' ? (scale * (white > 0 ? 1 + L / (white * white) : 1)) / (1 + L) : scale;
  return [r, g, b].map((c) => encode(Math.min(1, factor * c)));
}

// 1, 2 or 5 times a power of ten, not below the value.
export function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  for (const step of [1, 2, 5]) if (step * power >= value * 0.9999) return step * power;
  return 10 * power;
}

// sRGB codes at equal steps: "inferno" of N. Smith and S. van der Walt (CC0).
export const heat = [0x000004, 0x210c4a, 0x57106e, 0x8a226a, 0xbc3754, 0xe45a31, 0xf98e09, 0xf9cb35, 0xfcffa4];

// A scale whose end is round and holds 98 in 100 of the values, so that a lone lamp does not darken the rest.
export function automaticScale(values, logarithmic) {
  const some = values.filter((v) => Number.isFinite(v) && (v > 0 || !logarithmic)).sort((a, b) => a - b);
  const quantile = (share) => some[Math.floor(share * (some.length - 1))] ?? 0;
  const top = quantile(0.98);
  const high = top > 0 ? roundUp(top) : 1;
  if (!logarithmic) return { low: 0, high };
  const bottom = quantile(0.02);
  const low = bottom > 0 ? Math.max(0.5 * roundUp(bottom), high * 1e-6) : high * 1e-3;
  return { low: low < high ? low : high * 0.1, high };
}

// Three digits.
export function numberText(value) {
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-3) return value.toExponential(2);
  return String(Number(value.toPrecision(3)));
}
