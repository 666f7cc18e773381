// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "luxel/import/load_scene.h"
#include "luxel/import/set_daylight.h"

#include "support/truth_scenes.h"

namespace luxel::test {

// The black room of the daylight cases of CIE 171, 5.9 to 5.14: x 0 to 4, y 0 to 4, z 0 to 3 m.
struct Opening {
  float u0, u1, v0, v1;  // m, x and y of a roof; x and z of a façade
};
inline constexpr Opening roof_1x1{1.5f, 2.5f, 1.5f, 2.5f}, roof_4x4{0, 4, 0, 4};
inline constexpr Opening facade_2x1{1, 3, 1, 2}, facade_4x3{0, 4, 0, 3};
inline constexpr float far_away = 1000.0f;  // m, half the length of what is continuous

// Quads of the material last named around a hole, in the plane of at(u, v).
template <typename At>
void add_frame(truth::SceneBuilder& b, const Opening& outer, const Opening& hole, const At& at) {
  const auto quad = [&](float u0, float u1, float v0, float v1) {
    if (u0 < u1 && v0 < v1) b.quad(at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1));
  };
  quad(outer.u0, outer.u1, outer.v0, hole.v0);
  quad(outer.u0, outer.u1, hole.v1, outer.v1);
  quad(outer.u0, hole.u0, hole.v0, hole.v1);
  quad(hole.u1, outer.u1, hole.v0, hole.v1);
}

inline Vec3 on_roof(float x, float y) { return {x, y, 3}; }
inline Vec3 on_facade(float x, float z) { return {x, 0, z}; }

inline truth::SceneBuilder three_walls_and_floor() {
  truth::SceneBuilder b;
  b.material("black", 0.0f, 0.0f)
      .quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0})
      .quad({4, 0, 0}, {4, 0, 3}, {4, 4, 3}, {4, 4, 0})
      .quad({4, 4, 0}, {4, 4, 3}, {0, 4, 3}, {0, 4, 0})
      .quad({0, 4, 0}, {0, 4, 3}, {0, 0, 3}, {0, 0, 0});
  return b;
}

// The room with an opening in its roof.
inline truth::SceneBuilder roof_room(const Opening& opening) {
  auto b = three_walls_and_floor();
  b.quad({0, 0, 0}, {0, 0, 3}, {4, 0, 3}, {4, 0, 0});
  add_frame(b, roof_4x4, opening, on_roof);
  return b;
}

// The room with an opening in its façade y = 0, which reaches from x = -extent to 4 + extent.
inline truth::SceneBuilder facade_room(const Opening& opening, float extent = 0.0f) {
  auto b = three_walls_and_floor();
  b.quad({0, 0, 3}, {0, 4, 3}, {4, 4, 3}, {4, 0, 3});
  add_frame(b, {-extent, 4 + extent, 0, 3}, opening, on_facade);
  return b;
}

// A CIE sky with the sun's place at 60 degrees, but not its light; the ground has reflectance 0.3.
inline Daylight cie171_sky(int type, double azimuth) {
  Daylight d;
  d.sky = Daylight::Sky::cie;
  d.cie_type = type;
  d.illuminance = 10'000.0;
  d.sun = Daylight::Sun{60.0, azimuth};
  d.sun_illuminance = 0.0;
  d.albedo = 0.3;
  return d;
}

}  // namespace luxel::test
