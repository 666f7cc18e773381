// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/portals.h"

#include "luxel/core/none.h"

namespace luxel {

Portals::Portals(const PatchSet& patches) {
  if (patches.portals.empty()) return;
  PatchSet triangles;  // bare geometry, [portal]
  for (const auto& portal : patches.portals) {
    const auto first = static_cast<std::uint32_t>(triangles.vertices.size());
    triangles.vertices.insert(triangles.vertices.end(), portal.corner.begin(), portal.corner.end());
    triangles.corners.push_back({first, first + 1, first + 2});
    both_ways_.push_back(portal.both_ways ? 1 : 0);
  }
  tracer_ = std::make_shared<const Tracer>(triangles, Context(1));
}

Hit Portals::nearest(const Ray& ray) const { return empty() ? Hit{} : tracer_->nearest(ray); }

std::uint32_t Portals::first_crossed(const Ray& ray) const {
  const auto hit = nearest(ray);
  if (!hit || (hit.back && both_ways_[hit.patch] == 0)) return none;
  return 2 * hit.patch + (hit.back ? 1 : 0);
}

}  // namespace luxel
