// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "support/truth_scenes.h"

namespace luxel::truth {

// Adds the six faces of a box, normals outwards.
inline void add_box(SceneBuilder& builder, const Vec3& low, const Vec3& high) {
  const auto at = [&](int x, int y, int z) {
    return Vec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
  };
  builder.quad(at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0));
  builder.quad(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
  builder.quad(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
  builder.quad(at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0));
  builder.quad(at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
  builder.quad(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
}

// A room of 2 x 2 x 1.5 m of thin walls under an even sky of radiance 1: the wall y = 0 has a hole of
// 0.5 x 0.5 m from (0.75, 0, 0.5) to (1.25, 0, 1). Its parts are materials: "floor", "walls", "front" (with
// the hole), reflectance 0.5.
inline SceneBuilder window_room() {
  SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0});
  builder.material("walls", 0.5f, 0.0f)
      .quad({0, 0, 1.5f}, {0, 2, 1.5f}, {2, 2, 1.5f}, {2, 0, 1.5f})
      .quad({0, 0, 0}, {0, 2, 0}, {0, 2, 1.5f}, {0, 0, 1.5f})
      .quad({2, 0, 0}, {2, 0, 1.5f}, {2, 2, 1.5f}, {2, 2, 0})
      .quad({0, 2, 0}, {2, 2, 0}, {2, 2, 1.5f}, {0, 2, 1.5f});
  builder.material("front", 0.5f, 0.0f);
  constexpr std::array<float, 4> x = {0.0f, 0.75f, 1.25f, 2.0f}, z = {0.0f, 0.5f, 1.0f, 1.5f};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (i != 1 || j != 1)
        builder.quad({x[i], 0, z[j]}, {x[i], 0, z[j + 1]}, {x[i + 1], 0, z[j + 1]}, {x[i + 1], 0, z[j]});
  return builder;
}

inline Scene under_sky(const SceneBuilder& builder, float radiance = 1.0f) {
  auto scene = builder.scene();
  scene.sky = Vec3(radiance);
  return scene;
}

// The hole of window_room(), lit from outside; or what else fills such a rectangle of a plane y = depth.
inline std::vector<Portal> window_portals(float depth = 0.0f, bool both_ways = false) {
  const Vec3 a(0.75f, depth, 0.5f), b(1.25f, depth, 0.5f), c(1.25f, depth, 1.0f), d(0.75f, depth, 1.0f);
  return {{{a, d, c}, both_ways}, {{a, c, b}, both_ways}};  // their normal is +y
}

}  // namespace luxel::truth
