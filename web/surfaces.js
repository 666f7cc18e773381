// SPDX-License-Identifier: Apache-2.0
// Surfaces on the graphics card.
import {
  BackSide, BufferAttribute, BufferGeometry, ClampToEdgeWrapping, DataArrayTexture, DataTexture, Float16BufferAttribute, GLSL3,
  HalfFloatType, LinearFilter, LinearMipmapLinearFilter, Mesh, MirroredRepeatWrapping, NearestFilter, NoBlending, RawShaderMaterial,
  RepeatWrapping, RGBAFormat, SRGBColorSpace, Texture, UnsignedByteType, Vector3, WebGLRenderTarget,
} from 'three';
import { fragmentShader, lightWidth, maxLevels, vertexShader } from './shaders.js';
import { heat } from './tone.js';

const wraps = { repeat: RepeatWrapping, mirror: MirroredRepeatWrapping, clamp: ClampToEdgeWrapping };

function heatTexture() {
  const data = new Uint8Array(heat.flatMap((rgb) => [rgb >> 16, (rgb >> 8) & 255, rgb & 255, 255]));
  const texture = new DataTexture(data, heat.length, 1, RGBAFormat, UnsignedByteType);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

// A layer per lamp: the fronts of all vertices, then the backs.
function lightTexture({ light, vertexCount, components, groupCount }) {
  const height = Math.ceil((2 * vertexCount) / lightWidth);
  const data = new Uint16Array(4 * lightWidth * height * groupCount);
  const kept = Math.min(4, components);
  for (let g = 0; g < groupCount; ++g)
    for (let v = 0; v < 2 * vertexCount; ++v) {
      const from = (g * 2 * vertexCount + v) * components, to = 4 * (g * lightWidth * height + v);
      for (let c = 0; c < kept; ++c) data[to + c] = light[from + c];
    }
  const texture = new DataArrayTexture(data, lightWidth, height, groupCount);
  texture.format = RGBAFormat;
  texture.type = HalfFloatType;
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

const shaders = { glslVersion: GLSL3, vertexShader, fragmentShader, blending: NoBlending };

// Whether no surface is drawn at a pixel of codes of the radiance.
const isUncovered = (pixels, i) => pixels[i] === 0 && pixels[i + 1] === 0 && pixels[i + 3] === 0;

export class Surfaces {
  // anisotropy: of pictures, as the graphics card has it.
  constructor(scene, anisotropy) {
    this.scene = scene;
    this.anisotropy = anisotropy;
    this.pictures = new Map();
    this.shared = {
      light: { value: lightTexture(scene) },
      weights: { value: scene.weights.map((w) => new Vector3(...w)) },
      vertices: { value: scene.vertexCount },
      unit: { value: scene.about.light.unit },
      show: { value: 0 },
      curve: { value: 2 }, tone_scale: { value: 1 }, white: { value: 0 },
      logarithmic: { value: false }, isolines: { value: true }, low: { value: 0 }, high: { value: 1 },
      levels: { value: new Float32Array(maxLevels) }, level_count: { value: 0 },
      measure: { value: [0, 0, 0, 0] },
      colours: { value: heatTexture() },
    };
    // Backs, and fronts that other things hide, are drawn a little farther away: they are dark, and where they lie just behind
    // what is lit, as at the outlines of round things, depths of few bits do not always tell that they are behind.
    const geometry = this.#geometry();
    const farther = { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 8 };
    const fronts = scene.about.parts.map((part) => this.#material(part));
    scene.about.parts.forEach(({ frontHidden }, i) => frontHidden && fronts[i].setValues(farther));
    const backs = fronts.map((front) => new RawShaderMaterial({
      ...shaders, ...farther, defines: front.defines, uniforms: front.uniforms, side: BackSide,
    }));
    this.meshes = [fronts, backs].map((materials) => new Mesh(geometry, materials));
    for (const mesh of this.meshes) mesh.frustumCulled = false;
    this.target = new WebGLRenderTarget(1, 1, { minFilter: NearestFilter, magFilter: NearestFilter });
  }

  #geometry() {
    const { positions, corners, places, vertexCount, about } = this.scene;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('number', new BufferAttribute(Float32Array.from({ length: vertexCount }, (_, i) => i), 1));
    if (this.scene.reflecting) // what textures make of the materials
      for (const name of ['reflecting', 'emitting'])
        geometry.setAttribute(name, new Float16BufferAttribute(this.scene[name], 3));
    places.forEach((values, set) => geometry.setAttribute(`place${set}`, new BufferAttribute(values, 2)));
    geometry.setIndex(new BufferAttribute(corners, 1));
    about.parts.forEach(({ first, count }, i) => geometry.addGroup(3 * first, 3 * count, i));
    return geometry;
  }

  // The picture as a texture; one per way of wrapping.
  #picture({ picture, wrap }, isColour) {
    const key = [picture, ...wrap, isColour].join();
    if (!this.pictures.has(key)) {
      const texture = new Texture(this.scene.pictures[picture]);
      [texture.wrapS, texture.wrapT] = wrap.map((w) => wraps[w]);
      texture.flipY = false; // rows begin at the top
      texture.minFilter = LinearMipmapLinearFilter;
      texture.anisotropy = this.anisotropy;
      if (isColour) texture.colorSpace = SRGBColorSpace;
      texture.needsUpdate = true;
      this.pictures.set(key, texture);
    }
    return this.pictures.get(key);
  }

  #material({ material }) {
    const { reflectance, twoSided, textures } = this.scene.about.materials[material];
    const defines = { GROUPS: this.scene.groupCount, SETS: this.scene.places.length };
    if (this.scene.reflecting) defines.COLOURED = '';
    const uniforms = {
      ...this.shared,
      reflectance: { value: new Vector3(...reflectance) },
      emittance: { value: new Vector3() },
      reflects_behind: { value: twoSided },
    };
    for (const [name, use] of Object.entries(textures)) {
      defines[`${name.toUpperCase()}_AT`] = `at${use.set}`;
      uniforms[`${name}_picture`] = { value: this.#picture(use, name !== 'cutout') };
      uniforms[`${name}_scale`] = { value: use.scale };
      if (name === 'cutout') uniforms.threshold = { value: use.threshold };
    }
    return new RawShaderMaterial({ ...shaders, defines, uniforms });
  }

  // The lamps' weights, and what one sees through.
  update(seesThrough) {
    const { weights, about } = this.scene;
    weights.forEach((w, g) => this.shared.weights.value[g].set(...w));
    about.parts.forEach(({ material, backLit }, i) => {
      const { emittance, group } = about.materials[material];
      const [front, back] = this.meshes.map((mesh) => mesh.material[i]);
      front.uniforms.emittance.value.set(...emittance.map((e, c) => e * weights[group][c])); // the back's too
      back.visible = backLit || !seesThrough;
    });
  }

  skyRadiance() {
    const { about, weights, groupCount } = this.scene;
    return about.sky.map((s, c) => (about.hasSky ? s * weights[groupCount - 1][c] : 0));
  }

  // Draws codes instead of colours, and reads them: 4 bytes per pixel, rows from the bottom.
  #codes(show, renderer, world, camera, width, height) {
    this.target.setSize(width, height);
    const before = this.shared.show.value;
    this.shared.show.value = show;
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0x000000, 0);
    renderer.render(world, camera);
    const pixels = new Uint8Array(4 * width * height);
    renderer.readRenderTargetPixels(this.target, 0, 0, width, height, pixels);
    renderer.setRenderTarget(null);
    this.shared.show.value = before;
    return pixels;
  }

  // { logAverage, litAverage, bright, largest } of the radiance in view, all pixels equally, the sky only where there is little
  // else, as in Luxel's tone_map().
  lightInView(renderer, world, camera, aspect) {
    return this.#averageOf(this.#codes(2, renderer, world, camera, 320, Math.max(1, Math.round(320 / aspect))));
  }

  // The measured light in view, [row from the bottom][column]; NaN where there is no surface.
  measuredInView(renderer, world, camera, width, height) {
    const pixels = this.#codes(3, renderer, world, camera, width, height);
    return Float32Array.from({ length: width * height }, (_, i) => {
      const code = 256 * pixels[4 * i] + pixels[4 * i + 1];
      return pixels[4 * i + 3] === 0 ? NaN : code === 0 ? 0 : 2 ** (code / 1024 - 32);
    });
  }

  #averageOf(pixels) {
    const sky = this.skyRadiance();
    const skyL = 0.2126 * sky[0] + 0.7152 * sky[1] + 0.0722 * sky[2];
    let largest = 0, uncovered = 0;
    for (let i = 3; i < pixels.length; i += 4) uncovered += isUncovered(pixels, i - 3) ? 1 : 0;
    const skyCounts = skyL > 0 && 1 - (4 * uncovered) / pixels.length < 0.02;
    const logarithms = [];
    for (let i = 0; i < pixels.length; i += 4) {
      const code = 256 * pixels[i] + pixels[i + 1];
      const isSky = isUncovered(pixels, i);
      if (code === 0 && !(isSky && skyCounts)) continue;
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
