// SPDX-License-Identifier: Apache-2.0
// The picture: drawn when something has changed, and smoothed while nothing does.
import { ColorManagement, LinearSRGBColorSpace, Scene, WebGLRenderer } from 'three';
import { Luminaires } from './luminaires.js';
import { Sky } from './sky.js';
import { Smoothing } from './smoothing.js';
import { Surfaces } from './surfaces.js';
import { automaticScale, levelsOf, shareOf, toneScale } from './tone.js';

const luminance = [0.2126, 0.7152, 0.0722];

export class View {
  // drawn: called after each picture; smoothed: after the last one at rest.
  constructor(canvas, scene, look, drawn, smoothed) {
    ColorManagement.enabled = false; // the shaders know what they write
    this.scene = scene;
    this.look = look;
    this.drawn = drawn;
    this.smoothed = smoothed;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.smoothing = new Smoothing(this.renderer);
    this.surfaces = new Surfaces(scene, Math.min(8, this.renderer.capabilities.getMaxAnisotropy()));
    this.world = new Scene();
    this.sky = new Sky(this.surfaces.shared, scene.about.ground);
    this.luminaires = new Luminaires(scene, this.surfaces.shared);
    this.world.add(...this.surfaces.meshes, this.sky.mesh, this.luminaires.bodies, this.luminaires.wires);
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
    const { clientWidth, clientHeight } = this.renderer.domElement;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.navigation.shift(clientWidth, clientHeight, this.covered());
    this.ask();
  }

  lampsChanged() {
    this.surfaces.update(this.look.seeThrough);
    this.#sampleScale();
    this.ask();
  }

  // Fits the curve to the view of the next picture.
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
    this.#prepare();
    this.renderer.render(this.world, this.navigation.camera);
    this.drawn();
    this.smoothing.begin();
    this.#smooth();
  }

  // One more picture per frame, until something changes.
  #smooth() {
    if (this.asked) return;
    if (this.smoothing.isDone) {
      this.smoothed();
      return;
    }
    requestAnimationFrame(() => {
      if (this.asked) return;
      this.#show();
      this.smoothing.step(this.world, this.navigation.camera);
      this.#smooth();
    });
  }

  // Sets what the next pictures show.
  #prepare() {
    const { look, surfaces, renderer, world, sky } = this;
    const { camera } = this.navigation;
    sky.follow(camera, [0, 0, 0]);
    this.luminaires.show(camera, { show: 'light', solids: false }); // they count
    const { shared } = surfaces;
    if (!this.fitted || look.adapt) this.fitted = surfaces.lightInView(renderer, world, camera, camera.aspect);
    const scale = toneScale(look, this.fitted);
    const isLux = look.unit === 'lux', { efficacy } = this.scene.about;
    shared.measure.value = this.scene.isSpectral ? [0, 0, 0, efficacy] : [...luminance.map((l) => (isLux ? efficacy * l : 1)), 0];
    shared.show.value = look.show === 'light' ? 0 : 1;
    shared.curve.value = { neutral: 2, reinhard: 1 }[look.op] ?? 0;
    shared.tone_scale.value = scale;
    shared.white.value = look.white;
    shared.logarithmic.value = look.logarithmic;
    shared.isolines.value = look.isolines;
    shared.low.value = this.scale.low;
    shared.high.value = this.scale.high;
    const levels = levelsOf(this.scale, look.logarithmic).map((value) => shareOf(value, this.scale, look.logarithmic));
    shared.levels.value.set(levels);
    shared.level_count.value = levels.length;
    this.#show();
  }

  // Sky, luminaires and background, which measurements hide.
  #show() {
    const { look, renderer, sky } = this, { camera } = this.navigation;
    sky.follow(camera, look.show === 'light' ? this.surfaces.skyRadiance() : [0, 0, 0]);
    this.luminaires.show(camera, look);
    renderer.setClearColor(look.show === 'light' ? 0x000000 : 0x212429, 1);
  }

  // For the numbers on the lines of equal light.
  measured(width, height) {
    this.sky.follow(this.navigation.camera, [0, 0, 0]);
    this.luminaires.hide();
    return this.surfaces.measuredInView(this.renderer, this.world, this.navigation.camera, width, height);
  }

  #sampleScale() {
    const { look, scene } = this;
    if (!look.automatic) {
      this.scale = { low: look.low, high: look.high };
      return;
    }
    this.scale = automaticScale(scene.samples(look.unit), look.logarithmic);
    Object.assign(look, this.scale);
  }
}
