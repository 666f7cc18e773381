// SPDX-License-Identifier: Apache-2.0
#include "luxel/views/look_around.h"

#include <algorithm>
#include <cmath>

#include "luxel/random/address.h"
#include "luxel/random/warp.h"

namespace luxel {
namespace {

// atan(q) * 4 / pi for q in [0, 1], within 0.005: enough to find a cell, and the same bits on every host.
float octant_share(float q) { return q * (1.0f + 0.3476f * (1.0f - q)); }

double fraction(const Look& look, bool (*is_counted)(std::uint32_t)) {
  const auto count = std::count_if(look.side.begin(), look.side.end(), is_counted);
  return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, look.side.size()));
}

bool sees(const Look& from, const Vec3& to, const LookGrid& grid) {
  const auto line = to - from.eye;
  const auto distance = glm::length(line);
  return !(distance > 0.0f) || distance < from.distance[grid.cell_of(line / distance)];
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

std::size_t LookGrid::cell_of(const Vec3& direction) const {
  const auto shrink = 1.0f / std::sqrt(1.0f + std::abs(direction.z));
  const auto x = direction.x * shrink;
  const auto y = direction.y * shrink;
  const bool wide = std::abs(x) > std::abs(y);
  const auto radius = std::copysign(std::sqrt(x * x + y * y), wide ? x : y);
  const auto major = wide ? x : y;
  const auto ratio = major == 0.0f ? 0.0f : (wide ? y : x) / major;
  const auto minor = radius * std::copysign(octant_share(std::abs(ratio)), ratio);
  const auto index = [&](float square) {
    const auto i = static_cast<int>(0.5f * (square + 1.0f) * static_cast<float>(n_));
    return static_cast<std::size_t>(std::clamp(i, 0, static_cast<int>(n_) - 1));
  };
  const auto in_hemisphere = index(wide ? minor : radius) * n_ + index(wide ? radius : minor);
  return direction.z < 0.0f ? n_ * n_ + in_hemisphere : in_hemisphere;
}

double Look::surface_fraction() const {
  return fraction(*this, [](std::uint32_t s) { return s != escaped && s != absorbed; });
}

double Look::escaped_fraction() const {
  return fraction(*this, [](std::uint32_t s) { return s == escaped; });
}

float Look::clearance() const {
  return distance.empty() ? 0.0f : *std::min_element(distance.begin(), distance.end());
}

std::uint32_t side_met(const PatchSet& patches, const Hit& hit) {
  if (!hit) return Look::escaped;
  if (hit.back && !patches.material_of(hit.patch).two_sided) return Look::absorbed;
  return 2 * hit.patch + (hit.back ? 1u : 0u);
}

Look look_around(const PatchSet& patches, const Tracer& tracer, const Vec3& eye, const LookGrid& grid,
                 std::uint64_t key) {
  std::vector<Ray> rays(grid.cells());
  for (std::size_t c = 0; c < rays.size(); ++c) {
    const auto u = uniform4(key, c);
    rays[c] = {eye, grid.direction(c, u[0], u[1])};
  }
  std::vector<Hit> hits(rays.size());
  tracer.nearest(rays, hits);
  Look look{eye, {}, {}};
  look.side.reserve(hits.size());
  look.distance.reserve(hits.size());
  for (const auto& hit : hits) {
    look.side.push_back(side_met(patches, hit));
    look.distance.push_back(hit.distance);
  }
  return look;
}

float mutual_visibility(const Look& a, const Look& b, const LookGrid& grid) {
  return (sees(a, b.eye, grid) ? 0.5f : 0.0f) + (sees(b, a.eye, grid) ? 0.5f : 0.0f);
}

}  // namespace luxel
