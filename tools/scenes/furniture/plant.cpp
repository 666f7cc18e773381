// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/plant.h"

#include <cmath>

#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

constexpr auto stem_count = 4;
constexpr auto leaves_per_stem = 10;
constexpr auto golden_angle = 137.50776;  // degrees; leaves that grow so shade each other least

// A leaf that grows from the origin along +z, folded along its rib and drooping towards its tip.
Mesh leaf(double length, int columns, int rows) {
  const auto width = 0.42 * length;
  constexpr auto droop = 0.28;
  return sheet(columns, rows, [&](double s, double t) {
    const auto u = 2.0 * s - 1.0;
    const auto along = 0.02 + 0.98 * t;
    const auto outline = 2.0 * std::sqrt(along) * (1.0 - along * along) + 0.012;
    const auto x = 0.5 * width * u * outline;
    const auto y = 0.25 * std::abs(x) - droop * length * along * along;
    return Vec3d(-x, y, length * along);
  });
}

std::vector<Vec3d> stem(int which, int pieces) {
  const auto angle = 90.0 * which + dice_between(-25.0, 25.0, 21, which);
  const auto lean = dice_between(0.14, 0.30, 22, which);
  const auto height = dice_between(0.95, 1.35, 23, which);
  const auto x = std::cos(glm::radians(angle));
  const auto z = std::sin(glm::radians(angle));
  const auto foot = Vec3d(0.05 * x, 0.301, 0.05 * z);
  const auto head = Vec3d(lean * x, 0.30 + height, lean * z);
  return curve(foot, foot + Vec3d(0.0, 0.4 * height, 0.0), head - Vec3d(0.0, 0.3 * height, 0.0), head,
               pieces);
}

// Leaves in a spiral up a stem, the lower ones longer and flatter.
void add_leaves(Mesh& mesh, const std::vector<Vec3d>& path, int count, double length, std::uint64_t which) {
  for (auto k = 0; k < count; ++k) {
    const auto t = 0.22 + 0.78 * (k + 1) / count;
    const auto at = path[static_cast<std::size_t>(t * static_cast<double>(path.size() - 1))];
    const auto size = length * (1.15 - 0.45 * t) * dice_between(0.85, 1.15, 24, which, k);
    const auto rise = -10.0 - 50.0 * t * t;
    const auto paint = dice(25, which, k) < 0.6 ? Paint::leaf_dark : Paint::leaf_light;
    const auto grown = turned_x(length > 0.2 ? leaf(size, 4, 5) : leaf(size, 2, 4), rise);
    const auto turn = golden_angle * k + 360.0 * dice(26, which);
    // The stalk begins beside the stem, not in it.
    append(mesh, painted(placed(moved(grown, {0.0, 0.0, 0.012}), at, turn), paint));
  }
}

std::vector<Vec3d> twig(std::uint64_t which, int k, int pieces) {
  const auto angle = glm::radians(golden_angle * k + 40.0 * dice(27, which, k));
  const auto reach = dice_between(0.10, 0.24, 28, which, k);
  const auto height = dice_between(0.32, 0.50, 29, which, k);
  const auto out = Vec3d(std::cos(angle), 0.0, std::sin(angle));
  const auto head = reach * out + Vec3d(0.0, height, 0.0);
  return curve(0.012 * out + Vec3d(0.0, 0.001, 0.0), 0.02 * out + Vec3d(0.0, 0.4 * height, 0.0),
               0.6 * reach * out + Vec3d(0.0, 0.75 * height, 0.0), head, pieces);
}

constexpr auto twig_count = 6;

}  // namespace

Mesh plant_pot() {
  const auto pot = lathe({{0.0, 0.0},
                          {0.15, 0.0},
                          {0.16, 0.01},
                          {0.205, 0.30},
                          {0.215, 0.33},
                          {0.20, 0.335},
                          {0.19, 0.30},
                          {0.0, 0.30}},
                         36);
  return painted(painted(pot, Paint::clay), Paint::soil,
                 [](const Vec3d& p, const Vec3d& normal) { return normal.y > 0.99 && p.y < 0.31; });
}

Mesh plant_stems() {
  auto mesh = Mesh{};
  for (auto k = 0; k < stem_count; ++k) append(mesh, tube(stem(k, 8), 0.008, 8));
  return painted(std::move(mesh), Paint::leaf_light);
}

Mesh plant_leaves() {
  auto mesh = Mesh{};
  for (auto k = 0; k < stem_count; ++k) add_leaves(mesh, stem(k, 24), leaves_per_stem, 0.30, k);
  return mesh;
}

Mesh twig_stems(std::uint64_t which) {
  auto mesh = Mesh{};
  for (auto k = 0; k < twig_count; ++k) append(mesh, tube(twig(which, k, 6), 0.0025, 6));
  return painted(std::move(mesh), Paint::leaf_light);
}

Mesh twig_leaves(std::uint64_t which) {
  auto mesh = Mesh{};
  for (auto k = 0; k < twig_count; ++k) add_leaves(mesh, twig(which, k, 24), 7, 0.10, 100u * which + k);
  return mesh;
}

}  // namespace luxel::scenes
