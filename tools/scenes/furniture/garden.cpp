// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/garden.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

constexpr auto golden_angle = 137.50776;  // degrees

Vec3d crown_middle(double height) { return {0.0, 0.66 * height, 0.0}; }
double crown_radius(double height) { return 0.33 * height; }

// Boughs leave the trunk in a spiral and end inside the crown.
std::vector<Vec3d> bough(double height, std::uint64_t which, int k) {
  const auto turn = glm::radians(golden_angle * k + 360.0 * dice(90, which));
  const auto out = Vec3d(std::cos(turn), 0.0, std::sin(turn));
  const auto foot = Vec3d(0.0, height * (0.36 + 0.03 * k), 0.0);
  const auto reach = crown_radius(height) * dice_between(0.55, 0.85, 91, which, k);
  const auto head = Vec3d(0.0, height * dice_between(0.60, 0.86, 92, which, k), 0.0) + reach * out;
  return curve(foot + 0.04 * out, foot + 0.35 * reach * out + Vec3d(0.0, 0.06 * height, 0.0),
               head - Vec3d(0.0, 0.10 * height, 0.0) - 0.2 * reach * out, head, 6);
}

// Uneven, as a clipped plant is.
Deformation ruffled(double by, std::uint64_t which) {
  const auto phase = 6.0 * dice(93, which);
  return [=](const Vec3d& p) {
    const auto wave =
        std::sin(9.0 * p.x + phase) * std::sin(8.0 * p.z + 2.0 * phase) * std::sin(7.0 * p.y + 0.5 * phase);
    return p * Vec3d(1.0, 1.0, 1.0) +
           by * wave * Vec3d(std::sin(5.0 * p.y + p.z), 0.5, std::cos(5.0 * p.y + p.x));
  };
}

}  // namespace

Mesh tree_wood(double height, std::uint64_t which) {
  const auto r = 0.022 * height;
  auto path = std::vector<Vec3d>{{0.0, 0.0, 0.0}};
  auto radii = std::vector<double>{1.7 * r};
  for (auto k = 1; k <= 8; ++k) {
    const auto t = k / 8.0;
    path.emplace_back(0.02 * height * std::sin(4.0 * t + 6.0 * dice(94, which)) * t, 0.80 * height * t,
                      0.02 * height * std::cos(3.0 * t) * t);
    radii.push_back(r * (1.15 - 0.95 * t));
  }
  auto mesh = tube(path, radii, 10);
  for (auto k = 0; k < 9; ++k) {
    const auto way = bough(height, which, k);
    auto thin = std::vector<double>{};
    for (std::size_t i = 0; i < way.size(); ++i) thin.push_back(r * (0.45 - 0.055 * static_cast<double>(i)));
    append(mesh, tube(way, thin, 7));
  }
  return painted(mesh, Paint::bark);
}

Mesh tree_leaves(double height, std::uint64_t which, int count) {
  auto mesh = Mesh{};
  const auto middle = crown_middle(height);
  const auto radius = crown_radius(height);
  const auto size = 2.6 * radius / std::sqrt(static_cast<double>(count));
  for (auto k = 0; k < count; ++k) {
    const auto of = static_cast<std::uint64_t>(k);
    const auto y = 2.0 * dice(95, which, of) - 1.0;
    const auto turn = 2.0 * std::numbers::pi * dice(96, which, of);
    const auto ring = std::sqrt(1.0 - y * y);
    const auto direction = Vec3d(ring * std::cos(turn), y, ring * std::sin(turn));
    // Lumps: the crown is wider towards the boughs' ends.
    const auto lump = 1.0 + 0.14 * std::sin(4.0 * turn + 6.0 * dice(97, which)) * std::cos(3.0 * y);
    const auto depth = 1.0 - 0.45 * dice(98, which, of) * dice(99, which, of);
    const auto at = middle + radius * lump * depth * direction * Vec3d(1.0, 0.95, 1.0);
    const auto leaf = sheet(2, 2, [&](double s, double t) {
      const auto u = 2.0 * s - 1.0;
      const auto v = 2.0 * t - 1.0;
      return size * Vec3d(u * (1.0 - 0.35 * v * v), 0.22 * (u * u + v * v), -v);
    });
    const auto tilt = dice_between(-55.0, 55.0, 100, which, of);
    const auto paint = dice(101, which, of) < 0.55 ? Paint::foliage_1 : Paint::foliage_2;
    append(mesh, painted(placed(turned_z(turned_x(leaf, tilt), dice_between(-50.0, 50.0, 102, which, of)), at,
                                360.0 * dice(103, which, of)),
                         paint));
  }
  return mesh;
}

Mesh hedge(double length, double width, double height, std::uint64_t which) {
  const auto cells = glm::ivec3(static_cast<int>(length / 0.12), static_cast<int>(height / 0.12),
                                static_cast<int>(width / 0.12));
  return painted(deformed(rounded_box({length, height, width}, 0.06, cells), ruffled(0.022, which)),
                 Paint::hedge);
}

