// SPDX-License-Identifier: Apache-2.0
// What is under a finger: the light that arrives there, how sure it is, and whose surface it is.
import { Vector3 } from 'three';
import { numberText } from './tone.js';

const element = (id) => document.getElementById(id);

export class Probe {
  constructor(scene, look, navigation) {
    Object.assign(this, { scene, look, navigation, hit: null });
    element('card-close').addEventListener('click', () => this.clear());
  }

  // At a point of the window, in CSS pixels; the hit, or null.
  at(x, y) {
    const { camera } = this.navigation;
    const sight = this.navigation.sight((2 * x) / window.innerWidth - 1, 1 - (2 * y) / window.innerHeight);
    return this.scene.nearest(camera.position.toArray(), sight, this.look.seeThrough);
  }

  pin(hit) {
    this.hit = hit;
    element('card').hidden = element('spot').hidden = hit === null;
    this.fill();
    this.place();
  }

  clear() {
    this.pin(null);
  }

  fill() {
    const { scene, hit } = this;
    if (!hit) return;
    const side = hit.back ? 1 : 0;
    const at = (unit) => hit.corners.reduce(
      (sum, w, i) => sum + w * scene.arriving(scene.corners[3 * hit.triangle + i], side, unit), 0);
    const lux = at('lux'), watts = at('watts');
    const material = scene.material(hit.triangle);
    const error = scene.error(hit.triangle, side);
    const isAbsorbing = hit.back && !material.twoSided;
    const bar = error !== null && !isAbsorbing ? 1.96 * error : null;
    element('card-value').textContent = `${numberText(lux)}${bar === null ? '' : ` ± ${barText(bar)}`} lux`;
    element('card-watts').textContent =
      `${numberText(watts)}${bar === null || !(lux > 0) ? '' : ` ± ${barText((bar * watts) / lux)}`} W/m²`;
    element('card-material').textContent = material.name + (hit.back ? ' (back)' : '');
    element('card-patch').textContent = String(scene.patches[hit.triangle]);
    element('card-place').textContent =
      hit.at.map((x, i) => (x + scene.about.origin[i]).toFixed(3)).join(', ') + ' m';
    element('card-note').textContent = isAbsorbing
      ? 'The back of a one-sided material: it takes up what meets it, and was not measured.'
      : error === null ? 'The method of this solution states no error.'
      : scene.isAsSolved ? '± holds the truth of this patch 95 times in 100.'
      : '± is the most it can be with these lamps.';
  }

  // The mark goes where the point is drawn.
  place() {
    if (!this.hit) return;
    const point = new Vector3(...this.hit.at).project(this.navigation.camera);
    const spot = element('spot');
    spot.style.visibility = point.z < 1 ? 'visible' : 'hidden';
    spot.style.left = `${((point.x + 1) / 2) * window.innerWidth}px`;
    spot.style.top = `${((1 - point.y) / 2) * window.innerHeight}px`;
  }
}

// Two digits are enough of an error.
const barText = (value) => (value >= 100 ? String(Math.round(value)) : String(Number(value.toPrecision(2))));
