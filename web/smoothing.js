// SPDX-License-Identifier: Apache-2.0
// A picture at rest: the mean of pictures shifted by parts of a pixel, so that cracks and thin things, which the samples of one
// picture hit here and there, are lines and not dots.
import {
  AddEquation, CustomBlending, GLSL3, HalfFloatType, Mesh, NearestFilter, NoBlending, OneFactor, OrthographicCamera, PlaneGeometry,
  RawShaderMaterial, Scene, WebGLRenderTarget,
} from 'three';

const count = 16; // pictures, of four samples each

const vertexShader = `
in vec3 position;
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }`;

const fragmentShader = `
precision highp float;
uniform sampler2D picture;
uniform float part;
layout(location = 0) out vec4 pixel;
void main() { pixel = part * texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }`;

// Where picture k is shifted to, in pixels from -1/2 to 1/2: steps of the plastic number, which fill a square evenly.
const shiftOf = (k) => [0.7548776662466927, 0.5698402909980532].map((step) => ((0.5 + k * step) % 1) - 0.5);

export class Smoothing {
  constructor(renderer) {
    this.renderer = renderer;
    const isAble = renderer.extensions.has('EXT_color_buffer_float') || renderer.extensions.has('EXT_color_buffer_half_float');
    this.added = isAble ? 0 : count;
    if (!isAble) return;
    const filters = { minFilter: NearestFilter, magFilter: NearestFilter };
    this.one = new WebGLRenderTarget(1, 1, { ...filters, samples: 4 });
    this.sum = new WebGLRenderTarget(1, 1, { ...filters, type: HalfFloatType, depthBuffer: false });
    this.uniforms = { picture: { value: null }, part: { value: 1 } };
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, uniforms: this.uniforms, depthTest: false, depthWrite: false,
      blendEquation: AddEquation, blendSrc: OneFactor, blendDst: OneFactor,
    });
    const quad = new Mesh(new PlaneGeometry(2, 2), this.material);
    quad.frustumCulled = false;
    this.screen = new Scene().add(quad);
    this.flat = new OrthographicCamera();
  }

  get isDone() {
    return this.added >= count;
  }

  // The picture has changed: the next one is the first again.
  begin() {
    if (this.one) this.added = 0;
  }

  // Draws one more picture of the sum, and after the last one shows the mean.
  step(world, camera) {
    const { renderer, one, sum } = this;
    const { width, height } = renderer.domElement;
    one.setSize(width, height);
    sum.setSize(width, height);
    const [x, y] = shiftOf(this.added), { elements } = camera.projectionMatrix;
    const before = [elements[8], elements[9]];
    elements[8] += (2 * x) / width;
    elements[9] += (2 * y) / height;
    renderer.setRenderTarget(one);
    renderer.render(world, camera);
    [elements[8], elements[9]] = before;
    this.#copy(one, sum, 1 / count, this.added > 0);
    if (++this.added === count) this.#copy(sum, null, 1, false);
  }

  // Writes a part of a picture to a target, or adds it.
  #copy(from, to, part, adds) {
    const { renderer, material, uniforms } = this;
    uniforms.picture.value = from.texture;
    uniforms.part.value = part;
    material.blending = adds ? CustomBlending : NoBlending;
    renderer.setRenderTarget(to);
    renderer.autoClear = false;
    renderer.render(this.screen, this.flat);
    renderer.autoClear = true;
    renderer.setRenderTarget(null);
  }
}
