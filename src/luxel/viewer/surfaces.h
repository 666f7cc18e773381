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

// Painting of surfaces. Surfaces without a solution are drawn grey.
enum class Paint {
  grey,         // 0.6, darker where the surface turns away, so that shapes are visible
  light,        // through the tone curve
  curve_input,  // the luminance before the tone curve: the input of LocalTone
  smooth,       // false colour of the vertex values (VertexValue lux or watts)
  patches,      // false colour of one value per patch side
  sides         // blue fronts, red backs
};

struct SurfaceView {
  Mat4 projection = Mat4(1.0f);  // from the world (m) to clip space
  Vec3 eye = Vec3(0.0f);         // m
  Paint paint = Paint::grey;
  ToneCurve tone = {};  // light
  // For reinhard_local: light around each pixel, and the offset of the drawn part in it. Null: as reinhard.
  const LocalTone* local = nullptr;
  PixelOffset from = {};
  ValueScale scale = {};  // smooth, patches
  bool wires = false;     // the patches' edges over it
};

class GlProgram;

// Sets the uniforms of tone_shader, of the program in use.
void set_tone(const GlProgram& program, const SurfaceView& view);

// The patches on the graphics card, both sides. New data are uploaded in slices, so that no frame
// waits; the old data are drawn until the new ones are complete. Needs the context that it was made in.
// Keeps its input alive.
class Surfaces {
 public:
  Surfaces();
  ~Surfaces();
  Surfaces(const Surfaces&) = delete;
  Surfaces& operator=(const Surfaces&) = delete;

  // Replaces the patches; the new ones are drawn grey as they arrive.
  void set_mesh(std::shared_ptr<const PatchSet> patches);
  // Sets a newer light of these patches, or another of its values. lit: the patches with their lit materials.
  // Replaces a light that waits. All lights of a mesh have the same smooth vertices.
  void set_light(std::shared_ptr<const PatchSet> lit, std::shared_ptr<const SmoothLight> light,
                 VertexValue what);
  // [2 * patch + 1 for the back]; NaN is drawn grey.
  void set_side_values(std::shared_ptr<const std::vector<float>> values);

  // Continues for about this many seconds. Returns true where nothing is left to do.
  bool upload(double seconds);
  // The data that are drawn now; incomplete data are not drawn.
  bool has_light() const;
  bool has_side_values() const;
  bool shows_radiance() const;  // needed by Paint::light, which is grey otherwise

  void draw(const SurfaceView& view);
  // Draws nothing visible, grey and as light: drivers compile a program when it is first drawn by, and that
  // takes longer than a frame may.
  void try_programs() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
