// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/lamps.h"

#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

// A cone of cloth, open above and below.
Mesh cloth_shade(double low_radius, double high_radius, double height) {
  auto profile = Profile{};
  constexpr auto rows = 4;
  for (auto k = 0; k <= rows; ++k) {
    const auto t = static_cast<double>(k) / rows;
    profile.emplace_back(low_radius + t * (high_radius - low_radius), t * height);
  }
  return lathe(profile, 40);
}

Mesh round_foot(double radius, double height) {
  return lathe({{0.0, 0.0}, {radius, 0.0}, {radius, 0.6 * height}, {0.92 * radius, height}, {0.0, height}},
               36);
}

// A dome of spun metal, closed: black outside, white inside. Its rim is at y = 0.
Mesh dome(double radius, double height) {
  auto profile = Profile{};
  constexpr double shape[][2] = {{0.0, 0.97},  {0.17, 0.94}, {0.40, 0.82},
                                 {0.64, 0.63}, {0.84, 0.36}, {0.965, 0.0}};
  for (const auto& [r, y] : shape) profile.emplace_back(r * radius, y * height);
  profile.emplace_back(radius, 0.0);
  for (auto k = 4; k >= 1; --k) {
    profile.emplace_back((shape[k][0] + 0.035) * radius, (shape[k][1] + 0.03) * height);
  }
  profile.emplace_back(0.0, height);
  const auto spun = painted(lathe(profile, 32), Paint::black_steel);
  return painted(spun, Paint::porcelain, [](const Vec3d& p, const Vec3d& normal) {
    return normal.x * p.x + normal.z * p.z < 0.0 || normal.y < -0.9;
  });
}

}  // namespace

Lamp floor_lamp() {
  auto post = curve({0.0, 0.027, 0.0}, {0.0, 0.9, -0.02}, {0.0, 1.75, -0.04}, {0.0, 1.66, 0.22}, 14);
  const auto head = Vec3d(0.0, 1.28, 0.26);
  post.push_back({head.x, 1.60, head.z});
  post.push_back({head.x, head.y + 0.19, head.z});
  return {.stand = joined({painted(round_foot(0.15, 0.025), Paint::black_steel),
                           painted(tube(post, 0.011, 10), Paint::brass)}),
          .bulb = painted(moved(sphere(0.045, 16), head + Vec3d(0.0, 0.13, 0.0)), Paint::lamp_floor_bulb),
          .shade = painted(moved(cloth_shade(0.235, 0.17, 0.28), head), Paint::lamp_floor_shade)};
}

Lamp table_lamp() {
  const auto outline =
      smooth({{0.060, 0.0}, {0.085, 0.04}, {0.10, 0.10}, {0.07, 0.18}, {0.028, 0.235}, {0.020, 0.25}}, 3);
  auto base = Profile{{0.0, 0.0}};
  base.insert(base.end(), outline.begin(), outline.end());
  base.emplace_back(0.0, 0.25);
  return {
      .stand = joined({painted(lathe(base, 24), Paint::glaze_cobalt),
                       painted(moved(cylinder(0.010, 0.068, 16), {0.0, 0.251, 0.0}), Paint::brass)}),
      .bulb = painted(moved(sphere(0.035, 16), {0.0, 0.357, 0.0}), Paint::lamp_table_bulb),
      .shade = painted(moved(cloth_shade(0.165, 0.115, 0.22), {0.0, 0.265, 0.0}), Paint::lamp_table_shade)};
}

Lamp pendant_lamp() {
  constexpr auto rim = -1.25;
  const auto wire = tube({{0.0, rim + 0.222, 0.0}, {0.0, -0.032, 0.0}}, 0.004, 10);
  const auto rose = moved(cylinder(0.05, 0.03), {0.0, -0.031, 0.0});
  return {.stand = joined({moved(dome(0.24, 0.22), {0.0, rim, 0.0}), painted(wire, Paint::black_steel),
                           painted(rose, Paint::brass)}),
          .bulb = painted(moved(sphere(0.05, 16), {0.0, rim + 0.065, 0.0}), Paint::lamp_pendant),
          .shade = {}};
}

Lamp globe_lamp() {
  const auto wire = tube({{0.0, -0.199, 0.0}, {0.0, -0.032, 0.0}}, 0.008, 12);
  const auto rose = moved(cylinder(0.06, 0.03), {0.0, -0.031, 0.0});
  return {.stand = painted(joined({wire, rose}), Paint::brass),
          .bulb = painted(moved(sphere(0.125, 20), {0.0, -0.325, 0.0}), Paint::lamp_corridor),
          .shade = {}};
}

}  // namespace luxel::scenes
