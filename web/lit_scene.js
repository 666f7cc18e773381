// SPDX-License-Identifier: Apache-2.0
// The scene as numbers: where its triangles are, and what light each lamp gives at their corners.
import { DataUtils } from 'three';

const luminance = [0.2126, 0.7152, 0.0722];

export class LitScene {
  constructor(file) {
    Object.assign(this, file);
    const { about } = file;
    this.vertexCount = this.positions.length / 3;
    this.triangleCount = this.patches.length;
    this.components = about.light.components;
    this.isSpectral = this.components === 5;
    this.groupCount = about.groups.length;
    this.weights = about.groups.map(() => [1, 1, 1]); // of each lamp, by colour
    this.#findBox();
    this.partOf = new Uint16Array(this.triangleCount);
    about.parts.forEach(({ first, count }, i) => this.partOf.fill(i, first, first + count));
    this.masks = new Map();
  }

  #findBox() {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < this.positions.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], this.positions[i]);
      high[i % 3] = Math.max(high[i % 3], this.positions[i]);
    }
    this.centre = low.map((l, i) => (l + high[i]) / 2);
    this.radius = Math.hypot(...low.map((l, i) => high[i] - l)) / 2 || 1;
  }

  get isAsSolved() {
    return this.weights.every((w) => w.every((x) => x === 1));
  }

  // How much brighter a light group is than solved: by the lumens of its luminaires, else by its strongest colour.
  factor(g) {
    const parts = this.about.lumens[g], w = this.weights[g];
    return parts ? parts.reduce((sum, part, c) => sum + part * w[c], 0) : Math.max(...w);
  }

  // tint: linear. That of luminaires changes no lumens.
  setLamp(g, tint, factor) {
    this.weights[g] = tint.map((t) => t);
    const own = this.about.lumens[g] ? this.factor(g) : 1;
    this.weights[g] = tint.map((t) => (factor * t) / (own > 0 ? own : 1));
  }

  material(triangle) {
    return this.about.materials[this.about.parts[this.partOf[triangle]].material];
  }

  // Illuminance of some thousand triangles evenly among all, and their areas: [{ value, area }], in lux or W/m².
  samples(unit) {
    const { positions: p, corners } = this;
    const step = Math.ceil(this.triangleCount / 10000);
    const samples = [];
    for (let t = 0; t < this.triangleCount; t += step) {
      const [a, b, c] = [0, 1, 2].map((k) => corners[3 * t + k]);
      const e = [0, 1, 2].map((i) => p[3 * b + i] - p[3 * a + i]), f = [0, 1, 2].map((i) => p[3 * c + i] - p[3 * a + i]);
      const area = Math.hypot(e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]) / 2;
      for (const side of [0, 1])
        samples.push({ value: (this.arriving(a, side, unit) + this.arriving(b, side, unit) + this.arriving(c, side, unit)) / 3, area });
    }
    return samples;
  }

  // Whether a picture of holes has one at a point of a triangle. weights: of its corners.
  #isHole(triangle, weights) {
    const cutout = this.material(triangle).textures.cutout;
    if (!cutout) return false;
    if (!this.masks.has(cutout.picture)) {
      const picture = this.pictures[cutout.picture];
      const canvas = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
      canvas.drawImage(picture, 0, 0);
      this.masks.set(cutout.picture, canvas.getImageData(0, 0, picture.width, picture.height));
    }
    const mask = this.masks.get(cutout.picture);
    const place = (i) => weights.reduce((sum, w, k) => sum + w * this.places[cutout.set][2 * this.corners[3 * triangle + k] + i], 0);
    const pixel = (x, size, wrap) => {
      const within = wrap === 'clamp' ? Math.min(Math.max(x, 0), 1) : wrap === 'mirror' ? 1 - Math.abs((((x % 2) + 2) % 2) - 1) : x - Math.floor(x);
      return Math.min(size - 1, Math.floor(within * size));
    };
    const x = pixel(place(0), mask.width, cutout.wrap[0]), y = pixel(place(1), mask.height, cutout.wrap[1]);
    return mask.data[4 * (y * mask.width + x)] < 255 * cutout.threshold;
  }

  // What arrives at a vertex, in `unit`: lux or W/m²; side 0 is the front.
  arriving(vertex, side, unit) {
    let value = 0;
    for (let g = 0; g < this.groupCount; ++g) {
      const at = ((g * 2 + side) * this.vertexCount + vertex) * this.components;
      const half = (c) => DataUtils.fromHalfFloat(this.light[at + c]);
      const w = this.weights[g];
      if (this.isSpectral) {
        value += w[1] * (unit === 'lux' ? this.about.efficacy * half(3) : half(4));
      } else {
        for (let c = 0; c < 3; ++c)
          value += w[c] * half(c) * (unit === 'lux' ? this.about.efficacy * luminance[c] : 1);
      }
    }
    return value * this.about.light.unit;
  }

  // Standard error of the illuminance of a side, lux; null where none is known. With other lamps than those solved
  // for: the sum of their errors, which is the most it can be.
  error(triangle, side) {
    if (!this.errors) return null;
    const of = (layer) => {
      const code = this.errors[(layer * 2 + side) * this.triangleCount + triangle];
      return code === 0 ? 0 : this.about.errors.largest * 2 ** ((code - 255) / this.about.errors.perOctave);
    };
    if (this.isAsSolved) return of(0);
    if (this.groupCount === 1) return Math.max(...this.weights[0]) * of(0);
    return this.weights.reduce((sum, w, g) => sum + Math.max(...w) * of(g + 1), 0);
  }

  // Where a ray first meets a surface: { triangle, back, at, distance, weights of the corners }, or null. Backs without
  // light are not met where one sees through them.
  nearest(origin, direction, seesThrough) {
    const { positions: p, corners } = this;
    const [ox, oy, oz] = origin, [dx, dy, dz] = direction;
    let best = Infinity, found = null;
    for (const { first, count, backLit } of this.about.parts) {
      for (let t = first; t < first + count; ++t) {
        const a = 3 * corners[3 * t], b = 3 * corners[3 * t + 1], c = 3 * corners[3 * t + 2];
        const ax = p[a], ay = p[a + 1], az = p[a + 2];
        const ex = p[b] - ax, ey = p[b + 1] - ay, ez = p[b + 2] - az;
        const fx = p[c] - ax, fy = p[c + 1] - ay, fz = p[c + 2] - az;
        const hx = dy * fz - dz * fy, hy = dz * fx - dx * fz, hz = dx * fy - dy * fx;
        const det = ex * hx + ey * hy + ez * hz; // above 0: the front faces the ray
        if (det === 0 || (det < 0 && seesThrough && !backLit)) continue;
        const sx = ox - ax, sy = oy - ay, sz = oz - az;
        const u = (sx * hx + sy * hy + sz * hz) / det;
        if (u < 0 || u > 1) continue;
        const qx = sy * ez - sz * ey, qy = sz * ex - sx * ez, qz = sx * ey - sy * ex;
        const v = (dx * qx + dy * qy + dz * qz) / det;
        if (v < 0 || u + v > 1) continue;
        const distance = (fx * qx + fy * qy + fz * qz) / det;
        if (distance <= 0 || distance >= best || this.#isHole(t, [1 - u - v, u, v])) continue;
        best = distance;
        found = { triangle: t, back: det < 0, distance, corners: [1 - u - v, u, v] };
      }
    }
    if (found) found.at = origin.map((o, i) => o + best * direction[i]);
    return found;
  }
}
