// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "luxel/core/warp.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The light of the sky, as it comes in: through the six faces of a box around the scene, each of which sends
// inwards as a surface of the sky's radiance would. A line that meets the scene crosses the faces inwards
// once, so every one counts once; most boxes are tight, so few miss.
class SkyBox {
 public:
  static constexpr std::size_t faces = 6;

  // A little larger than all patches, so that no origin lies on one.
  explicit SkyBox(const PatchSet& patches);

  // m²
  double area(std::size_t face) const;
  // A uniform point, a cosine direction. u: four numbers uniform in [0, 1).
  Ray ray(std::size_t face, const std::array<float, 4>& u) const;

 private:
  Vec3 low_, high_;
};

// Returns whether a ray met a side that takes part in the exchange of light: any but the back of a one-sided
// material.
inline bool takes_part(const PatchSet& patches, const Hit& hit) {
  return hit && (!hit.back || patches.material_of(hit.patch).two_sided);
}

// Estimates the fraction of that light that meets a side that takes part, by a few thousand rays: accurate to
// a few per cent of all light, and reproducible. Costs some milliseconds.
double sky_hit_fraction(const PatchSet& patches, const Tracer& tracer, const SkyBox& box);

}  // namespace luxel
