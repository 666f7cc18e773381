// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/form_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "luxel/core/address.h"
#include "luxel/core/triangle.h"
#include "luxel/form_factors/obstructed_exchange.h"
#include "luxel/form_factors/polygon_form_factor.h"
#include "luxel/form_factors/ray_exchange.h"
#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr double closed_form_error = 1e-12;
constexpr std::size_t max_screens = 200;
constexpr std::uint64_t seed = 0x666f726d;  // of the shadow rays; arbitrary but fixed

std::array<Vec3d, 3> corners_of(const PatchSet& patches, std::size_t patch) {
  const auto p = patches.points(patch);
  return {Vec3d(p[0]), Vec3d(p[1]), Vec3d(p[2])};
}

// The corners, counter-clockwise seen from that side.
std::array<Vec3d, 3> polygon_of(const PatchSet& patches, SideId side) {
  auto corners = corners_of(patches, side.patch());
  if (side.is_back()) std::swap(corners[1], corners[2]);
  return corners;
}

double rounding_of(const PatchSet& patches) {
  float largest = 0.0f;
  for (const auto& v : patches.vertices)
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return 0x1p-21 * static_cast<double>(largest);
}

}  // namespace

FormFactors::FormFactors(const PatchSet& patches, const Tracer& tracer)
    : patches_(patches),
      tracer_(tracer),
      slack_(rounding_of(patches)),
      occluders_(patches, slack_),
      search_(occluders_) {}

FormFactor FormFactors::between(SideId from, SideId to, double tolerance) const {
  const auto a = polygon_of(patches_, from), b = polygon_of(patches_, to);
  const auto parts = facing_parts(a, b);
  if (parts.a.empty()) return {};

  std::vector<std::uint32_t> found;
  const bool all_found = search_.find(Shaft(parts.a, parts.b, slack_), max_screens, found);
  if (std::any_of(found.begin(), found.end(), [&](std::uint32_t k) {
        return hides_all(occluders_.polygon(k), parts.a, parts.b, slack_);
      }))
    return {0.0, closed_form_error, true};
  const auto area = glm::length(polygon_area_vector(a));
  const auto open = polygon_exchange_area(a, b);
  if (found.empty()) return {open / area, closed_form_error, true};
  // The open part is below the tolerance: return the middle of [0, open].
  if (open <= 0.1 * tolerance * area) return {0.5 * open / area, 0.5 * open / area, false};

  Estimate exchange;
  if (all_found) {
    std::vector<OccludingPolygon> screens;
    for (const auto k : found) screens.push_back(occluders_.polygon(k));
    exchange = obstructed_exchange(parts.a, parts.b, screens, open,
                                   {.tolerance = tolerance * area, .slack = slack_});
  } else {
    const auto key = stream_key(seed, from.index(), to.index());
    exchange = ray_exchange(tracer_, PatchEmitter(patches_, from), area, parts.b, open,
                            {.tolerance = tolerance * area, .key = key});
  }
  return {exchange.value / area, exchange.error / area + closed_form_error, false};
}

}  // namespace luxel
