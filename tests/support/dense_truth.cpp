// SPDX-License-Identifier: Apache-2.0
#include "support/dense_truth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "luxel/core/triangle.h"
#include "luxel/patch/side.h"

namespace luxel::truth {
namespace {

using Corners = std::array<Vec3d, 3>;

struct Patch {
  Corners corners;
  Vec3d normal, centroid;
  double area = 0.0;
  double radius = 0.0;
  ConvexPolygon polygon;
};

std::vector<Patch> in_double(const PatchSet& patches) {
  std::vector<Patch> all(patches.size());
  for (std::size_t p = 0; p < all.size(); ++p) {
    const auto points = patches.points(p);
    auto& patch = all[p];
    patch.corners = {Vec3d(points[0]), Vec3d(points[1]), Vec3d(points[2])};
    patch.normal = glm::normalize(area_vector2(points[0], points[1], points[2]));
    patch.centroid = (patch.corners[0] + patch.corners[1] + patch.corners[2]) / 3.0;
    patch.area = triangle_area(points[0], points[1], points[2]);
    for (const auto& c : patch.corners)
      patch.radius = std::max(patch.radius, glm::distance(c, patch.centroid));
    patch.polygon = convex_polygon(points);
  }
  return all;
}

// Mean over a triangle, exact to the fifth degree (Radon 1948).
template <typename Function>
double seven_points(const Corners& t, const Function& f) {
  static const double root = std::sqrt(15.0);
  static const std::array<std::array<double, 2>, 2> rules = {
      {{(6.0 - root) / 21.0, (155.0 - root) / 1200.0}, {(6.0 + root) / 21.0, (155.0 + root) / 1200.0}}};
  double sum = 0.225 * f((t[0] + t[1] + t[2]) / 3.0);
  for (const auto& [a, weight] : rules)
    for (std::size_t k = 0; k < 3; ++k)
      sum += weight * f((1.0 - 2.0 * a) * t[k] + a * (t[(k + 1) % 3] + t[(k + 2) % 3]));
  return sum;
}

// Mean over a triangle, cut in four until the parts agree with the whole. tolerance: of this triangle's share
// of the whole mean.
template <typename Function>
double adaptive_mean(const Corners& t, double whole, double fraction, double tolerance, int depth,
                     const Function& f) {
  const std::array<Vec3d, 3> m = {(t[1] + t[2]) / 2.0, (t[2] + t[0]) / 2.0, (t[0] + t[1]) / 2.0};
  const std::array<Corners, 4> parts = {{{t[0], m[2], m[1]}, {m[2], t[1], m[0]}, {m[1], m[0], t[2]}, m}};
  std::array<double, 4> means{};
  for (std::size_t k = 0; k < 4; ++k) means[k] = seven_points(parts[k], f);
  auto mean = (means[0] + means[1] + means[2] + means[3]) / 4.0;
  if (depth == 0 || std::abs(mean - whole) * fraction <= tolerance) return mean;
  mean = 0.0;
  for (std::size_t k = 0; k < 4; ++k)
    mean += adaptive_mean(parts[k], means[k], fraction / 4.0, tolerance, depth - 1, f) / 4.0;
  return mean;
}

// Whether any corner of the patch rises above this side of the other.
bool rises_above(const Patch& patch, const Patch& horizon, double sign) {
  return std::any_of(patch.corners.begin(), patch.corners.end(), [&](const Vec3d& c) {
    return sign * glm::dot(horizon.normal, c - horizon.centroid) > 1e-6;
  });
}

// The screens that may stand between two patches; others have both patches on one side.
std::vector<ConvexPolygon> between(const Patch& a, const Patch& b,
                                   const std::vector<ConvexPolygon>& screens) {
  std::vector<ConvexPolygon> some;
  for (const auto& screen : screens) {
    const auto normal =
        glm::normalize(glm::cross(screen.corner[1] - screen.corner[0], screen.corner[2] - screen.corner[0]));
    double low = 1e300, high = -1e300;
    for (const auto* patch : {&a, &b})
      for (const auto& c : patch->corners) {
        low = std::min(low, glm::dot(normal, c - screen.corner[0]));
        high = std::max(high, glm::dot(normal, c - screen.corner[0]));
      }
    if (low < -1e-6 && high > 1e-6) some.push_back(screen);
  }
  return some;
}

// Mean over the receiver's side of the point factor to the sender's side.
double pair_factor(const Patch& receiver, double receiver_sign, const Patch& sender, double sender_sign,
                   const std::vector<ConvexPolygon>& screens) {
  const auto n = receiver_sign * receiver.normal;
  const auto f = [&](const Vec3d& x) {
    const bool faces = sender_sign * glm::dot(sender.normal, x - sender.centroid) > 0.0;
    return faces ? point_factor(x, n, sender.polygon, screens) : 0.0;
  };
  const auto whole = seven_points(receiver.corners, f);
  const auto distance = glm::distance(receiver.centroid, sender.centroid);
  if (screens.empty() && distance > 4.0 * (receiver.radius + sender.radius)) return whole;
  return screens.empty() ? adaptive_mean(receiver.corners, whole, 1.0, 1e-8, 12, f)
                         : adaptive_mean(receiver.corners, whole, 1.0, 1e-6, 5, f);
}

}  // namespace

std::vector<double> form_factors(const PatchSet& patches, const std::vector<ConvexPolygon>& screens,
                                 const Context& context) {
  const auto all = in_double(patches);
  const auto sides = 2 * all.size();
  std::vector<double> factors(sides * sides, 0.0);
  context.for_chunks(all.size(), 1, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t side = 0; side < 4; ++side) {
          const auto a = side % 2;
          const auto b = side / 2;
          const auto sign = [](std::size_t back) { return back == 0 ? 1.0 : -1.0; };
          if (!rises_above(all[j], all[i], sign(a)) || !rises_above(all[i], all[j], sign(b))) continue;
          const auto factor = pair_factor(all[i], sign(a), all[j], sign(b), between(all[i], all[j], screens));
          factors[(2 * i + a) * sides + 2 * j + b] = factor;
          factors[(2 * j + b) * sides + 2 * i + a] = factor * all[i].area / all[j].area;
        }
  });
  return factors;
}

TrueLight true_light(const PatchSet& patches, const std::vector<double>& form_factors) {
  const auto sides = side_count(patches.size());
  const auto bands = patches.band_count();
  TrueLight light;
  light.irradiance.front.assign(patches.size() * bands, 0.0);
  light.irradiance.back.assign(patches.size() * bands, 0.0);
  for (std::size_t band = 0; band < bands; ++band) {
    std::vector<double> radiosity(sides, 0.0);
    for (double change = 1.0, largest = 0.0; change > 1e-13 * largest;) {
      change = 0.0;
      for (std::size_t s = 0; s < sides; ++s) {
        const auto p = s / 2;
        const bool back = s % 2 == 1;
        const auto& material = patches.material_of(p);
        if (back && !material.two_sided) continue;
        double H = 0.0;
        for (std::size_t t = 0; t < sides; ++t) H += form_factors[s * sides + t] * radiosity[t];
        auto B = (back ? 0.0 : material.emittance[band]) + material.reflectance[band] * H;
        if (material.is_diffuser())
          B += material.diffuse_transmittance[band] * light.irradiance.of(!back)[p * bands + band];
        change = std::max(change, std::abs(B - radiosity[s]));
        largest = std::max(largest, B);
        radiosity[s] = B;
        light.irradiance.of(back)[p * bands + band] = H;
      }
    }
  }
  return light;
}

}  // namespace luxel::truth
