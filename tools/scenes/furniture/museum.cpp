// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/museum.h"

#include <array>
#include <cmath>
#include <numbers>

#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

struct Fields {
  std::array<Paint, 4> paints;
};
constexpr std::array<Fields, 6> palettes = {
    {{{Paint::rug_indigo, Paint::glaze_turquoise, Paint::paper, Paint::ochre_cloth}},
     {{Paint::book_red, Paint::coral_cloth, Paint::book_orange, Paint::rug_cream}},
     {{Paint::plum_cloth, Paint::book_black, Paint::curtain_rose, Paint::linen_cloth}},
     {{Paint::leaf_dark, Paint::sage_wall, Paint::book_yellow, Paint::paper}},
     {{Paint::glaze_cobalt, Paint::book_blue, Paint::porcelain, Paint::book_orange}},
     {{Paint::clay, Paint::rug_rust, Paint::canvas, Paint::book_black}}}};

Vec3d tilted(const Vec3d& p, double degrees) {
  const auto angle = glm::radians(degrees);
  return {p.x, std::cos(angle) * p.y + std::sin(angle) * p.z, -std::sin(angle) * p.y + std::cos(angle) * p.z};
}

}  // namespace

Mesh plinth(double width, double height) {
  return painted(joined({rounded_box({width - 0.04, 0.03, width - 0.04}, 0.004),
                         moved(rounded_box({width, height - 0.031, width}, 0.006), {0.0, 0.031, 0.0})}),
                 Paint::plaster_white);
}

Mesh knot_sculpture() {
  constexpr auto pieces = 96, around = 14;
  auto mesh = Mesh{};
  const auto at = [](double t) {
    return Vec3d(std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t),
                 -1.1 * std::sin(3.0 * t)) *
           0.125;
  };
  for (auto i = 0; i < pieces; ++i) {
    const auto t = 2.0 * std::numbers::pi * i / pieces;
    const auto tangent = glm::normalize(at(t + 0.01) - at(t - 0.01));
    const auto out = glm::normalize(at(t) - tangent * glm::dot(at(t), tangent));
    const auto side = glm::cross(tangent, out);
    for (auto j = 0; j < around; ++j) {
      const auto angle = 2.0 * std::numbers::pi * j / around;
      mesh.add_point(at(t) + 0.058 * (std::cos(angle) * out + std::sin(angle) * side));
    }
  }
  for (auto i = 0u; i < pieces; ++i) {
    for (auto j = 0u; j < around; ++j) {
      const auto next = (i + 1) % pieces;
      const auto k = (j + 1) % around;
      mesh.add_quad(i * around + j, i * around + k, next * around + k, next * around + j);
    }
  }
  const auto foot =
      lathe({{0.0, 0.0}, {0.14, 0.0}, {0.14, 0.02}, {0.03, 0.03}, {0.02, 0.10}, {0.0, 0.10}}, 24);
  return joined({painted(moved(mesh, {0.0, 0.48, 0.0}), Paint::bronze), painted(foot, Paint::stone_dark)});
}

Mesh stacked_sculpture() {
  auto mesh = Mesh{};
  auto y = 0.0;
  constexpr double sizes[] = {0.30, 0.24, 0.19, 0.155, 0.12, 0.09};
  for (auto k = 0; k < 6; ++k) {
    const auto flat = 0.60 + 0.06 * k;
    const auto pebble = deformed(sphere(sizes[k], 30), [&](const Vec3d& p) {
      return Vec3d(p.x * (1.0 + 0.12 * std::sin(k + 1.0)), flat * p.y,
                   p.z * (1.0 - 0.10 * std::cos(2.0 * k))) +
             Vec3d(0.02 * std::sin(2.3 * k), 0.0, 0.02 * std::cos(1.7 * k));
    });
    y += sizes[k] * flat;
    append(mesh,
           painted(placed(pebble, {0.0, y, 0.0}, 50.0 * k), k % 2 == 0 ? Paint::marble : Paint::stone_warm));
    y += sizes[k] * flat + 0.001;
  }
  return mesh;
}

