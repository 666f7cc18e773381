// SPDX-License-Identifier: Apache-2.0
// The Cornell box as scenes/cornell-box.obj has it.

#include <array>

#include "scenes/places/places.h"

namespace luxel::scenes {
namespace {

using Corners = std::array<Vec3d, 4>;

Mesh quad(const Corners& corners, Paint paint) {
  auto mesh = Mesh{};
  for (const auto& p : corners) mesh.add_point(p);
  mesh.add_quad(0, 1, 2, 3);
  return painted(mesh, paint);
}

// A block on the floor without its bottom face; its foot is counter-clockwise seen from above.
Mesh block(const std::array<glm::dvec2, 4>& foot, double height) {
  auto mesh = Mesh{};
  for (const auto y : {0.0, height}) {
    for (const auto& p : foot) mesh.add_point({p.x, y, p.y});
  }
  mesh.add_quad(4, 5, 6, 7);
  for (auto k = 0u; k < 4; ++k) mesh.add_quad(k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k);
  return painted(mesh, Paint::box_white);
}

}  // namespace

MadeScene cornell_box() {
  constexpr auto x = 0.2764, y = 0.5488, z = -0.5592, lamp = 0.5438;
  auto scene = MadeScene{.title = "The Cornell box: its measured outline made exactly rectangular"};
  scene.add_open("floor", quad({Vec3d(-x, 0, 0), {x, 0, 0}, {x, 0, z}, {-x, 0, z}}, Paint::box_white));
  scene.add_open("ceiling", quad({Vec3d(-x, y, 0), {-x, y, z}, {x, y, z}, {x, y, 0}}, Paint::box_white));
  scene.add_open("back_wall", quad({Vec3d(-x, 0, z), {x, 0, z}, {x, y, z}, {-x, y, z}}, Paint::box_white));
  scene.add_open("left_wall", quad({Vec3d(-x, 0, 0), {-x, 0, z}, {-x, y, z}, {-x, y, 0}}, Paint::box_red));
  scene.add_open("right_wall", quad({Vec3d(x, 0, 0), {x, y, 0}, {x, y, z}, {x, 0, z}}, Paint::box_green));
  scene.add_open(
      "short_block",
      block({glm::dvec2(0.1464, -0.0650), {0.1944, -0.2250}, {0.0364, -0.2720}, {-0.0136, -0.1140}}, 0.165));
  scene.add_open(
      "tall_block",
      block({glm::dvec2(-0.1466, -0.2470), {0.0114, -0.2960}, {-0.0376, -0.4560}, {-0.1956, -0.4060}}, 0.33));
  scene.add_open(
      "lamp",
      quad(
          {Vec3d(-0.065, lamp, -0.227), {-0.065, lamp, -0.332}, {0.065, lamp, -0.332}, {0.065, lamp, -0.227}},
          Paint::lamp_box));
  scene.views = {{"the whole box", {0.0, 0.2744, 1.08}, {0.0, 0.2744, -0.2796}, 30.0}};
  return scene;
}

}  // namespace luxel::scenes
