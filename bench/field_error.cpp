// SPDX-License-Identifier: Apache-2.0
#include "bench/field_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "luxel/core/address.h"
#include "luxel/core/barycentric.h"
#include "luxel/core/discrete_distribution.h"
#include "luxel/core/warp.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/point_irradiance.h"
#include "luxel/trace/tracer.h"

namespace luxel::bench {
namespace {

constexpr std::uint32_t place_step = 0x706c6163u;

// Even over the area: the areas of all patches laid end to end are cut into as many equal pieces as there are
// points, and each point is drawn from one piece.
std::vector<SurfacePoint> draw_points(const PatchSet& patches, std::size_t count,
                                      const PatchChoice& only_on) {
  DiscreteDistribution by_area;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    by_area.add(!only_on || only_on(patches, p) ? static_cast<double>(patches.area[p]) : 0.0);
  }
  std::vector<SurfacePoint> points;
  const auto key = stream_key(1, place_step, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto u = uniform4(key, i);
    const auto at =
        by_area.total() * (static_cast<double>(i) + static_cast<double>(u[0])) / static_cast<double>(count);
    const auto patch = by_area.at(at);
    points.push_back(surface_point(patches, patch, u[3] < 0.5f, uniform_triangle(u[1], u[2])));
  }
  return points;
}

// Returns the patch of a triangle of the scene that contains a point, or is nearest to it.
struct Place {
  std::size_t patch = 0;
  Vec2 weights{0.0f};
};
Place place_of(const PatchSet& patches, std::uint32_t triangle, const Vec3& point) {
  const auto [first, last] = std::equal_range(patches.triangle.begin(), patches.triangle.end(), triangle);
  Place best;
  float inside = -std::numeric_limits<float>::infinity();
  for (auto it = first; it != last; ++it) {
    const auto patch = static_cast<std::size_t>(it - patches.triangle.begin());
    const auto all = barycentric(patches.points(patch), point);
    const Vec2 w(all.y, all.z);
    const auto least = std::min({w.x, w.y, 1.0f - w.x - w.y});
    if (!(least > inside)) continue;
    inside = least;
    best = {patch, w};
  }
  return best;
}

}  // namespace

Field drawn_field(const SmoothLight& smooth, std::size_t bands) {
  return [&smooth, bands](std::size_t patch, bool back, const Vec2& w, double* light) {
    const auto& h = smooth.irradiance.of(back);
    const auto& c = smooth.corners[patch];
    const std::array<float, 3> weight = {1.0f - w.x - w.y, w.x, w.y};
    for (std::size_t b = 0; b < bands; ++b) {
      light[b] = 0.0;
      for (std::size_t k = 0; k < 3; ++k) light[b] += static_cast<double>(weight[k] * h[c[k] * bands + b]);
    }
  };
}

PointTruth::PointTruth(const Scene& scene, const TrueNormal& normal, std::size_t points, std::uint64_t paths,
                       const Context& context, const PatchChoice& only_on) {
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  const Tracer tracer(patches, context);
  bands_ = patches.band_count();
  points_ = draw_points(patches, points, only_on);
  for (auto& p : points_) {
    triangle_.push_back(patches.triangle[p.patch]);
    p.normal = normal(patches, p.patch, p.position, p.normal);
  }
  light_ = irradiance_at(patches, tracer, points_, paths, 1, context);
  again_ = irradiance_at(patches, tracer, points_, paths, 2, context);
}

PointTruth::Sums PointTruth::sums(const PatchSet& patches, const Field& field) const {
  Sums sums;
  std::vector<double> value(bands_);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto place = place_of(patches, triangle_[i], points_[i].position);
    field(place.patch, points_[i].back, place.weights, value.data());
    double product = 0.0;
    for (std::size_t b = 0; b < bands_; ++b) {
      const auto t = light_[i * bands_ + b], again = again_[i * bands_ + b];
      product += (value[b] - t) * (value[b] - again);
      sums.truth += t * again;
    }
    sums.product += product;
    sums.square += product * product;
  }
  return sums;
}

double PointTruth::error(const PatchSet& patches, const Field& field) const {
  const auto s = sums(patches, field);
  return std::sqrt(std::max(0.0, s.product / s.truth));
}

double PointTruth::noise(const PatchSet& patches, const Field& field) const {
  const auto s = sums(patches, field);
  return std::sqrt(s.square) / s.truth;
}

}  // namespace luxel::bench