Mesh garden_bench() {
  auto mesh = Mesh{};
  for (auto k = 0; k < 4; ++k) {
    append(mesh, painted(placed(rounded_box({1.60, 0.030, 0.095}, 0.010), {0.0, 0.425, -0.15 + 0.105 * k}),
                         Paint::oak));
  }
  for (auto k = 0; k < 3; ++k) {
    append(mesh, painted(placed(turned_x(rounded_box({1.60, 0.095, 0.028}, 0.010), -14.0),
                                {0.0, 0.50 + 0.125 * k, -0.235 - 0.031 * k}),
                         Paint::oak));
  }
  for (const auto x : {-0.66, 0.66}) {
    append(mesh,
           painted(placed(rounded_box({0.05, 0.423, 0.05}, 0.012), {x, 0.0, 0.15}), Paint::black_steel));
    append(mesh,
           painted(placed(rounded_box({0.05, 0.423, 0.05}, 0.012), {x, 0.0, -0.16}), Paint::black_steel));
    append(mesh, painted(tube({{x, 0.424, -0.216}, {x, 0.84, -0.325}}, 0.016, 8), Paint::black_steel));
  }
  return mesh;
}

Mesh fountain() {
  const auto basin = lathe({{0.0, 0.0},
                            {1.30, 0.0},
                            {1.30, 0.06},
                            {1.22, 0.09},
                            {1.20, 0.38},
                            {1.28, 0.42},
                            {1.28, 0.50},
                            {1.26, 0.52},
                            {1.08, 0.52},
                            {1.06, 0.50},
                            {1.06, 0.42},
                            {0.80, 0.42},
                            {0.50, 0.42},
                            {0.0, 0.42}},
                           48);
  auto shaft = Profile{{0.0, 0.421}};
  for (const auto& p :
       smooth({{0.30, 0.421}, {0.26, 0.47}, {0.12, 0.60}, {0.10, 0.80}, {0.16, 0.98}, {0.12, 1.10}}, 3))
    shaft.push_back(p);
  shaft.emplace_back(0.0, 1.10);
  auto bowl = Profile{{0.0, 1.101}};
  for (const auto& p : smooth({{0.10, 1.101}, {0.35, 1.14}, {0.56, 1.26}, {0.60, 1.33}}, 3))
    bowl.push_back(p);
  bowl.insert(bowl.end(), {{0.555, 1.33}, {0.53, 1.29}, {0.25, 1.29}, {0.0, 1.29}});
  auto knob = Profile{{0.0, 1.291}};
  for (const auto& p :
       smooth({{0.09, 1.291}, {0.06, 1.38}, {0.10, 1.50}, {0.11, 1.58}, {0.06, 1.68}, {0.015, 1.72}}, 3))
    knob.push_back(p);
  knob.emplace_back(0.0, 1.72);
  const auto is_water = [](double level) {
    return [=](const Vec3d& p, const Vec3d& n) { return n.y > 0.99 && std::abs(p.y - level) < 0.001; };
  };
  return joined(
      {painted(painted(basin, Paint::stone_pale), Paint::water,
               [](const Vec3d& p, const Vec3d& n) { return n.y > 0.99 && std::abs(p.y - 0.42) < 0.001; }),
       painted(lathe(shaft, 28), Paint::stone_pale),
       painted(painted(lathe(bowl, 36), Paint::stone_pale), Paint::water, is_water(1.29)),
       painted(lathe(knob, 24), Paint::stone_pale)});
}

Mesh street_lamp() {
  auto post = Profile{{0.0, 0.0}};
  for (const auto& p :
       smooth({{0.13, 0.0}, {0.13, 0.22}, {0.075, 0.34}, {0.055, 0.9}, {0.042, 2.4}, {0.036, 3.55}}, 3))
    post.push_back(p);
  post.emplace_back(0.0, 3.55);
  const auto cage = lathe({{0.0, 3.551}, {0.10, 3.551}, {0.115, 3.58}, {0.19, 4.00}, {0.0, 4.00}}, 6);
  const auto hat = lathe(
      {{0.0, 4.001}, {0.23, 4.001}, {0.235, 4.02}, {0.10, 4.16}, {0.03, 4.20}, {0.025, 4.27}, {0.0, 4.29}},
      6);
  return joined({painted(lathe(post, 14), Paint::black_steel), painted(cage, Paint::porcelain),
                 painted(hat, Paint::black_steel)});
}

Mesh planter(double width) {
  const auto tub = deformed(rounded_box({width, 0.48, width}, 0.02), [](const Vec3d& p) {
    const auto grow = 0.90 + 0.20 * p.y;
    return Vec3d(p.x * grow, p.y, p.z * grow);
  });
  return joined({painted(tub, Paint::stone_warm),
                 painted(moved(rounded_box({0.88 * width, 0.03, 0.88 * width}, 0.012), {0.0, 0.481, 0.0}),
                         Paint::soil)});
}

Mesh box_ball(double radius, std::uint64_t which) {
  return painted(moved(deformed(sphere(radius, 26), ruffled(0.016, which)), {0.0, 0.95 * radius, 0.0}),
                 Paint::hedge);
}

}  // namespace luxel::scenes
