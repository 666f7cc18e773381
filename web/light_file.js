// SPDX-License-Identifier: Apache-2.0
// The data in the file: a description in JSON; numbers and pictures, deflated, as text.

const version = 2;
const digits = '!#%()*+,./0123456789:;=?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[]^_abcdefghijklmnopqrstuvwxyz{|}~';

// Five characters are four bytes.
function bytesOfText(text) {
  const valueOf = new Uint8Array(128);
  for (let i = 0; i < digits.length; ++i) valueOf[digits.charCodeAt(i)] = i;
  const groups = Math.floor(text.length / 5);
  const bytes = new DataView(new ArrayBuffer(4 * groups));
  for (let g = 0, at = 0; g < groups; ++g) {
    let four = 0;
    for (let k = 0; k < 5; ++k) four = four * 85 + valueOf[text.charCodeAt(at++)];
    bytes.setUint32(4 * g, four);
  }
  return bytes.buffer;
}

// size: bytes; what the text has beyond the stream is not read.
async function inflated(bytes, size) {
  if (typeof DecompressionStream === 'undefined')
    throw new Error('This browser is too old for this page: it cannot unpack data (DecompressionStream).');
  const stream = new Blob([bytes.slice(0, size)]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// First bytes come first, then second ones; differences from the number `stride` before.
function numbersOf(bytes, from, count, stride) {
  const out = new Int32Array(count);
  for (let b = 0; b < 4; ++b)
    for (let i = 0, at = from + b * count; i < count; ++i) out[i] |= bytes[at + i] << (8 * b);
  for (let i = 0; i < count; ++i) {
    const difference = (out[i] >>> 1) ^ -(out[i] & 1);
    out[i] = stride > 0 && i >= stride ? difference + out[i - stride] : difference;
  }
  return out;
}

function positionsOf(places, { low, step }) {
  return Float32Array.from(places, (place, i) => low[i % 3] + step * place);
}

// Corners count back from the first vertex that is not used yet.
function cornersOf(codes) {
  let next = 0;
  return Uint32Array.from(codes, (code) => {
    const corner = next - code;
    next = Math.max(next, corner + 1);
    return corner;
  });
}

// The second and third number of each group are stored less the first.
function halvesOf(codes, components) {
  const halves = new Uint16Array(codes.length);
  for (let i = 0; i < codes.length; i += components)
    for (let c = 0; c < components; ++c) halves[i + c] = codes[i + c] + (c === 1 || c === 2 ? codes[i] : 0);
  return halves;
}

// { about, positions, corners, patches, light, errors, openings: [kind], solids: [kind], reflecting, emitting, places: [set], pictures: [ImageBitmap] }
export async function readLightFile() {
  const about = JSON.parse(document.getElementById('about').textContent);
  if (about.version !== version) throw new Error('The data of this page do not match its program: export it again.');
  const text = document.getElementById('numbers');
  const bytes = await inflated(bytesOfText(text.textContent.trim()), about.deflated);
  text.remove();
  const raw = {};
  let from = 0;
  for (const { name, type, count, stride } of about.arrays) {
    raw[name] = type === 'i32' ? numbersOf(bytes, from, count, stride) : bytes.subarray(from, from + count);
    from += count * (type === 'i32' ? 4 : 1);
  }
  const options = { colorSpaceConversion: 'none', premultiplyAlpha: 'none' };
  const pictures = Array.from({ length: about.pictures }, (_, i) => createImageBitmap(new Blob([raw[`picture${i}`]]), options));
  return {
    about,
    positions: positionsOf(raw.positions, about.grid),
    corners: cornersOf(raw.corners),
    patches: raw.patches,
    light: halvesOf(raw.light, about.light.components),
    errors: raw.errors,
    openings: about.luminaires.kinds.map((_, k) => Float32Array.from(raw[`opening${k}`], (v) => v * about.luminaires.metresPerStep)),
    solids: about.luminaires.kinds.map((_, k) => raw[`solid${k}`]),
    reflecting: raw.reflecting && halvesOf(raw.reflecting, 3),
    emitting: raw.emitting && halvesOf(raw.emitting, 3),
    places: Array.from({ length: about.sets }, (_, s) => Float32Array.from(raw[`places${s}`], (v) => v / about.placeParts)),
    pictures: await Promise.all(pictures),
  };
}
