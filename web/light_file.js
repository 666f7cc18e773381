// SPDX-License-Identifier: Apache-2.0
// What the file carries: a description in JSON, and numbers, deflated, as text.

const kinds = { f32: Float32Array, u32: Uint32Array, f16: Uint16Array, u8: Uint8Array };

function bytesOfText(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  if (typeof DecompressionStream === 'undefined')
    throw new Error('This browser is too old for this page: it cannot unpack data (DecompressionStream).');
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Of each array the first bytes of all numbers stand first, then the second ones.
function unwoven(bytes, from, Kind, count) {
  const size = Kind.BYTES_PER_ELEMENT;
  const out = new Uint8Array(count * size);
  for (let b = 0; b < size; ++b)
    for (let i = 0, at = from + b * count; i < count; ++i) out[i * size + b] = bytes[at + i];
  return new Kind(out.buffer);
}

// { about, positions, corners, patches, light, errors }
export async function readLightFile() {
  const about = JSON.parse(document.getElementById('about').textContent);
  const text = document.getElementById('numbers');
  const bytes = await inflated(bytesOfText(text.textContent.trim()));
  text.remove();
  const file = { about };
  let from = 0;
  for (const { name, type, count } of about.arrays) {
    const Kind = kinds[type];
    file[name] = unwoven(bytes, from, Kind, count);
    from += count * Kind.BYTES_PER_ELEMENT;
  }
  return file;
}
