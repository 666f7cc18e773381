// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "luxel/math/vector.h"

namespace luxel {

enum class MaterialId : std::uint32_t {};

// A diffuse surface, linear sRGB.
struct Material {
  std::string name = {};
  Vec3 reflectance = Vec3(0.5f);  // [0, 1); load caps it, see LoadOptions::max_reflectance
  Vec3 emittance = Vec3(0.0f);    // W/m² a band, of the front side only; pi times the radiance (OBJ's Ke)
  bool two_sided = true;          // false: the back absorbs what meets it and is counted

  bool opaque = true;  // false: light passes as if it were not there (a pane of glass)

  std::optional<Vec3> stated_reflectance = {};  // what the file said, where load lowered it

  bool is_lamp() const { return emittance.r > 0.0f || emittance.g > 0.0f || emittance.b > 0.0f; }
};

}  // namespace luxel
