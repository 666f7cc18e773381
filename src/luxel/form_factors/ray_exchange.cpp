// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/ray_exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "luxel/core/address.h"
#include "luxel/core/spherical_triangle.h"
#include "luxel/form_factors/clip_polygon.h"
#include "luxel/form_factors/polygon_form_factor.h"

namespace luxel {
namespace {

constexpr std::uint32_t batch = 1024;  // rays between two tests of the error
constexpr float short_of_end =
    1e-5f;  // fraction by which a ray is shortened, so that it does not hit its target

struct Moments {
  double sum = 0.0, squares = 0.0;

  void add(double x) {
    sum += x;
    squares += x * x;
  }
  double mean(double n) const { return sum / n; }
  double error_of_mean(double n) const {
    return std::sqrt(std::max(0.0, squares / n - mean(n) * mean(n)) / (n - 1.0));
  }
};

// The triangles of a polygon as seen from a point; one is chosen in proportion to solid angle.
class Target {
 public:
  Target(std::span<const Vec3d> polygon, const Vec3d& eye) {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      triangles_.emplace_back(std::array{polygon[0] - eye, polygon[k] - eye, polygon[k + 1] - eye});
      solid_angle_ += triangles_.back().solid_angle();
    }
  }
  double solid_angle() const { return solid_angle_; }
  Vec3d direction(double u1, double u2) const {
    auto left = u1 * solid_angle_;
    for (const auto& triangle : triangles_) {
      const auto omega = triangle.solid_angle();
      if (left < omega || &triangle == &triangles_.back())
        return triangle.direction(std::min(1.0, left / omega), u2);
      left -= omega;
    }
    return Vec3d(0.0);
  }

 private:
  std::vector<SphericalTriangle> triangles_;
  double solid_angle_ = 0.0;
};

}  // namespace

Estimate ray_exchange(const Tracer& tracer, const PatchEmitter& from, double area,
                      std::span<const Vec3d> polygon, double open, const RayExchangeOptions& options) {
  const Vec3d n(from.normal());
  const auto facing = polygon_area_vector(polygon);
  const auto lift = static_cast<double>(origin_lift(from.corners()));
  Moments seen, hidden;
  std::vector<Vec3d> risen;
  std::uint32_t rays = 0;
  Estimate result;
  do {
    for (const auto end = rays + batch; rays < end; ++rays) {
      const auto u = uniform4(options.key, rays);
      const auto origin = from.point(u[0], u[1]);
      const Vec3d eye(origin);
      double given = 0.0;
      bool is_seen = false;
      clip_polygon(polygon, {eye, n}, risen);
      if (risen.size() > 2 && glm::dot(facing, eye - polygon[0]) > 0.0) {
        const Target target(risen, eye);
        const auto direction = target.direction(static_cast<double>(u[2]), static_cast<double>(u[3]));
        given = std::max(0.0, glm::dot(direction, n)) * target.solid_angle() / std::numbers::pi;
        const auto distance = glm::dot(facing, polygon[0] - eye) / glm::dot(facing, direction) - lift;
        is_seen = !(distance > 0.0) || !tracer.occluded({origin, Vec3(direction)},
                                                        static_cast<float>(distance) * (1.0f - short_of_end));
      }
      seen.add(is_seen ? given : 0.0);
      hidden.add(is_seen ? 0.0 : given);
    }
    const auto count = static_cast<double>(rays);
    const bool by_seen = seen.error_of_mean(count) < hidden.error_of_mean(count);
    result.value = by_seen ? area * seen.mean(count) : open - area * hidden.mean(count);
    // Lower bound of the error: where all rays agree, the mean is uncertain by a few rays.
    const auto least = open * 3.0 / count;
    result.error =
        std::max(least, 3.0 * area * (by_seen ? seen.error_of_mean(count) : hidden.error_of_mean(count)));
  } while (result.error > options.tolerance && rays < options.most);
  result.value = std::clamp(result.value, 0.0, open);
  return result;
}

}  // namespace luxel
