// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/school.h"

#include <cmath>

#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
Mesh school_desk() {
  auto mesh =
      painted(placed(rounded_box({1.30, 0.024, 0.55}, 0.008, {3, 0, 1}), {0.0, 0.696, 0.0}), Paint::birch);
  auto steel = Mesh{};
  for (const auto x : {-0.56, 0.56}) {
    append(steel, tube({{x, 0.02, 0.19}, {x, 0.694, 0.19}}, 0.016, 8));
    append(steel, tube({{x, 0.02, -0.19}, {x, 0.694, -0.19}}, 0.016, 8));
    append(steel, tube({{x, 0.12, -0.172}, {x, 0.12, 0.172}}, 0.012, 8));
    for (const auto z : {-0.19, 0.19}) append(steel, moved(cylinder(0.022, 0.019, 10), {x, 0.0, z}));
  }
  append(mesh, painted(steel, Paint::steel_grey));
  append(mesh, painted(placed(rounded_box({1.06, 0.014, 0.32}, 0.005), {0.0, 0.58, 0.02}), Paint::birch));
  append(mesh, painted(placed(box({1.06, 0.30, 0.012}), {0.0, 0.38, -0.215}), Paint::birch));
  return mesh;
}

Mesh school_chair(Paint seat) {
  auto steel = Mesh{};
  for (const auto x : {-0.175, 0.175}) {
    append(steel, tube({{1.10 * x, 0.0, 0.20}, {x, 0.418, 0.165}}, 0.011, 8));
    append(steel,
           tube(curve({1.10 * x, 0.0, -0.24}, {x, 0.35, -0.14}, {x, 0.50, -0.165}, {x, 0.76, -0.235}, 8),
                0.011, 8));
  }
  const auto board = deformed(rounded_box({0.40, 0.018, 0.39}, 0.009, {4, 0, 4}), [](const Vec3d& p) {
    return Vec3d(p.x,
                 p.y - 0.012 * (1.0 - 25.0 * p.x * p.x) - 0.6 * (p.z > 0.1 ? (p.z - 0.1) * (p.z - 0.1) : 0.0),
                 p.z);
  });
  const auto back = deformed(rounded_box({0.40, 0.19, 0.016}, 0.008, {4, 1, 0}),
                             [](const Vec3d& p) { return Vec3d(p.x, p.y, p.z + 0.9 * p.x * p.x); });
  return joined({painted(steel, Paint::steel_grey), painted(placed(board, {0.0, 0.432, 0.02}), seat),
                 painted(placed(turned_x(back, -14.0), {0.0, 0.60, -0.225}), seat)});
}

Mesh blackboard(double width, double height) {
  const auto board = painted(placed(cut_box(steps({-0.5 * width, 0.5 * width}, 0.6), height, {0.006, 0.026}),
                                    {0.0, -0.5 * height, 0.0}),
                             Paint::chalkboard);
  const auto edge = painted(frame(width + 0.002, height + 0.002,
                                  {{0.0, 0.001}, {0.05, 0.001}, {0.05, 0.030}, {0.042, 0.038}, {0.0, 0.034}}),
                            Paint::oak);
  const auto ledge = painted(
      placed(rounded_box({width, 0.024, 0.09}, 0.008), {0.0, -0.5 * height - 0.076, 0.047}), Paint::oak);
  auto mesh = joined({board, edge, ledge});
  for (auto k = 0; k < 5; ++k) {
    append(mesh, painted(placed(turned_z(cylinder(0.006, 0.08, 8), 90.0),
                                {-0.3 + 0.13 * k, -0.5 * height - 0.0455, 0.05}, 9.0 * k),
                         k % 3 == 2 ? Paint::book_yellow : Paint::plaster_white));
  }
  append(mesh,
         painted(placed(rounded_box({0.14, 0.035, 0.05}, 0.008), {0.55, -0.5 * height - 0.051, 0.05}, 8.0),
                 Paint::oak));
  return mesh;
}

Mesh globe_on_stand() {
  const auto foot =
      lathe({{0.0, 0.0}, {0.11, 0.0}, {0.11, 0.012}, {0.02, 0.03}, {0.014, 0.075}, {0.0, 0.075}}, 24);
  auto arm = std::vector<Vec3d>{};
  for (auto k = 0; k <= 14; ++k) {
    const auto angle = glm::radians(-90.0 - 13.0 * k);
    arm.emplace_back(-0.182 * std::cos(angle), 0.265 + 0.182 * std::sin(angle), 0.0);
  }
  const auto ball = painted(moved(sphere(0.165, 28), {0.0, 0.265, 0.0}), Paint::plaster_blue);
  // Continents, as an impression: some of the facets.
  const auto earth = painted(ball, Paint::plaster_ochre, [](const Vec3d& p, const Vec3d& n) {
    return std::sin(5.0 * n.x + 1.3) * std::cos(4.0 * n.z - 0.4 + 2.0 * n.y) > 0.25 && std::abs(n.y) < 0.85 &&
           p.y > 0.0;
  });
  return joined({painted(foot, Paint::walnut), painted(tube(arm, 0.006, 8), Paint::brass), earth});
}

Mesh exercise_book(Paint cover) { return painted(rounded_box({0.16, 0.008, 0.21}, 0.002), cover); }

Mesh wall_clock() {
  const auto rim = turned_x(
      lathe({{0.0, 0.0}, {0.18, 0.0}, {0.18, 0.03}, {0.168, 0.04}, {0.156, 0.032}, {0.0, 0.032}}, 36), 90.0);
  auto mesh = painted(painted(moved(rim, {0.0, 0.0, 0.001}), Paint::steel_grey), Paint::plastic_white,
                      [](const Vec3d& p, const Vec3d& n) {
                        return n.z > 0.99 && p.z > 0.02 && glm::length(glm::dvec2(p)) < 0.157;
                      });
  for (auto k = 0; k < 12; ++k) {
    append(mesh,
           painted(turned_z(placed(box({k % 3 == 0 ? 0.012 : 0.006, 0.022, 0.002}), {0.0, 0.122, 0.0352}),
                            30.0 * k),
                   Paint::plastic_black));
  }
  append(mesh, painted(turned_z(placed(box({0.010, 0.085, 0.002}), {0.0, -0.012, 0.0352}), 62.0),
                       Paint::plastic_black));
  return joined({mesh, painted(turned_z(placed(box({0.007, 0.120, 0.002}), {0.0, -0.015, 0.0382}), -48.0),
                               Paint::plastic_black)});
}

Mesh radiator(double length) {
  auto mesh = Mesh{};
  const auto fins = static_cast<int>(length / 0.06);
  for (auto k = 0; k < fins; ++k) {
    append(mesh,
           placed(rounded_box({0.050, 0.56, 0.10}, 0.018), {-0.5 * length + 0.06 * (k + 0.5), 0.0, 0.0}));
  }
  append(mesh,
         placed(turned_z(moved(cylinder(0.02, length + 0.08, 10), {0.0, -0.5 * (length + 0.08), 0.0}), 90.0),
                {0.0, 0.05, 0.0 - 0.075}));
  return painted(mesh, Paint::painted_wood);
}

}  // namespace luxel::scenes
