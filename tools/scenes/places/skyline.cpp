// SPDX-License-Identifier: Apache-2.0
#include "scenes/places/skyline.h"

#include <array>
#include <vector>

#include "scenes/shapes/dice.h"
#include "scenes/shapes/sheets.h"

namespace luxel::scenes {
namespace {

constexpr auto layer = 0.004;  // m from the sky to the far houses, and on to the near ones and their windows

struct House {
  double left, width, wall, roof;  // m: the wall's height, and the gable's above it (0: a flat roof)
};

// A row of houses from the view's left end to its right one.
std::vector<House> row_of_houses(std::uint64_t row, double width, double tallest) {
  auto houses = std::vector<House>{};
  auto x = 0.0;
  for (auto k = 0u; x < width; ++k) {
    const auto wide = std::min(dice_between(0.11, 0.24, 31 + row, k, 0), width - x);
    const auto tower = dice(31 + row, k, 1) < 0.2 ? 1.5 : 1.0;
    const auto wall = tower * tallest * dice_between(0.40, 0.72, 31 + row, k, 2);
    const auto gabled = tower == 1.0 && dice(31 + row, k, 3) < 0.6;
    houses.push_back({x, wide, wall, gabled ? 0.45 * wide : 0.0});
    x += wide;
  }
  return houses;
}

std::vector<House> far_row(double width, double height) { return row_of_houses(0, width, 0.34 * height); }
std::vector<House> near_row(double width, double height) { return row_of_houses(1, width, 0.24 * height); }

Mesh silhouette(const std::vector<House>& houses, const Vec3d& corner, Paint paint) {
  auto mesh = Mesh{};
  for (const auto& [left, width, wall, roof] : houses) {
    const auto foot = corner + Vec3d(left, 0.0, 0.0);
    append(mesh, panel(foot, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.5 * width, width}, {0.0, wall}));
    if (roof <= 0.0) continue;
    const auto a = mesh.add_point(foot + Vec3d(0.0, wall, 0.0));
    const auto b = mesh.add_point(foot + Vec3d(0.5 * width, wall, 0.0));
    const auto c = mesh.add_point(foot + Vec3d(width, wall, 0.0));
    const auto top = mesh.add_point(foot + Vec3d(0.5 * width, wall + roof, 0.0));
    mesh.add_triangle(a, b, top);
    mesh.add_triangle(b, c, top);
  }
  return painted(std::move(mesh), paint);
}

Vec3d corner_of(double width, double height, int layers) {
  return {-0.5 * width, -0.5 * height, layer * layers};
}

}  // namespace

Mesh evening_sky(double width, double height) {
  constexpr std::array bands = {Paint::window_sky_1, Paint::window_sky_2, Paint::window_sky_3,
                                Paint::window_sky_4, Paint::window_sky_5, Paint::window_sky_6,
                                Paint::window_sky_7, Paint::window_sky_8};
  // The first band begins behind the roofs.
  constexpr auto horizon = 0.12;
  auto sky = panel(corner_of(width, height, 0), {width, 0.0, 0.0}, {0.0, height, 0.0},
                   steps({0.0, 1.0}, 0.125), steps({0.0, horizon, 1.0}, (1.0 - horizon) / bands.size()));
  for (auto& triangle : sky.triangles) {
    const auto above = (centroid(sky, triangle).y / height + 0.5 - horizon) / (1.0 - horizon);
    const auto band = std::max(0.0, above) * static_cast<double>(bands.size());
    triangle.paint = bands[static_cast<std::size_t>(band)];
  }
  return sky;
}

Mesh town(double width, double height) {
  return joined({silhouette(far_row(width, height), corner_of(width, height, 1), Paint::night_city_far),
                 silhouette(near_row(width, height), corner_of(width, height, 2), Paint::night_city)});
}

Mesh lit_windows(double width, double height) {
  constexpr auto pitch = glm::dvec2(0.034, 0.042);
  constexpr auto size = glm::dvec2(0.014, 0.020);
  const auto corner = corner_of(width, height, 3);
  auto mesh = Mesh{};
  auto number = 0u;
  for (const auto& house : near_row(width, height)) {
    for (auto x = 0.02; x + size.x < house.width - 0.015; x += pitch.x) {
      for (auto y = 0.03; y + size.y < house.wall - 0.01; y += pitch.y) {
        if (dice(33, ++number) > 0.36) continue;
        append(mesh, panel(corner + Vec3d(house.left + x, y, 0.0), {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                           {0.0, size.x}, {0.0, size.y}));
      }
    }
  }
  return painted(std::move(mesh), Paint::window_city_lights);
}

}  // namespace luxel::scenes
