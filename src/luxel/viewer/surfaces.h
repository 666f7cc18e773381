// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "luxel/core/matrix.h"
#include "luxel/image/tone.h"
#include "luxel/patch/patch_set.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/viewer/colour_map.h"
#include "luxel/viewer/draw_vertices.h"
#include "luxel/viewer/local_tone.h"

namespace luxel {

// How surfaces are painted. Surfaces without a solution are drawn grey.
enum class Paint {
  grey,         // 0.6, a little darker where the surface turns away, so that shapes are seen
  light,        // through the tone curve
  curve_input,  // the luminance that the tone curve takes: what LocalTone looks at
  smooth,       // false colour of what the vertices show (VertexValue lux or watts)
  patches,      // false colour of one value a patch side
  sides         // blue fronts, red backs
};

struct SurfaceView {
  Mat4 projection = Mat4(1.0f);  // from the world (m) to clip space
  Vec3 eye = Vec3(0.0f);         // m
  Paint paint = Paint::grey;
  ToneCurve tone = {};  // light
  // Of reinhard_local: the light around each pixel, and where what is drawn lies in it. Null: as reinhard.
  const LocalTone* local = nullptr;
  PixelOffset from = {};
  ValueScale scale = {};  // smooth, patches
  bool wires = false;     // the patches' edges over it
};

class GlProgram;

// Sets the uniforms of tone_shader, of the program in use.
void set_tone(const GlProgram& program, const SurfaceView& view);

// The patches on the graphics card, both sides. Whatever it is given goes there in slices, so that no frame
// waits; the old is drawn until the new is whole. Needs the context that it was made in. Keeps what it is
// given.
class Surfaces {
 public:
  Surfaces();
  ~Surfaces();
  Surfaces(const Surfaces&) = delete;
  Surfaces& operator=(const Surfaces&) = delete;

  // Other patches: what was there is gone, and these are drawn grey as far as they have come.
  void set_mesh(std::shared_ptr<const PatchSet> patches);
  // A newer light of these patches, or another of its values. lit: the patches with the materials as they are
  // lit. Takes the place of one that waits its turn. All lights of a mesh have the same smooth vertices.
  void set_light(std::shared_ptr<const PatchSet> lit, std::shared_ptr<const SmoothLight> light,
                 VertexValue what);
  // [2 * patch + 1 for the back]; NaN is drawn grey.
  void set_side_values(std::shared_ptr<const std::vector<float>> values);

  // Continues for about this many seconds. Returns true where nothing is left to do.
  bool upload(double seconds);
  // What is drawn now: none of it before it is whole.
  bool has_light() const;
  bool has_side_values() const;
  bool shows_radiance() const;  // what Paint::light needs, else it is grey

  void draw(const SurfaceView& view);
  // Draws nothing visible, grey and as light: drivers compile a program when it is first drawn by, and that
  // takes longer than a frame may.
  void try_programs() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
