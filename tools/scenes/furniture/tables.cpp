// SPDX-License-Identifier: Apache-2.0
#include "scenes/furniture/tables.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/furniture/bookcase.h"
#include "scenes/shapes/dice.h"
#include "scenes/shapes/solids.h"
#include "scenes/shapes/sweeping.h"
#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

constexpr auto joint = 0.001;  // parts stand this far apart: no two faces in one place

// A profile of the outside with its foot on the floor, closed over the axis at both ends.
Mesh closed_lathe(const Profile& outside, int segments) {
  auto profile = Profile{{0.0, outside.front().y}};
  profile.insert(profile.end(), outside.begin(), outside.end());
  profile.emplace_back(0.0, outside.back().y);
  return lathe(profile, segments);
}

Mesh four_legs(double x, double z, double height, double splay, Paint paint) {
  auto mesh = Mesh{};
  for (const auto i : {-1.0, 1.0}) {
    for (const auto k : {-1.0, 1.0}) {
      append(mesh, leg({i * (x + splay), 0.0, k * (z + splay)}, {i * x, height, k * z}, 0.012, 0.022));
    }
  }
  return painted(std::move(mesh), paint);
}

}  // namespace

Mesh coffee_table() {
  const auto top = painted(rounded_box({1.15, 0.032, 0.62}, 0.016, {2, 0, 2}), Paint::oak);
  const auto shelf = painted(rounded_box({0.86, 0.018, 0.34}, 0.009, {1, 0, 1}), Paint::oak);
  return joined({placed(top, {0.0, coffee_table_height - 0.032, 0.0}), placed(shelf, {0.0, 0.16, 0.0}),
                 four_legs(0.46, 0.22, coffee_table_height - 0.032 - joint, 0.05, Paint::walnut)});
}

Mesh side_table() {
  const auto top = closed_lathe({{0.215, 0.0}, {0.23, 0.008}, {0.23, 0.018}, {0.215, 0.026}}, 30);
  const auto foot = closed_lathe(
      smooth({{0.15, 0.0}, {0.145, 0.012}, {0.03, 0.03}, {0.018, 0.10}, {0.016, 0.30}, {0.03, 0.492}}, 2),
      20);
  return joined({painted(placed(top, {0.0, side_table_height - 0.026, 0.0}), Paint::walnut),
                 painted(foot, Paint::brass)});
}

Mesh sideboard() {
  auto mesh = painted(placed(rounded_box({1.60, 0.56, 0.42}, 0.012), {0.0, 0.18, 0.0}), Paint::walnut);
  for (auto k = 0; k < 3; ++k) {
    const auto x = 0.52 * (k - 1);
    append(mesh, painted(placed(box({0.50, 0.50, 0.014}), {x, 0.21, 0.21 + 0.007 + joint}), Paint::oak));
    append(mesh, painted(placed(turned_x(cylinder(0.012, 0.016, 12), 90.0),
                                {x + 0.19, 0.48, 0.21 + 0.014 + 2.0 * joint}),
                         Paint::brass));
  }
  append(mesh, four_legs(0.70, 0.14, 0.18 - joint, 0.03, Paint::black_steel));
  return mesh;
}

Mesh rug() {
  // Borders run round it at these distances from its edge.
  constexpr std::array borders = {0.0, 0.09, 0.20, 0.24, 0.44, 0.49};
  constexpr auto half = glm::dvec2(1.3, 0.95);
  auto lines = [&](double half_side) {
    auto result = std::vector<double>{};
    for (const auto d : borders) result.push_back(d - half_side);
    for (auto k = borders.size(); k-- > 0;) result.push_back(half_side - borders[k]);
    return result;
  };
  auto between = [&](double low, double high) {
    return [=](const Vec3d& p, const Vec3d&) {
      const auto edge = std::min(half.x - std::abs(p.x), half.y - std::abs(p.z));
      return edge > low && edge < high;
    };
  };
  auto mesh = painted(cut_box(lines(half.x), rug_height, lines(half.y)), Paint::rug_cream);
  mesh = painted(mesh, Paint::rug_indigo, between(-1.0, 0.09));
  mesh = painted(mesh, Paint::rug_rust, between(0.09, 0.20));
  return painted(mesh, Paint::rug_indigo, between(0.44, 0.49));
}

Mesh vase(Paint glaze, double height) {
  const auto outline =
      smooth({{0.050, 0.0}, {0.075, 0.12}, {0.085, 0.38}, {0.055, 0.66}, {0.028, 0.84}, {0.040, 1.0}}, 2);
  auto profile = Profile{};
  for (const auto& p : outline) profile.emplace_back(3.6 * p.x * height, p.y * height);
  return painted(closed_lathe(profile, 18), glaze);
}

Mesh bellied_vase(Paint glaze, double height) {
  const auto outline =
      smooth({{0.18, 0.0}, {0.36, 0.15}, {0.46, 0.42}, {0.36, 0.72}, {0.17, 0.88}, {0.21, 1.0}}, 2);
  auto profile = Profile{};
  for (const auto& p : outline) profile.emplace_back(p.x * height, p.y * height);
  return painted(closed_lathe(profile, 18), glaze);
}

Mesh bowl(Paint glaze, double radius) {
  const auto r = radius;
  auto profile = Profile{{0.0, 0.0}, {0.42 * r, 0.0}};
  for (const auto& p : {glm::dvec2(0.72, 0.14), {0.92, 0.34}, {1.0, 0.56}}) profile.push_back(r * p);
  for (const auto& p : {glm::dvec2(0.95, 0.57), {0.86, 0.36}, {0.66, 0.18}, {0.38, 0.07}}) {
    profile.push_back(r * p);
  }
  profile.emplace_back(0.0, 0.05 * r);
  return painted(lathe(profile, 24), glaze);
}

Mesh fruit_bowl(Paint glaze) {
  auto mesh = bowl(glaze, 0.16);
  const auto orange = painted(sphere(0.036, 14), Paint::orange_peel);
  append(mesh, moved(orange, {0.0, 0.046, 0.0}));
  for (auto k = 0; k < 4; ++k) {
    append(mesh, moved(turned_y(moved(orange, {0.074, 0.062, 0.0}), 90.0 * k), Vec3d(0.0)));
  }
  append(mesh, moved(orange, {0.005, 0.119, 0.004}));
  return mesh;
}

Mesh lying_books(std::uint64_t which, int count) {
  auto mesh = Mesh{};
  auto height = 0.0;
  for (auto k = 0; k < count; ++k) {
    const auto thickness = dice_between(0.022, 0.042, 71, which, 2u * k);
    const auto book = standing_book(100u * which + k, {thickness, 0.25 - 0.015 * k, 0.19 - 0.01 * k});
    const auto lying = moved(turned_z(book, 90.0), {0.5 * (0.25 - 0.015 * k), 0.5 * thickness, 0.0});
    append(mesh, placed(lying, {0.0, height, 0.0}, dice_between(-14.0, 14.0, 71, which, 2u * k + 1)));
    height += thickness + joint;
  }
  return mesh;
}

Mesh mug(Paint glaze) {
  const auto body = lathe(
      {{0.0, 0.0}, {0.034, 0.0}, {0.040, 0.006}, {0.042, 0.09}, {0.038, 0.09}, {0.036, 0.01}, {0.0, 0.008}},
      18);
  return painted(body, glaze);
}

}  // namespace luxel::scenes
