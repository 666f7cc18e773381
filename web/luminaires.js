// SPDX-License-Identifier: Apache-2.0
// Luminaires: their luminous openings, as bright as they are towards the eye, and their photometric solids.
import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, LineSegments, Mesh, NoBlending, RawShaderMaterial, Vector3 } from 'three';
import { bodyFragmentShader, bodyVertexShader, wireFragmentShader, wireVertexShader } from './shaders.js';

const largestRadius = 0.5; // m, of a solid
const partOfScene = 0.1; // of the scene's size, where that is less
const columnStep = 2, rowStep = 6; // of a solid's lines: every 30 and 15 degrees

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const minus = (a, b) => a.map((x, i) => x - b[i]);
const at = (numbers, corner) => [numbers[3 * corner], numbers[3 * corner + 1], numbers[3 * corner + 2]];

export class Luminaires {
  // shared: the uniforms of the tone curve, and of what is shown.
  constructor(scene, { show, curve, tone_scale, white }) {
    this.scene = scene;
    this.places = scene.about.luminaires.places.map((place) => ({ ...place, z: cross(place.x, place.y) }));
    this.uniforms = { eye: { value: new Vector3() }, show, curve, tone_scale, white };
    this.bodies = new Mesh(this.#bodies(), new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: bodyVertexShader, fragmentShader: bodyFragmentShader, uniforms: this.uniforms,
      blending: NoBlending, side: DoubleSide,
    }));
    this.wires = new LineSegments(new BufferGeometry(), new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: wireVertexShader, fragmentShader: wireFragmentShader, blending: NoBlending,
    }));
    this.bodies.frustumCulled = this.wires.frustumCulled = false;
    this.hide();
  }

  hide() {
    this.bodies.visible = this.wires.visible = false;
  }

  // As the camera sees them; false colours show surfaces only.
  show(camera, look) {
    if (this.places.length === 0) return;
    this.bodies.visible = look.show === 'light';
    if (this.bodies.visible) this.#lookFrom(camera.position.toArray());
    this.wires.visible = look.solids;
    if (look.solids) this.#drawSolids();
  }

  #bodies() {
    const corners = this.places.flatMap((place) => {
      const opening = this.scene.openings[place.kind];
      return Array.from({ length: opening.length / 3 }, (_, i) => inScene(place, at(opening, i))).flat();
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(corners), 3));
    geometry.setAttribute('colour', new BufferAttribute(new Float32Array(corners.length), 3));
    return geometry;
  }

  // Intensity towards the eye over the projected area, which is the same for all of a body.
  #lookFrom(eye) {
    const { colour } = this.bodies.geometry.attributes;
    let first = 0;
    for (const place of this.places) {
      const count = this.scene.openings[place.kind].length / 3;
      const radiance = this.radiance(place, eye);
      for (let i = first; i < first + count; ++i) colour.setXYZ(i, ...radiance);
      first += count;
    }
    colour.needsUpdate = true;
    this.uniforms.eye.value.set(...eye);
  }

  // W/(m² sr) by linear sRGB.
  radiance(place, eye) {
    const way = minus(eye, place.at), local = [place.x, place.y, place.z].map((axis) => dot(axis, way));
    const length = Math.hypot(...local) || 1, to = local.map((x) => x / length);
    const area = projectedArea(this.scene.openings[place.kind], to, this.scene.about.luminaires.kinds[place.kind].isSheet);
    const relative = area > 0 ? this.#relative(place.kind, to) / area : 0;
    return place.intensity.map((i, c) => i * relative * this.scene.weights[place.group][c]);
  }

  // Intensity in a direction in local axes, relative to the largest.
  #relative(kind, [x, y, z]) {
    const { rows, columns } = this.scene.about.luminaires, solid = this.scene.solids[kind];
    const row = (Math.acos(Math.min(1, Math.max(-1, -z))) / Math.PI) * (rows - 1);
    const column = ((Math.atan2(y, x) / (2 * Math.PI) + 1) % 1) * columns;
    const r = Math.min(rows - 2, Math.floor(row)), c = Math.floor(column) % columns, u = row - r, v = column - Math.floor(column);
    const code = (i, j) => solid[i * columns + (j % columns)];
    return ((1 - u) * ((1 - v) * code(r, c) + v * code(r, c + 1)) + u * ((1 - v) * code(r + 1, c) + v * code(r + 1, c + 1))) / 255;
  }

  // Anew where the lamps have other colours.
  #drawSolids() {
    const weights = JSON.stringify(this.scene.weights);
    if (this.drawnFor === weights) return;
    this.drawnFor = weights;
    const radius = Math.min(largestRadius, partOfScene * 2 * this.scene.radius);
    const lines = [], colours = [];
    for (const place of this.places) {
      const ink = inkOf(place.intensity.map((i, c) => i * this.scene.weights[place.group][c]));
      for (const point of this.#linesOf(place.kind)) {
        lines.push(...inScene(place, point.map((p) => radius * p)));
        colours.push(...ink);
      }
    }
    this.wires.geometry.dispose();
    this.wires.geometry = new BufferGeometry();
    this.wires.geometry.setAttribute('position', new BufferAttribute(Float32Array.from(lines), 3));
    this.wires.geometry.setAttribute('colour', new BufferAttribute(Float32Array.from(colours), 3));
  }

  // Ends of segments in local axes, two each; the largest radius is 1.
  #linesOf(kind) {
    const { rows, columns } = this.scene.about.luminaires, solid = this.scene.solids[kind];
    const point = (row, column) => {
      const theta = (Math.PI * row) / (rows - 1), phi = (2 * Math.PI * column) / columns;
      const r = solid[row * columns + (column % columns)] / 255;
      return [r * Math.sin(theta) * Math.cos(phi), r * Math.sin(theta) * Math.sin(phi), -r * Math.cos(theta)];
    };
    const ends = [];
    const add = (a, b) => (a.some((x) => x !== 0) || b.some((x) => x !== 0)) && ends.push(a, b);
    for (let column = 0; column < columns; column += columnStep)
      for (let row = 0; row + 1 < rows; ++row) add(point(row, column), point(row + 1, column));
    for (let row = rowStep; row + 1 < rows; row += rowStep)
      for (let column = 0; column < columns; ++column) add(point(row, column), point(row, column + 1));
    return ends;
  }

  // The nearest luminaire on a ray before a surface at a distance (m), which may be 5 mm nearer; or null.
  nearest(origin, direction, distance) {
    let best = distance + 5e-3, found = null;
    const positions = this.bodies.geometry.attributes.position.array;
    let first = 0;
    for (const place of this.places) {
      const count = this.scene.openings[place.kind].length / 9;
      for (let t = first; t < first + count; ++t) {
        const met = meeting(origin, direction, at(positions, 3 * t), at(positions, 3 * t + 1), at(positions, 3 * t + 2));
        if (met > 0 && met < best) [best, found] = [met, place];
      }
      first += count;
    }
    return found;
  }

  // lm, as it is dimmed.
  lumens(place) {
    const w = this.scene.weights[place.group], [r, g, b] = place.intensity.map((i, c) => i * [0.2126, 0.7152, 0.0722][c]);
    return (place.lumens * (r * w[0] + g * w[1] + b * w[2])) / (r + g + b || 1);
  }
}

