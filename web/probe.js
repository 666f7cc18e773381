// SPDX-License-Identifier: Apache-2.0
// The light that arrives at a point, its uncertainty, and the surface.
import { Vector3 } from 'three';
import { numberText } from './tone.js';

const element = (id) => document.getElementById(id);

export class Probe {
  constructor(scene, look, navigation, luminaires) {
    Object.assign(this, { scene, look, navigation, luminaires, hit: null });
    element('card-close').addEventListener('click', () => this.clear());
  }

  // At a point of the window, in CSS pixels; the hit, or null.
  at(x, y) {
    const { camera, canvas } = this.navigation;
    const sight = this.navigation.sight((2 * x) / canvas.clientWidth - 1, 1 - (2 * y) / canvas.clientHeight);
    const eye = camera.position.toArray();
    const hit = this.scene.nearest(eye, sight, this.look.seeThrough);
    if (hit) hit.luminaire = this.luminaires.nearest(eye, sight, hit.distance);
    return hit;
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
    const luminaire = hit.luminaire ?? null;
    for (const row of document.getElementsByClassName('of-luminaire')) row.hidden = luminaire === null;
    if (luminaire) element('card-luminaire').textContent = `${luminaire.name}, ${this.luminaires.lumens(luminaire).toFixed(0)} lm`;
    element('card-material').textContent = material.name + (hit.back ? ' (back)' : '');
    element('card-place').textContent =
      hit.at.map((x, i) => (x + scene.about.origin[i]).toFixed(3)).join(', ') + ' m';
    element('card-note').textContent = isAbsorbing
      ? 'The back of this surface absorbs all light; its light was not computed.'
      : error === null ? 'No error was estimated for this light.'
      : scene.isAsSolved ? 'The exact value is within ± in 95 of 100 cases.'
      : 'With changed lamps, ± is an upper bound.';
  }

  // Moves the mark to where the point is drawn.
  place() {
    if (!this.hit) return;
    const point = new Vector3(...this.hit.at).project(this.navigation.camera);
    const spot = element('spot');
    spot.style.visibility = point.z < 1 ? 'visible' : 'hidden';
    const { clientWidth, clientHeight } = this.navigation.canvas;
    spot.style.left = `${((point.x + 1) / 2) * clientWidth}px`;
    spot.style.top = `${((1 - point.y) / 2) * clientHeight}px`;
  }
}

// An error has two digits.
const barText = (value) => (value >= 100 ? String(Math.round(value)) : String(Number(value.toPrecision(2))));
