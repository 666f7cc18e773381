// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/portals.h"

#include <limits>

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

std::uint32_t Portals::first_crossed(const Ray& ray) const {
  if (empty()) return none;
  const auto hit = tracer_->nearest(ray);
  if (!hit || (hit.back && both_ways_[hit.patch] == 0)) return none;
  return 2 * hit.patch + (hit.back ? 1 : 0);
}

float Portals::distance(const Ray& ray) const {
  return empty() ? std::numeric_limits<float>::infinity() : tracer_->nearest(ray).distance;
}

}  // namespace luxel
