// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/seating.h"

#include <cmath>

#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

constexpr auto arm_width = 0.19;
constexpr auto depth = 0.90;
constexpr auto leg_height = 0.13;
constexpr auto gap = 0.004;  // between cushions, and between cushion and body

Mesh body(double width, Paint cloth) {
  const auto inner = width - 2.0 * arm_width;
  const auto arm = rounded_box({arm_width, 0.48, depth - 0.02}, 0.07);
  const auto back = turned_x(rounded_box({inner - gap, 0.54, 0.18}, 0.07), -7.0);
  return painted(joined({
                     placed(rounded_box({inner - gap, 0.16, depth - 0.06}, 0.03), {0.0, leg_height, 0.0}),
                     placed(arm, {-0.5 * (width - arm_width), leg_height, 0.0}),
                     placed(arm, {0.5 * (width - arm_width), leg_height, 0.0}),
                     placed(back, {0.0, leg_height + 0.18, -0.5 * depth + 0.12}),
                 }),
                 cloth);
}

Mesh legs(double width) {
  auto mesh = Mesh{};
  for (const auto x : {-1.0, 1.0}) {
    for (const auto z : {-1.0, 1.0}) {
      const auto head = Vec3d(x * (0.5 * width - 0.10), leg_height - 0.001, z * (0.5 * depth - 0.10));
      const auto foot = Vec3d(head.x + 0.03 * x, 0.0, head.z + 0.03 * z);
      append(mesh, leg(foot, head, 0.013, 0.022));
    }
  }
  return painted(std::move(mesh), Paint::walnut);
}

}  // namespace

Mesh sofa(const Upholstery& upholstery) {
  auto mesh = joined({body(upholstery.width, upholstery.cloth), legs(upholstery.width)});
  const auto seat_width = (upholstery.width - 2.0 * arm_width) / upholstery.seats;
  const auto seat = painted(cushion({seat_width - 2.0 * gap, 0.13, 0.64}, 0.045, 0.025), upholstery.cloth);
  const auto back = painted(turned_x(pillow(seat_width - 2.0 * gap, 0.46, 0.19), -12.0), upholstery.cloth);
  for (auto k = 0; k < upholstery.seats; ++k) {
    const auto x = seat_width * (k - 0.5 * (upholstery.seats - 1));
    append(mesh, placed(seat, {x, leg_height + 0.16 + gap, 0.10}));
    append(mesh, placed(back, {x, 0.70, -0.10}));
  }
  return mesh;
}

Mesh throw_pillow(Paint cloth, double side, double lean_degrees) {
  const auto upright = moved(pillow(side, side, 0.38 * side), {0.0, 0.5 * side, 0.0});
  return painted(turned_x(upright, -lean_degrees), cloth);
}

Mesh pouf(Paint cloth) {
  const auto profile =
      smooth({{0.10, 0.0}, {0.20, 0.012}, {0.265, 0.10}, {0.27, 0.20}, {0.21, 0.31}, {0.10, 0.345}}, 2);
  auto closed = Profile{{0.0, 0.0}};
  closed.insert(closed.end(), profile.begin(), profile.end());
  closed.emplace_back(0.0, 0.34);
  // Nine gores, drawn in where they are welded together.
  return painted(deformed(lathe(closed, 36),
                          [](const Vec3d& p) {
                            const auto seam = std::cos(9.0 * std::atan2(p.z, p.x));
                            const auto in = 1.0 - 0.018 * seam;
                            return Vec3d(p.x * in, p.y, p.z * in);
                          }),
                 cloth);
}

}  // namespace luxel::scenes