Mesh figure_sculpture() {
  const auto outline = smooth({{0.15, 0.0},
                               {0.16, 0.06},
                               {0.10, 0.22},
                               {0.14, 0.45},
                               {0.09, 0.66},
                               {0.13, 0.84},
                               {0.06, 0.98},
                               {0.085, 1.08},
                               {0.05, 1.17}},
                              6);
  auto profile = Profile{{0.0, 0.0}};
  profile.insert(profile.end(), outline.begin(), outline.end());
  profile.emplace_back(0.0, 1.185);
  return painted(deformed(lathe(profile, 40),
                          [](const Vec3d& p) {
                            const auto angle = 2.2 * p.y;
                            const auto wide = 1.0 + 0.30 * std::sin(2.6 * p.y);
                            const auto x = p.x * wide;
                            const auto z = p.z * (0.62 + 0.20 * std::cos(3.0 * p.y));
                            return Vec3d(
                                std::cos(angle) * x - std::sin(angle) * z + 0.05 * std::sin(3.1 * p.y), p.y,
                                std::sin(angle) * x + std::cos(angle) * z);
                          }),
                 Paint::marble);
}

Mesh museum_bench() {
  auto mesh = painted(placed(cushion({1.80, 0.10, 0.52}, 0.03, 0.008), {0.0, 0.34, 0.0}), Paint::plum_cloth);
  append(mesh, painted(placed(rounded_box({1.70, 0.03, 0.44}, 0.008), {0.0, 0.308, 0.0}), Paint::walnut));
  for (const auto x : {-0.72, 0.72}) {
    append(mesh, painted(placed(rounded_box({0.05, 0.306, 0.40}, 0.010), {x, 0.0, 0.0}), Paint::black_steel));
  }
  return mesh;
}

Mesh painting_frame(double width, double height) {
  return painted(
      frame(width, height,
            {{0.0, 0.001}, {0.030, 0.001}, {0.030, 0.040}, {0.022, 0.046}, {0.008, 0.044}, {0.0, 0.036}}),
      Paint::black_steel);
}

Mesh painting_canvas(double width, double height, std::uint64_t which) {
  const auto w = width - 0.002;
  const auto h = height - 0.002;
  // The golden ratio cuts the canvas into fields, whose edges waver a little.
  auto x = std::vector<double>{0.0, dice_between(0.30, 0.42, 110, which),
                               dice_between(0.58, 0.72, 111, which), 1.0};
  auto y = std::vector<double>{0.0, dice_between(0.18, 0.30, 112, which),
                               dice_between(0.55, 0.70, 113, which), 1.0};
  const auto& paints = palettes[which % palettes.size()].paints;
  auto mesh = Mesh{};
  for (auto i = 0u; i < 3; ++i) {
    for (auto j = 0u; j < 3; ++j) {
      const auto low = Vec3d((x[i] - 0.5) * w, (y[j] - 0.5) * h, 0.022);
      const auto cell =
          panel(low, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, steps({0.0, (x[i + 1] - x[i]) * w}, 0.25),
                steps({0.0, (y[j + 1] - y[j]) * h}, 0.25));
      append(mesh, painted(cell, paints[static_cast<std::size_t>(4.0 * dice(114, which, 3 * i + j))]));
    }
  }
  return mesh;
}

Mesh washer_housing(double tilt_degrees) {
  const auto can =
      lathe({{0.0, 0.0}, {0.060, 0.0}, {0.060, 0.17}, {0.0545, 0.175}, {0.0545, 0.125}, {0.0, 0.125}}, 24);
  // The can's opening looks along -y before it is tilted.
  const auto down = deformed(turned_x(can, 180.0),
                             [&](const Vec3d& p) { return tilted(p + Vec3d(0.0, 0.02, 0.0), tilt_degrees); });
  return painted(joined({moved(down, {0.0, -0.16, 0.0}),
                         moved(rounded_box({0.03, 0.05, 0.06}, 0.006), {0.0, -0.052, 0.0}),
                         moved(cylinder(0.010, 0.085, 10), {0.0, -0.138, 0.0})}),
                 Paint::plastic_black);
}

Mesh washer_lamp(double tilt_degrees) {
  const auto lens = turned_x(disc(0.050, 0.0, 0.0, 360.0, 20), 90.0);  // looks along -y
  return painted(moved(deformed(moved(lens, {0.0, -0.108, 0.0}),
                                [&](const Vec3d& p) { return tilted(p, tilt_degrees); }),
                       {0.0, -0.16, 0.0}),
                 Paint::lamp_washer);
}

}  // namespace luxel::scenes
