// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/polygon_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "luxel/form_factors/clip_polygon.h"
#include "luxel/form_factors/edge_pair_integral.h"
#include "luxel/form_factors/gauss_rule.h"
#include "luxel/lamps/polygon_irradiance.h"

namespace luxel {
namespace {

using Polygon = std::vector<Vec3d>;

// Ratio of sizes above which the larger polygon is cut: the rounding of its edge integrals would exceed the
// smaller polygon's.
constexpr double max_unlike = 4.0;
constexpr int max_cuts = 60;

struct Sphere {
  Vec3d centre = Vec3d(0.0);
  double radius = 0.0;
};
Sphere sphere_round(std::span<const Vec3d> polygon) {
  Sphere sphere;
  for (const auto& p : polygon) sphere.centre += p / static_cast<double>(polygon.size());
  for (const auto& p : polygon) sphere.radius = std::max(sphere.radius, glm::distance(p, sphere.centre));
  return sphere;
}

// Distance from a point to the nearest point of a convex polygon.
double distance_to(std::span<const Vec3d> polygon, const Vec3d& x) {
  const auto n = glm::normalize(polygon_area_vector(polygon));
  auto nearest = 1e300;
  bool inside = true;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto& p = polygon[k];
    const auto e = polygon[(k + 1) % polygon.size()] - p;
    const auto length2 = glm::dot(e, e);
    const auto t = length2 > 0.0 ? std::clamp(glm::dot(x - p, e) / length2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, glm::distance(x, p + t * e));
    inside = inside && glm::dot(glm::cross(n, e), x - p) >= 0.0;
  }
  return inside ? std::fabs(glm::dot(n, x - polygon[0])) : nearest;
}

// Integral over the smaller polygon of the irradiance from the other, point by point.
double by_points(std::span<const Vec3d> small, std::span<const Vec3d> other,
                 std::span<const GaussNode> rule) {
  const auto n = glm::normalize(polygon_area_vector(small));
  double sum = 0.0;
  for (std::size_t k = 1; k + 1 < small.size(); ++k) {
    const auto u = small[k] - small[0], v = small[k + 1] - small[0];
    const auto area2 = glm::dot(n, glm::cross(u, v));
    sum += area2 * gauss_integral(rule, 0.0, 1.0, [&](double s) {
             return s * gauss_integral(rule, 0.0, 1.0, [&](double t) {
                      return unit_irradiance(other, small[0] + s * ((1.0 - t) * u + t * v), n);
                    });
           });
  }
  return sum / std::numbers::pi;
}

// In units of the larger radius, relative to the middle, so that the position in the scene costs no
// precision.
double by_edges(std::span<const Vec3d> a, std::span<const Vec3d> b, const Vec3d& middle, double unit) {
  double sum = 0.0;
  const auto edge = [&](std::span<const Vec3d> p, std::size_t k) {
    return Edge{(p[k] - middle) / unit, (p[(k + 1) % p.size()] - middle) / unit};
  };
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) sum += edge_pair_integral(edge(a, i), edge(b, j));
  return sum / (4.0 * std::numbers::pi) * unit * unit;
}

// The plane that halves the polygon across its longest edge.
Plane middle_across(std::span<const Vec3d> polygon) {
  Plane plane{};
  double longest = -1.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto e = polygon[(k + 1) % polygon.size()] - polygon[k];
    if (glm::dot(e, e) <= longest) continue;
    longest = glm::dot(e, e);
    plane.normal = e;
  }
  plane.point = sphere_round(polygon).centre;
  return plane;
}

// The exchange area of polygons that face each other.
double facing(const Polygon& a, const Polygon& b, int cuts_left) {
  if (a.size() < 3 || b.size() < 3) return 0.0;
  const auto round_a = sphere_round(a), round_b = sphere_round(b);
  const bool swap = round_b.radius < round_a.radius;
  const auto& small = swap ? b : a;
  const auto& great = swap ? a : b;
  const auto& inner = swap ? round_b : round_a;
  const auto& outer = swap ? round_a : round_b;
  if (!(inner.radius > 0.0)) return 0.0;
  const auto away = distance_to(great, inner.centre) / inner.radius;
  if (away >= 25.0) return by_points(small, great, gauss_4);
  if (away >= 5.0) return by_points(small, great, gauss_8);
  if (away >= 2.5) return by_points(small, great, gauss_12);
  if (outer.radius > max_unlike * inner.radius && cuts_left > 0) {
    auto plane = middle_across(great);
    Polygon half;
    clip_polygon(great, plane, half);
    auto sum = facing(small, half, cuts_left - 1);
    plane.normal = -plane.normal;
    clip_polygon(great, plane, half);
    return sum + facing(small, half, cuts_left - 1);
  }
  return by_edges(a, b, 0.5 * (inner.centre + outer.centre), outer.radius);
}

// The part of `polygon` in front of the plane of `other`. Corners that lie in the plane within the rounding
// of its normal, which is larger for a needle, are not moved: polygons that share an edge still share it.
void clip_to_front(std::span<const Vec3d> polygon, std::span<const Vec3d> other, const Vec3d& normal,
                   double area, Polygon& front) {
  const auto own = sphere_round(polygon), its = sphere_round(other);
  const Plane plane{its.centre, normal};
  const auto reach = own.radius + its.radius + glm::distance(own.centre, its.centre);
  const auto rounding = 4e-16 * reach * (1.0 + its.radius * its.radius / area);
  auto low = 1e300, high = -1e300;
  for (const auto& p : polygon) {
    low = std::min(low, plane.height(p));
    high = std::max(high, plane.height(p));
  }
  front.clear();
  if (high <= rounding) return;
  if (low >= -rounding)
    front.assign(polygon.begin(), polygon.end());
  else
    clip_polygon(polygon, plane, front);
}

}  // namespace

Vec3d polygon_area_vector(std::span<const Vec3d> polygon) {
  Vec3d sum(0.0);
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    sum += glm::cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return 0.5 * sum;
}

FacingParts facing_parts(std::span<const Vec3d> a, std::span<const Vec3d> b) {
  const auto front_a = polygon_area_vector(a), front_b = polygon_area_vector(b);
  const auto area_a = glm::length(front_a), area_b = glm::length(front_b);
  FacingParts parts;
  if (!(area_a > 0.0 && area_b > 0.0)) return parts;
  clip_to_front(a, b, front_b / area_b, area_b, parts.a);
  clip_to_front(b, a, front_a / area_a, area_a, parts.b);
  if (parts.a.size() < 3 || parts.b.size() < 3) parts = {};
  return parts;
}

double polygon_exchange_area(std::span<const Vec3d> a, std::span<const Vec3d> b) {
  const auto parts = facing_parts(a, b);
  const auto most = std::min(glm::length(polygon_area_vector(a)), glm::length(polygon_area_vector(b)));
  return std::clamp(facing(parts.a, parts.b, max_cuts), 0.0, most);
}

double polygon_form_factor(std::span<const Vec3d> a, std::span<const Vec3d> b) {
  const auto area = glm::length(polygon_area_vector(a));
  return area > 0.0 ? polygon_exchange_area(a, b) / area : 0.0;
}

}  // namespace luxel
