// SPDX-License-Identifier: Apache-2.0
// Surfaces on the graphics card. Light of each lamp lies in a texture, a layer a lamp; a vertex sums it up with the
// weights of the sliders, and a pixel puts on reflectance, tone curve or false colour.
import {
  BufferAttribute, BufferGeometry, DataArrayTexture, DataTexture, DoubleSide, Float16BufferAttribute, FrontSide, GLSL3, HalfFloatType, Mesh,
  NearestFilter, NoBlending, RawShaderMaterial, RGBAFormat, UnsignedByteType, Vector3, WebGLRenderTarget,
} from 'three';
import { heat } from './tone.js';

const width = 2048; // texels, of the light's texture

const vertexShader = `
precision highp float;
precision highp int;
precision highp sampler2DArray;
in vec3 position;
in float number;
uniform mat4 projectionMatrix, modelViewMatrix;
uniform sampler2DArray light;
uniform vec3 weights[GROUPS];
uniform int vertices;
uniform float unit;
out vec4 front, back;
#ifdef COLOURED
in vec3 reflecting, emitting;
out vec3 reflected, emitted;
#endif
vec4 light_at(int place) {
  vec4 sum = vec4(0.0);
  for (int g = 0; g < GROUPS; ++g)
    sum += vec4(weights[g], weights[g].g) * texelFetch(light, ivec3(place % ${width}, place / ${width}, g), 0);
  return unit * sum;
}
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  front = light_at(int(number));
  back = light_at(int(number) + vertices);
#ifdef COLOURED
  reflected = reflecting;
  emitted = emitting;
#endif
}`;

// Tone curves are those of tone.js, and of image/tone.cpp.
const fragmentShader = `
precision highp float;
precision highp int;
in vec4 front, back;
#ifdef COLOURED
in vec3 reflected, emitted;
#else
const vec3 reflected = vec3(1.0), emitted = vec3(1.0);
#endif
layout(location = 0) out vec4 pixel;
uniform vec3 reflectance, emittance;
uniform bool reflects_behind;
uniform int show;
uniform int curve;  // 0: linear, 1: Reinhard, 2: neutral
uniform bool logarithmic, isolines;
uniform float tone_scale, white, low, high;
uniform vec4 measure;
uniform sampler2D colours;
const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
vec3 in_gamut(vec3 c) {
  float L = dot(c, luminance), least = min(c.r, min(c.g, c.b));
  if (L <= 0.0) return vec3(0.0);
  return least < 0.0 ? mix(vec3(L), c, L / (L - least)) : c;
}
vec3 radiance() {
  vec3 leaving = gl_FrontFacing ? emitted * emittance + reflected * reflectance * front.rgb
                                : reflects_behind ? reflected * reflectance * back.rgb : vec3(0.0);
  return in_gamut(leaving / 3.14159265359);
}
vec3 encoded(vec3 c) { return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
vec3 neutral(vec3 scaled) {
  const float start = 0.76;
  float peak = max(scaled.r, max(scaled.g, scaled.b));
  if (peak <= start) return scaled;
  float top = 1.0 - (1.0 - start) * (1.0 - start) / (peak + 1.0 - 2.0 * start);
  return mix(scaled * (top / peak), vec3(top), 1.0 - 1.0 / (0.15 * (peak - top) + 1.0));
}
vec3 toned(vec3 c) {
  if (curve == 2) return encoded(neutral(tone_scale * max(c, vec3(0.0))));
  float L = tone_scale * dot(c, luminance);
  float burn_out = white > 0.0 ? 1.0 + L / (white * white) : 1.0;
  float factor = curve == 1 ? tone_scale * burn_out / (1.0 + L) : tone_scale;
  return encoded(min(factor * c, vec3(1.0)));
}
vec3 false_colour(float value) {
  float share = logarithmic ? (value > 0.0 ? log(value / low) / log(high / low) : 0.0) : (value - low) / (high - low);
  vec3 colour = texture(colours, vec2((clamp(share, 0.0, 1.0) * 8.0 + 0.5) / 9.0, 0.5)).rgb;
  if (isolines) {
    float place = share * 10.0;
    float line = abs(fract(place + 0.5) - 0.5) / max(fwidth(place), 1e-6);
    float ink = step(0.5, place) * step(place, 9.5) * (1.0 - smoothstep(0.5, 1.3, line));
    colour = mix(colour, dot(colour, luminance) > 0.45 ? vec3(0.0) : vec3(1.0), 0.7 * ink);
  }
  return colour;
}
// A logarithm to base 2 in two bytes, 1 to 65535 for 2^-32 to 2^32.
vec2 bytes_of(float value) {
  float code = floor(clamp((log2(value) + 32.0) * 1024.0, 1.0, 65535.0) + 0.5);
  return vec2(floor(code / 256.0), mod(code, 256.0)) / 255.0;
}
void main() {
  if (show == 1) {
    pixel = vec4(false_colour(dot(gl_FrontFacing ? front : back, measure)), 1.0);
    return;
  }
  vec3 c = radiance();
  if (show == 0) {
    pixel = vec4(toned(c), 1.0);
    return;
  }
  float L = dot(c, luminance);
  pixel = L > 0.0 ? vec4(bytes_of(L), bytes_of(max(c.r, max(c.g, c.b)))) : vec4(0.0, 0.0, 0.0, 1.0 / 255.0);
}`;

function heatTexture() {
  const data = new Uint8Array(heat.flatMap((rgb) => [rgb >> 16, (rgb >> 8) & 255, rgb & 255, 255]));
  const texture = new DataTexture(data, heat.length, 1, RGBAFormat, UnsignedByteType);
  texture.minFilter = texture.magFilter = 1006; // linear
  texture.needsUpdate = true;
  return texture;
}

