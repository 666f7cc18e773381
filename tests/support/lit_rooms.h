// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/lit_patches.h"

namespace luxel::test {

// A parallelogram from `corner`, front towards cross(along, across), cut into steps * steps * 2 patches.
inline void add_plate(LitPatches& lit, const Vec3& corner, const Vec3& along, const Vec3& across, int steps,
                      float front, float back = 0.0f, std::uint32_t material = 0) {
  const auto first = static_cast<std::uint32_t>(lit.patches.vertices.size());
  const auto row = static_cast<std::uint32_t>(steps + 1);
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= steps; ++i)
      lit.vertex(corner + (static_cast<float>(i) * along + static_cast<float>(j) * across) /
                              static_cast<float>(steps));
  for (std::uint32_t j = 0; j + 1 < row; ++j) {
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const auto a = first + j * row + i;
      lit.patch({a, a + 1, a + row + 1}, front, back, material);
      lit.patch({a, a + row + 1, a + row}, front, back, material);
    }
  }
}

enum class Facing { inwards, outwards };

// Six plates of a box, y up; light: irradiance of the fronts, which face as named. open: leaves out the plate
// at the largest z.
inline void add_box(LitPatches& lit, const Vec3& low, const Vec3& high, Facing facing, float light,
                    bool open = false, int steps = 4) {
  const Vec3 x(high.x - low.x, 0.0f, 0.0f);
  const Vec3 y(0.0f, high.y - low.y, 0.0f);
  const Vec3 z(0.0f, 0.0f, high.z - low.z);
  const auto plate = [&](const Vec3& corner, const Vec3& a, const Vec3& b) {
    if (facing == Facing::inwards)
      add_plate(lit, corner, a, b, steps, light);
    else
      add_plate(lit, corner, b, a, steps, light);
  };
  plate(low, z, x);      // floor
  plate(low + y, x, z);  // ceiling
  plate(low, x, y);
  if (!open) plate(low + z, y, x);
  plate(low, y, z);
  plate(low + x, z, y);
}

inline void scale(LitPatches& lit, float factor) {
  for (auto& v : lit.patches.vertices) v *= factor;
  for (auto& a : lit.patches.area) a *= factor * factor;
}

}  // namespace luxel::test
