// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/band_colours.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// An opening of a luminaire on a ray.
struct SeenOpening {
  Vec3d radiance{0.0};    // W/(m² sr), linear sRGB
  float distance = 0.0f;  // m
};

// The openings of luminaires as pictures show them: bright surfaces whose radiance towards the eye is the
// radiant intensity in that direction over the projected area. They are no part of the transport. Read-only:
// any number of threads may call.
class VisibleLuminaires {
 public:
  // Keeps a reference to the patches.
  VisibleLuminaires(const PatchSet& patches, const BandColours& colours);

  bool empty() const { return openings_.empty(); }
  // The first opening on the ray before a surface at this distance (infinite: none); nothing where there is
  // none. An opening shortly behind the surface, as of a recessed luminaire, is seen. Costs 5 ns per
  // luminaire.
  std::optional<SeenOpening> first(const Ray& ray, float distance) const;

 private:
  struct Opening {
    const PointLight* light = nullptr;
    Vec3d colour{0.0};     // W/sr where the distribution is largest
    double radius2 = 0.0;  // m², of the bounding sphere
  };
  std::vector<Opening> openings_;
};

}  // namespace luxel
