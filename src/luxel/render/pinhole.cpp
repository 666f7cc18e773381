// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/pinhole.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/core/warp.h"

namespace luxel {
namespace {

constexpr int max_side = 32768;
constexpr float farthest_eye = 1e15f;  // m; Embree aborts on rays from beyond 1.8e18

std::string as_text(const Vec3& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

void check(const Camera& camera, int width, int height) {
  if (width < 1 || width > max_side || height < 1 || height > max_side)
    throw InputError(fmt::format("a picture's sides must be from 1 to {} pixels, but {} x {} was requested",
                                 max_side, width, height));
  if (!is_finite(camera.eye) || !is_finite(camera.target) || !is_finite(camera.up))
    throw InputError("a camera's eye, target and up must be finite numbers, but one of them is not");
  if (const auto eye = glm::abs(camera.eye); std::max({eye.x, eye.y, eye.z}) > farthest_eye)
    throw InputError(fmt::format("a camera's eye must lie within {:g} m of the origin, but it is at {}",
                                 farthest_eye, as_text(camera.eye)));
  if (!(camera.vertical_fov > 0.0f && camera.vertical_fov < 180.0f))
    throw InputError(
        fmt::format("a camera's vertical field of view must lie between 0 and 180 degrees, but it is {}",
                    camera.vertical_fov));
  if (camera.eye == camera.target)
    throw InputError(fmt::format("a camera must look away from its eye, but eye and target are both {}",
                                 as_text(camera.eye)));
}

constexpr std::uint64_t of_orders = ~std::uint64_t{0};  // number of the random numbers that all cells share

// The place of a number below `side` in an order of these numbers that u1 and u2 choose.
int place(int number, int side, float u1, float u2) {
  auto factor = 1 + static_cast<int>(u1 * static_cast<float>(side));
  while (std::gcd(factor, side) != 1) factor = factor % side + 1;
  return (factor * number + static_cast<int>(u2 * static_cast<float>(side))) % side;
}

// Sine and cosine of at most an eighth of a turn, in double: Taylor series to the 13th and 12th power, error
// below 1e-12.
void sin_cos_eighth(double x, double& sine, double& cosine) {
  const double s = x * x;
  sine = x *
         (1.0 - s / 6 * (1.0 - s / 20 * (1.0 - s / 42 * (1.0 - s / 72 * (1.0 - s / 110 * (1.0 - s / 156))))));
  cosine = 1.0 - s / 2 * (1.0 - s / 12 * (1.0 - s / 30 * (1.0 - s / 56 * (1.0 - s / 90 * (1.0 - s / 132)))));
}

}  // namespace

Pinhole::Pinhole(const Camera& camera, int width, int height) : eye_(camera.eye) {
  check(camera, width, height);
  const auto forward = glm::normalize(Vec3d(camera.target) - Vec3d(camera.eye));
  const auto side = glm::cross(forward, Vec3d(camera.up));
  // Sine of the angle between up and the view; a millionth is the rounding of float directions.
  if (!(glm::length(side) > 1e-6 * glm::length(Vec3d(camera.up))))
    throw InputError(fmt::format("a camera's up must not point along its view, but up is {} and the view {}",
                                 as_text(camera.up), as_text(Vec3(forward))));
  const auto right = glm::normalize(side);
  const auto down = glm::cross(forward, right);
  const auto pixel = 2.0 * tangent_of_degrees(0.5 * static_cast<double>(camera.vertical_fov)) / height;
  right_ = pixel * right;
  down_ = pixel * down;
  corner_ = forward - (0.5 * width) * right_ - (0.5 * height) * down_;
}

Ray Pinhole::ray(double x, double y) const {
  return {eye_, Vec3(glm::normalize(corner_ + x * right_ + y * down_))};
}

Ray Pinhole::ray_in_cell(double x, double y, std::uint64_t key, int cell, int side) const {
  const auto column = cell % side, row = cell / side;
  const auto jitter = uniform4(key, static_cast<std::uint64_t>(cell));
  const auto orders = uniform4(key, of_orders);
  const auto across = place(row, side, orders[0], orders[1]),
             down = place(column, side, orders[2], orders[3]);
  return ray(x + (column + (across + static_cast<double>(jitter[0])) / side) / side,
             y + (row + (down + static_cast<double>(jitter[1])) / side) / side);
}

double tangent_of_degrees(double degrees) {
  const auto steep = degrees > 45.0;  // tan(x) = 1 / tan(90 - x)
  double sine = 0.0;
  double cosine = 1.0;
  sin_cos_eighth((steep ? 90.0 - degrees : degrees) * (std::numbers::pi / 180.0), sine, cosine);
  return steep ? cosine / sine : sine / cosine;
}

Vec2 on_circle(float turn) {
  const auto quarters = std::floor(4.0f * turn + 0.5f);
  Vec2 p;
  sin_cos_octant((4.0f * turn - quarters) * (pi / 2.0f), p.y, p.x);
  for (auto i = static_cast<int>(quarters) & 3; i > 0; --i) p = {-p.y, p.x};
  return p;
}

}  // namespace luxel
