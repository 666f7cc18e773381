// SPDX-License-Identifier: Apache-2.0
// Where one looks from. Orbiting is three.js's OrbitControls; walking is here: look around by dragging, go by keys, or on
// a touch screen by the pad.
import { MathUtils, Matrix4, PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const keysOfWay = {
  KeyW: [0, 0, 1], ArrowUp: [0, 0, 1], KeyS: [0, 0, -1], ArrowDown: [0, 0, -1],
  KeyA: [-1, 0, 0], ArrowLeft: [-1, 0, 0], KeyD: [1, 0, 0], ArrowRight: [1, 0, 0],
  KeyE: [0, 1, 0], KeyQ: [0, -1, 0],
};
const steepest = 1.5; // radians of pitch

export class Navigation {
  constructor(canvas, scene, moved) {
    const { up, fov } = scene.about.camera;
    this.scene = scene;
    this.canvas = canvas;
    this.moved = moved;
    this.camera = new PerspectiveCamera(fov, 1, 1, 10);
    this.camera.up.set(...up).normalize();
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enableDamping = false;
    this.orbit.zoomToCursor = true;
    this.orbit.rotateSpeed = 0.7;
    this.orbit.maxDistance = 40 * scene.radius;
    this.orbit.minDistance = 1e-3 * scene.radius;
    this.orbit.listenToKeyEvents(canvas); // arrows shift, Shift and arrows turn
    this.orbit.addEventListener('change', moved);
    this.mode = 'orbit';
    this.held = new Set();
    this.push = [0, 0]; // of the pad, to the right and ahead
    // The ground plane's axes: whichever way is up.
    this.level = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), this.camera.up);
    this.#listen();
    this.home();
  }

  home() {
    const { eye, target, fov } = this.scene.about.camera;
    this.stand(eye, target, fov);
  }

  stand(eye, target, fov = this.camera.fov) {
    this.fov = fov;
    this.camera.position.set(...eye);
    this.orbit.target.set(...target);
    this.camera.lookAt(this.orbit.target);
    this.#takeUpView();
    this.orbit.update();
    this.resize(this.camera.aspect);
    this.moved();
  }

  // shift: pixels by which the middle of the scene is moved to the left and upwards, away from the panel.
  shift(width, height, [left, upwards]) {
    this.camera.setViewOffset(width, height, left, upwards, width, height);
    this.resize(width / height);
  }

  // A view is made for a screen that is wider than high; on one that is higher more is shown above and below.
  resize(aspect) {
    const half = Math.tan(MathUtils.degToRad(this.fov / 2));
    this.camera.aspect = aspect;
    this.camera.fov = aspect >= 1 ? this.fov
      : MathUtils.radToDeg(2 * Math.atan(Math.max(half, Math.min((0.85 * half) / aspect, 0.9))));
    this.#setDepths();
  }

  // Depth is shared out by where the scene is.
  #setDepths() {
    const { centre, radius } = this.scene;
    const away = this.camera.position.distanceTo(new Vector3(...centre));
    this.camera.near = Math.max(away - 1.01 * radius, 1e-3 * radius);
    this.camera.far = away + 1.01 * radius;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  setMode(mode) {
    if (mode === this.mode) return;
    this.mode = mode;
    this.orbit.enabled = mode === 'orbit';
    this.held.clear();
    if (mode === 'walk') return this.#takeUpView();
    // Turn about what is in the middle.
    const ahead = this.camera.getWorldDirection(new Vector3());
    const hit = this.scene.nearest(this.camera.position.toArray(), ahead.toArray(), true);
    this.orbit.target.copy(this.camera.position).addScaledVector(ahead, hit?.distance ?? this.scene.radius);
    this.orbit.update();
  }

  // A point comes to the middle; turning goes about it from now on.
  focus(point) {
    const to = new Vector3(...point);
    if (this.mode === 'walk') {
      this.camera.lookAt(to);
      this.#takeUpView();
    } else {
      this.orbit.target.copy(to);
      this.orbit.update();
    }
    this.moved();
  }

  // Nearer to what one turns about, or further away.
  near(factor) {
    this.camera.position.sub(this.orbit.target).multiplyScalar(factor).add(this.orbit.target);
    this.orbit.update();
    this.moved();
  }

  // Where one walks to by a double tap: most of the way.
  approach(point) {
    this.camera.position.lerp(new Vector3(...point), 0.7);
    this.focus(point);
  }

  // Direction of the sight through a point of the canvas, both coordinates in [-1, 1].
  sight(x, y) {
    this.camera.updateMatrixWorld();
    return new Vector3(x, y, 0.5).unproject(this.camera).sub(this.camera.position).normalize().toArray();
  }

  // Moves on by so many seconds; whether it moved.
  step(seconds) {
    if (this.mode === 'walk') this.#walk(seconds);
    this.#setDepths();
    return this.mode === 'walk' && (this.held.size > 0 || this.push.some((p) => p !== 0));
  }

  #walk(seconds) {
    const way = new Vector3(this.push[0], 0, this.push[1]);
    for (const key of this.held) if (keysOfWay[key]) way.add(new Vector3(...keysOfWay[key]));
    if (way.lengthSq() === 0) return;
    const ahead = this.camera.getWorldDirection(new Vector3());
    const up = this.camera.up;
    ahead.addScaledVector(up, -ahead.dot(up)).normalize(); // one walks on the level
    const aside = new Vector3().crossVectors(ahead, up);
    const pace = 0.45 * this.scene.radius * seconds * (this.held.has('ShiftLeft') || this.held.has('ShiftRight') ? 3 : 1);
    this.camera.position.addScaledVector(aside, pace * way.x).addScaledVector(up, pace * way.y).addScaledVector(ahead, pace * way.z);
  }

  // Yaw and pitch from how the camera looks.
  #takeUpView() {
    const ahead = this.camera.getWorldDirection(new Vector3()).applyQuaternion(this.level.clone().invert());
    this.yaw = Math.atan2(-ahead.x, -ahead.z);
    this.pitch = MathUtils.clamp(Math.asin(MathUtils.clamp(ahead.y, -1, 1)), -steepest, steepest);
  }

  #look(dx, dy) {
    const perPixel = MathUtils.degToRad(this.camera.fov) / this.canvas.clientHeight;
    this.yaw += dx * perPixel;
    this.pitch = MathUtils.clamp(this.pitch + dy * perPixel, -steepest, steepest);
    const turn = new Quaternion().setFromRotationMatrix(
      new Matrix4().makeRotationY(this.yaw).multiply(new Matrix4().makeRotationX(this.pitch)));
    this.camera.quaternion.copy(this.level).multiply(turn);
    this.moved();
  }

  #listen() {
    const { canvas } = this;
    let finger = null, x = 0, y = 0;
    canvas.addEventListener('pointerdown', (event) => {
      canvas.focus({ preventScroll: true });
      if (this.mode !== 'walk' || finger !== null) return;
      [finger, x, y] = [event.pointerId, event.clientX, event.clientY];
      canvas.setPointerCapture(finger);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (event.pointerId !== finger) return;
      this.#look(event.clientX - x, event.clientY - y); // the scene goes with the hand
      [x, y] = [event.clientX, event.clientY];
    });
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, (event) => { if (event.pointerId === finger) finger = null; });
    canvas.addEventListener('wheel', (event) => {
      if (this.mode !== 'walk') return;
      event.preventDefault();
      const ahead = this.camera.getWorldDirection(new Vector3());
      this.camera.position.addScaledVector(ahead, -Math.sign(event.deltaY) * 0.06 * this.scene.radius);
      this.moved();
    }, { passive: false });
    window.addEventListener('keydown', (event) => {
      if (this.mode !== 'walk' || event.ctrlKey || event.metaKey || event.altKey || isTyping(event)) return;
      if (!keysOfWay[event.code] && !event.code.startsWith('Shift')) return;
      if (keysOfWay[event.code]) event.preventDefault();
      this.held.add(event.code);
      this.moved();
    });
    window.addEventListener('keyup', (event) => this.held.delete(event.code));
    window.addEventListener('blur', () => this.held.clear());
  }
}

// Whether a key belongs to what has the focus: letters to what one types into, arrows to sliders and switches too.
export function isTyping({ target, code }) {
  if (target.tagName === 'SELECT') return true;
  return target.tagName === 'INPUT' && (code.startsWith('Arrow') || !['radio', 'checkbox', 'range'].includes(target.type));
}
