// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lit_side.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "luxel/core/unit_vector.h"
#include "luxel/lamps/clip_triangle.h"
#include "luxel/lamps/polygon_irradiance.h"

namespace luxel {
namespace {

// Measured in a room with 2 to 24 lamps and patches with edges of up to 5, 15 and 40 cm: the error of the sum
// over lamps is 1e-5 to 6e-4 RMS over sides, 0.016 on the worst side, and below 1e-4 in the total of all
// sides.
constexpr double series_reach =
    0.04;  // largest variance of patch and lamp over distance² for which the series is used
constexpr double series_error = 1.0;  // of the series, per square of that variance and of area / distance²
constexpr double one_point_error = 0.3;    // of the centroid rule, per (radius / distance)²
constexpr double three_point_error = 0.1;  // of the three-point rule, per (radius / distance)³
constexpr double allowed_error = 2e-4;     // of one lamp, relative to the sum over all
// difference between the one-point and three-point rules above which a triangle is split
constexpr double split_error = 0.004;
constexpr int deepest = 9;  // levels of subdivision

using Corners = std::array<Vec3d, 3>;
using Heights = std::array<double, 3>;

Heights heights(const Corners& corners, const Vec3d& normal, const Vec3d& at) {
  return {glm::dot(normal, corners[0] - at), glm::dot(normal, corners[1] - at),
          glm::dot(normal, corners[2] - at)};
}
double low(const Heights& h) { return std::min({h[0], h[1], h[2]}); }
double high(const Heights& h) { return std::max({h[0], h[1], h[2]}); }

Vec3d centre_of(const Corners& t) { return (t[0] + t[1] + t[2]) / 3.0; }

double doubled_area(const Corners& t) { return glm::length(glm::cross(t[1] - t[0], t[2] - t[0])); }

// Two vectors whose outer products sum to the covariance of a uniform point of the triangle.
struct Scatter {
  Vec3d a, b;
  double variance;

  explicit Scatter(const Corners& t)
      : a(0.23570226039551584 * (t[1] - 0.5 * (t[0] + t[2]))),  // 1 / sqrt 18
        b(0.20412414523193151 * (t[2] - t[0])),                 // 1 / sqrt 24
        variance(glm::dot(a, a) + glm::dot(b, b)) {}
};

// Mean over both triangles of (n . r) (-m . r) / r^4, with r from a point of one to a point of the other: the
// value between their centroids plus half the second derivative along the scatter of r.
double series(const Vec3d& r, const Vec3d& n, const Vec3d& m, const Scatter& patch, const Scatter& lamp) {
  const auto inverse = 1.0 / glm::dot(r, r);
  const auto here = glm::dot(n, r);
  const auto there = -glm::dot(m, r);
  const auto product = here * there;
  double second = 0.0;
  const auto add = [&](const Vec3d& e, double other, double slope) {
    // other: the cosine that is constant along e; slope: the derivative of the cosine that varies.
    const auto along = 2.0 * glm::dot(r, e) * inverse;
    second += -4.0 * other * slope * along + product * (6.0 * along * along - 4.0 * glm::dot(e, e) * inverse);
  };
  add(patch.a, here, -glm::dot(m, patch.a));
  add(patch.b, here, -glm::dot(m, patch.b));
  add(lamp.a, there, glm::dot(n, lamp.a));
  add(lamp.b, there, glm::dot(n, lamp.b));
  return (product + 0.5 * second) * inverse * inverse;
}

// One side of a patch.
struct Patch {
  Corners corners;
  Vec3d n;
  Vec3d centroid = centre_of(corners);
  Scatter scatter{corners};
  double radius = std::max({glm::length(corners[0] - centroid), glm::length(corners[1] - centroid),
                            glm::length(corners[2] - centroid)});
};

// The part of a patch in front of a lamp whose plane cuts the patch.
struct Part {
  std::array<Corners, 2> facet{};
  std::array<double, 2> facet_fraction{};  // of the patch
  std::size_t facets = 0;
  double fraction = 0.0;
  Vec3d middle{0.0};