const inScene = ({ at: centre, x, y, z }, p) => centre.map((c, i) => c + p[0] * x[i] + p[1] * y[i] + p[2] * z[i]);

// Of a closed mesh half of what its triangles have, m².
function projectedArea(corners, direction, isSheet) {
  let sum = 0;
  for (let t = 0; t < corners.length / 9; ++t) {
    const a = at(corners, 3 * t);
    sum += Math.abs(dot(cross(minus(at(corners, 3 * t + 1), a), minus(at(corners, 3 * t + 2), a)), direction)) / 2;
  }
  return isSheet ? sum : sum / 2;
}

// Distance to where a ray meets a triangle; NaN where it does not.
function meeting(origin, direction, a, b, c) {
  const e = minus(b, a), f = minus(c, a), h = cross(direction, f), det = dot(e, h);
  const s = minus(origin, a), u = dot(s, h) / det, q = cross(s, e), v = dot(direction, q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 ? dot(f, q) / det : NaN;
}

// A colour that is seen well, whatever the lamp is dimmed to: sRGB codes.
function inkOf(colour) {
  const largest = Math.max(...colour);
  return largest > 0 ? colour.map((c, i) => [1, 0.93, 0.76][i] * Math.sqrt(Math.max(0, c) / largest)) : [0.45, 0.45, 0.45];
}