// A layer a lamp: the fronts of all vertices, then the backs.
function lightTexture({ light, vertexCount, components, groupCount }) {
  const height = Math.ceil((2 * vertexCount) / width);
  const data = new Uint16Array(4 * width * height * groupCount);
  const kept = Math.min(4, components);
  for (let g = 0; g < groupCount; ++g)
    for (let v = 0; v < 2 * vertexCount; ++v) {
      const from = (g * 2 * vertexCount + v) * components, to = 4 * (g * width * height + v);
      for (let c = 0; c < kept; ++c) data[to + c] = light[from + c];
    }
  const texture = new DataArrayTexture(data, width, height, groupCount);
  texture.format = RGBAFormat;
  texture.type = HalfFloatType;
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

export class Surfaces {
  constructor(scene) {
    this.scene = scene;
    this.shared = {
      light: { value: lightTexture(scene) },
      weights: { value: scene.weights.map((w) => new Vector3(...w)) },
      vertices: { value: scene.vertexCount },
      unit: { value: scene.about.light.unit },
      show: { value: 0 },
      curve: { value: 2 }, tone_scale: { value: 1 }, white: { value: 0 },
      logarithmic: { value: false }, isolines: { value: true }, low: { value: 0 }, high: { value: 1 },
      measure: { value: [0, 0, 0, 0] },
      colours: { value: heatTexture() },
    };
    this.mesh = new Mesh(this.#geometry(), scene.about.parts.map((part) => this.#material(part)));
    this.mesh.frustumCulled = false;
    this.fitTarget = new WebGLRenderTarget(1, 1, { minFilter: NearestFilter, magFilter: NearestFilter });
  }

  #geometry() {
    const { positions, corners, vertexCount, about } = this.scene;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('number', new BufferAttribute(Float32Array.from({ length: vertexCount }, (_, i) => i), 1));
    if (this.scene.reflecting) // what textures make of the materials
      for (const name of ['reflecting', 'emitting'])
        geometry.setAttribute(name, new Float16BufferAttribute(this.scene[name], 3));
    geometry.setIndex(new BufferAttribute(corners, 1));
    about.parts.forEach(({ first, count }, i) => geometry.addGroup(3 * first, 3 * count, i));
    return geometry;
  }

  #material({ material }) {
    const { reflectance, twoSided } = this.scene.about.materials[material];
    return new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader, fragmentShader,
      defines: { GROUPS: this.scene.groupCount, ...(this.scene.reflecting ? { COLOURED: '' } : {}) },
      blending: NoBlending,
      uniforms: {
        ...this.shared,
        reflectance: { value: new Vector3(...reflectance) },
        emittance: { value: new Vector3() },
        reflects_behind: { value: twoSided },
      },
    });
  }

  // The lamps' weights, and what one sees through.
  update(seesThrough) {
    const { weights, about } = this.scene;
    weights.forEach((w, g) => this.shared.weights.value[g].set(...w));
    about.parts.forEach(({ material, backLit }, i) => {
      const { emittance, group } = about.materials[material];
      const drawn = this.mesh.material[i];
      drawn.uniforms.emittance.value.set(...emittance.map((e, c) => e * weights[group][c]));
      drawn.side = backLit || !seesThrough ? DoubleSide : FrontSide;
    });
  }

  skyRadiance() {
    const { about, weights, groupCount } = this.scene;
    return about.sky.map((s, c) => (about.hasSky ? s * weights[groupCount - 1][c] : 0));
  }

  // { logAverage, litAverage, bright, largest } of the radiance in view, each pixel alike, as tone_map() of Luxel has it.
  lightInView(renderer, world, camera, aspect) {
    const w = 320, h = Math.max(1, Math.round(w / aspect));
    this.fitTarget.setSize(w, h);
    const { show } = this.shared;
    const before = show.value;
    show.value = 2;
    renderer.setRenderTarget(this.fitTarget);
    renderer.setClearColor(0x000000, 0);
    renderer.render(world, camera);
    const pixels = new Uint8Array(4 * w * h);
    renderer.readRenderTargetPixels(this.fitTarget, 0, 0, w, h, pixels);
    renderer.setRenderTarget(null);
    show.value = before;
    return this.#averageOf(pixels);
  }

  #averageOf(pixels) {
    const sky = this.skyRadiance();
    const skyL = 0.2126 * sky[0] + 0.7152 * sky[1] + 0.0722 * sky[2];
    let largest = 0;
    const logarithms = [];
    for (let i = 0; i < pixels.length; i += 4) {
      const code = 256 * pixels[i] + pixels[i + 1];
      const isSky = code === 0 && pixels[i + 3] === 0;
      if (code === 0 && !(isSky && skyL > 0)) continue;
      logarithms.push(isSky ? Math.log2(skyL) : code / 1024 - 32);
      largest = Math.max(largest, isSky ? Math.max(...sky) : 2 ** ((256 * pixels[i + 2] + pixels[i + 3]) / 1024 - 32));
    }
    logarithms.sort((a, b) => a - b);
    const bright = logarithms.length > 0 ? 2 ** logarithms[Math.ceil(0.9 * logarithms.length) - 1] : 1;
    const lit = logarithms.filter((l) => l >= Math.log2(0.01 * bright));
    const mean = (of) => (of.length > 0 ? 2 ** (of.reduce((a, b) => a + b) / of.length) : 1);
    return { logAverage: mean(logarithms), litAverage: mean(lit), bright, largest };
  }
}