  Part(const Corners& corners, const Heights& before) {
    std::array<Vec3d, 4> corner;
    const auto count = static_cast<std::size_t>(clip_triangle(corners, before, corner));
    for (std::size_t i = 2; i < count; ++i, ++facets) {
      facet[facets] = {corner[0], corner[i - 1], corner[i]};
      facet_fraction[facets] = doubled_area(facet[facets]) / doubled_area(corners);
      fraction += facet_fraction[facets];
      middle += facet_fraction[facets] * centre_of(facet[facets]);
    }
    if (fraction > 0.0) middle /= fraction;
  }
};

// A first value for a lamp and its error estimate, W/m² at unit radiance.
struct Rough {
  double irradiance = 0.0;
  double error = 0.0;
  double three_point = 0.0;  // error estimate of the three-point rule
};

Rough rough(const LampTriangle& lamp, const Corners& at, const Patch& patch, const Heights& above,
            const Heights& before) {
  const auto to = centre_of(at) - patch.centroid;
  const auto distance2 = glm::dot(to, to);
  const auto flat = lamp.area / distance2;
  if (low(above) >= 0.0 && low(before) >= 0.0) {
    const Scatter scatter(at);
    const auto spread = (patch.scatter.variance + scatter.variance) / distance2;
    if (spread < series_reach) {
      const auto error = series_error * flat * spread * spread;
      return {std::max(0.0, lamp.area * series(to, patch.n, lamp.normal, patch.scatter, scatter)), error,
              error};
    }
  }
  // Where the lamp's plane cuts the patch, the irradiance may jump from 0 to half of the total.
  if (low(before) < 0.0) {
    const Part part(patch.corners, before);
    return {part.fraction * unit_irradiance(lamp, part.middle, patch.n), flat, flat};
  }
  const auto irradiance = unit_irradiance(lamp, patch.centroid, patch.n);
  const auto height = -glm::dot(lamp.normal, Vec3d(lamp.corner[0]) - patch.centroid);
  const auto distance = std::max(std::sqrt(distance2) - 0.6 * lamp.longest_edge, height);
  const auto ratio = patch.radius / distance;
  return {irradiance, irradiance * one_point_error * ratio * ratio,
          irradiance * three_point_error * ratio * ratio * ratio};
}

double three_points(const LampTriangle& lamp, const Corners& t, const Vec3d& centroid, const Vec3d& n) {
  double sum = 0.0;
  for (const auto& corner : t) sum += unit_irradiance(lamp, 0.5 * (centroid + corner), n);
  return sum / 3.0;
}

// The mean over a triangle that is this fraction of the patch, times the fraction; the triangle is split
// where the one-point and three-point rules disagree.
double fine(const LampTriangle& lamp, const Corners& t, const Vec3d& n, double fraction, double allowed,
            int depth) {
  const auto centroid = centre_of(t);
  const auto three = three_points(lamp, t, centroid, n);
  if (depth == deepest) return fraction * three;
  const auto difference = std::fabs(three - unit_irradiance(lamp, centroid, n));
  if (difference * std::sqrt(fraction) <= std::max(allowed, split_error * three * fraction))
    return fraction * three;
  const Vec3d ab = 0.5 * (t[0] + t[1]);
  const Vec3d bc = 0.5 * (t[1] + t[2]);
  const Vec3d ca = 0.5 * (t[2] + t[0]);
  double sum = 0.0;
  for (const auto& child :
       {Corners{t[0], ab, ca}, Corners{ab, t[1], bc}, Corners{ca, bc, t[2]}, Corners{bc, ca, ab}})
    sum += fine(lamp, child, n, fraction / 4.0, allowed, depth + 1);
  return sum;
}

double fine(const LampTriangle& lamp, const Patch& patch, const Heights& before, double allowed) {
  if (low(before) >= 0.0) return fine(lamp, patch.corners, patch.n, 1.0, allowed, 0);
  const Part part(patch.corners, before);
  double sum = 0.0;
  for (std::size_t i = 0; i < part.facets; ++i)
    if (part.facet_fraction[i] > 0.0)
      sum += fine(lamp, part.facet[i], patch.n, part.facet_fraction[i], allowed, 0);
  return sum;
}

}  // namespace

void find_side_lamps(const Lamps& lamps, std::span<const std::uint32_t> candidates,
                     const std::array<Vec3, 3>& corners, const Vec3& n, bool mean,
                     std::vector<SideLamp>& found) {
  assert(is_unit(n));
  found.clear();
  const Patch patch{{Vec3d(corners[0]), Vec3d(corners[1]), Vec3d(corners[2])}, Vec3d(n)};
  const auto before = [&](const LampTriangle& lamp) {
    return heights(patch.corners, lamp.normal, Vec3d(lamp.corner[0]));
  };
  // 1. First values.
  double total = 0.0;
  for (const auto i : candidates) {
    const auto& lamp = lamps.triangles()[i];
    const Corners at = {Vec3d(lamp.corner[0]), Vec3d(lamp.corner[1]), Vec3d(lamp.corner[2])};
    const auto over_patch = heights(at, patch.n, patch.corners[0]);
    const auto over_lamp = before(lamp);
    if (!(high(over_patch) > 0.0) || !(high(over_lamp) > 0.0)) continue;
    const auto value = rough(lamp, at, patch, over_patch, over_lamp);
    total += lamp.weight * value.irradiance;
    found.push_back({i, value.irradiance, lamp.weight * value.error, lamp.weight * value.three_point});
  }
  if (!mean) return;
  // 2. More accurate values for the lamps that matter.
  const auto allowed = allowed_error * total;
  for (auto& f : found) {
    if (f.error <= allowed) continue;
    const auto& lamp = lamps.triangles()[f.lamp];
    if (f.three_point <= allowed)
      f.irradiance = three_points(lamp, patch.corners, patch.centroid, patch.n);
    else
      f.irradiance = fine(lamp, patch, before(lamp), split_error * total / lamp.weight);
  }
}

}  // namespace luxel
