// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/look_around.h"

#include <algorithm>

#include "luxel/core/address.h"
#include "luxel/core/warp.h"
#include "luxel/patch/side.h"

namespace luxel {
namespace {

double fraction(const Panorama& look, bool (*is_counted)(SideId)) {
  const auto count = std::count_if(look.side.begin(), look.side.end(), is_counted);
  return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, look.side.size()));
}

}  // namespace

Vec3 LookGrid::direction(std::size_t cell, float u1, float u2) const {
  const auto in_hemisphere = cell % (n_ * n_);
  const auto n = static_cast<float>(n_);
  auto d = uniform_hemisphere((static_cast<float>(in_hemisphere % n_) + u1) / n,
                              (static_cast<float>(in_hemisphere / n_) + u2) / n);
  if (cell >= n_ * n_) d.z = -d.z;
  return d;
}

double Panorama::surface_fraction() const { return fraction(*this, is_side); }

double Panorama::escaped_fraction() const {
  return fraction(*this, [](SideId s) { return s == escaped; });
}

float Panorama::clearance() const {
  return distance.empty() ? 0.0f : *std::min_element(distance.begin(), distance.end());
}

SideId side_met(const PatchSet& patches, const Hit& hit) {
  if (!hit) return Panorama::escaped;
  if (hit.back && !patches.material_of(hit.patch).two_sided) return Panorama::absorbed;
  return {hit.patch, hit.back};
}

Panorama look_around(const PatchSet& patches, const Tracer& tracer, const Vec3& eye, const LookGrid& grid,
                     std::uint64_t key) {
  std::vector<Ray> rays(grid.cells());
  for (std::size_t c = 0; c < rays.size(); ++c) {
    const auto u = uniform4(key, c);
    rays[c] = {eye, grid.direction(c, u[0], u[1])};
  }
  std::vector<Hit> hits(rays.size());
  tracer.nearest(rays, hits);
  Panorama look{eye, {}, {}};
  look.side.reserve(hits.size());
  look.distance.reserve(hits.size());
  for (const auto& hit : hits) {
    look.side.push_back(side_met(patches, hit));
    look.distance.push_back(hit.distance);
  }
  return look;
}

}  // namespace luxel
