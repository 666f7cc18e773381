// SPDX-License-Identifier: Apache-2.0
// The picture: drawn when something has changed, and only then.
import { ColorManagement, LinearSRGBColorSpace, Scene, WebGLRenderer } from 'three';
import { automaticScale, shown, toneScale } from './tone.js';
import { Surfaces } from './surfaces.js';

const luminance = [0.2126, 0.7152, 0.0722];

export class View {
  // drawn: called after each picture.
  constructor(canvas, scene, look, drawn) {
    ColorManagement.enabled = false; // the shaders know what they write
    this.scene = scene;
    this.look = look;
    this.drawn = drawn;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.surfaces = new Surfaces(scene);
    this.world = new Scene();
    this.world.add(this.surfaces.mesh);
    this.covered = () => [0, 0]; // how far the panel pushes the middle of the scene to the left and upwards, pixels
    this.fitted = null; // the light that the curve was fitted to
    this.scale = { low: 0, high: 1 };
    this.asked = false;
    this.last = 0;
    this.lampsChanged();
    window.addEventListener('resize', () => this.resize());
  }

  follow(navigation) {
    this.navigation = navigation;
    this.resize();
  }

  resize() {
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(window.innerWidth, window.innerHeight, false);
    this.navigation.shift(window.innerWidth, window.innerHeight, this.covered());
    this.ask();
  }

  lampsChanged() {
    this.surfaces.update(this.look.seeThrough);
    this.#sampleScale();
    this.ask();
  }

  // Another op, or a person's wish: the curve is fitted to what is in view at the next picture.
  refit() {
    this.fitted = null;
    this.ask();
  }

  ask() {
    if (this.asked || !this.navigation) return;
    this.asked = true;
    requestAnimationFrame((now) => {
      this.asked = false;
      this.#frame(now);
    });
  }

  #frame(now) {
    const seconds = Math.min(0.05, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    if (this.navigation.step(seconds)) this.ask();
    this.#draw();
    this.drawn();
  }

  #draw() {
    const { look, surfaces, renderer, world } = this;
    const { camera } = this.navigation;
    const { shared } = surfaces;
    if (!this.fitted || look.adapt) this.fitted = surfaces.lightInView(renderer, world, camera, camera.aspect);
    const scale = toneScale(look, this.fitted);
    const isLux = look.unit === 'lux', { efficacy } = this.scene.about;
    Object.assign(shared.measure, {
      value: this.scene.isSpectral ? [0, 0, 0, efficacy] : [...luminance.map((l) => (isLux ? efficacy * l : 1)), 0],
    });
    shared.show.value = look.show === 'light' ? 0 : 1;
    shared.curve.value = { neutral: 2, reinhard: 1 }[look.op] ?? 0;
    shared.tone_scale.value = scale;
    shared.white.value = look.white;
    shared.logarithmic.value = look.logarithmic;
    shared.isolines.value = look.isolines;
    shared.low.value = this.scale.low;
    shared.high.value = this.scale.high;
    const sky = look.show === 'light' ? shown(surfaces.skyRadiance(), look, scale) : [0.13, 0.14, 0.16];
    const [r, g, b] = sky.map((c) => Math.round(255 * c));
    renderer.setClearColor(65536 * r + 256 * g + b, 1);
    renderer.render(world, camera);
  }

  #sampleScale() {
    const { look, scene } = this;
    if (!look.automatic) {
      this.scale = { low: look.low, high: look.high };
      return;
    }
    const step = Math.ceil(scene.vertexCount / 10000);
    const values = [];
    for (let v = 0; v < scene.vertexCount; v += step)
      for (const side of [0, 1]) {
        const value = scene.arriving(v, side, look.unit);
        if (value > 0) values.push(value);
      }
    this.scale = automaticScale(values, look.logarithmic);
    Object.assign(look, this.scale);
  }
}
