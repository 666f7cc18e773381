// SPDX-License-Identifier: Apache-2.0
// What lies behind all surfaces: a uniform sky, shown with a horizon.
import { BufferAttribute, BufferGeometry, GLSL3, Matrix4, Mesh, NoBlending, RawShaderMaterial, Vector3 } from 'three';
import { skyFragmentShader, skyVertexShader } from './shaders.js';

export class Sky {
  // shared: the uniforms of the tone curve.
  // ground: its radiance, relative to that of the sky.
  constructor({ curve, tone_scale, white }, ground) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    this.uniforms = {
      from_screen: { value: new Matrix4() }, sky: { value: new Vector3() }, zenith: { value: new Vector3() },
      ground: { value: ground }, curve, tone_scale, white,
    };
    const material = new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: skyVertexShader, fragmentShader: skyFragmentShader, uniforms: this.uniforms,
      blending: NoBlending, depthTest: false, depthWrite: false,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -1;
    this.mesh.visible = false;
  }

  // radiance: of the sky; black: there is none to show. The camera's matrices are those of the next picture.
  follow(camera, radiance) {
    this.mesh.visible = radiance.some((c) => c > 0);
    this.uniforms.sky.value.set(...radiance);
    this.uniforms.zenith.value.copy(camera.up);
    this.uniforms.from_screen.value.copy(camera.projectionMatrix).multiply(camera.matrixWorldInverse).invert();
  }
}
