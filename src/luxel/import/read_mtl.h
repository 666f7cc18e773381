// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// A picture that an MTL file names, and how it lies: a place (u, v) of the face is at scale * (u, v) + offset
// of the picture, whose v counts from the bottom.
struct MtlTexture {
  std::string name;          // of the file, as written; empty where there is none
  Vec2 scale = Vec2(1.0f);   // -s
  Vec2 offset = Vec2(0.0f);  // -o
  bool clamps = false;       // -clamp on: its border goes on for ever; else it repeats
};

// The properties of one material of an MTL file that matter to diffuse light.
struct MtlMaterial {
  std::string name;
  std::optional<Vec3> kd;  // reflectance, 0 or more
  std::optional<Vec3> ks;  // specular colour, 0 or more
  std::optional<Vec3> ke;  // radiance, W/(m² sr), 0 or more
  MtlTexture map_kd, map_ke, map_d;
  int illumination = 0;             // illum, 0 to 10; see is_glass() and is_polished()
  std::optional<Vec3> transmitted;  // Tf
  float refraction = 1.0f;          // Ni
  std::optional<float> opacity;     // d; Tr is passed over, since exporters disagree about its meaning
};

// Returns whether illum, Ni and Tf describe glass, whatever its d: refraction, and little diffuse light.
// Writers that give every material an illum of 4 leave its Ni at 1.
bool is_glass(const MtlMaterial& material);

// The transmittance of a pane, if Tf states one: [0, 1], at least 0.5 in a band. Below that Tf is usually the
// opacity, which some writers put there.
std::optional<Vec3> stated_transmittance(const MtlMaterial& material);

// Returns whether illum selects reflections of other surfaces, as metal and mirrors have them.
bool is_polished(const MtlMaterial& material);

// Reads the text of an MTL file. Throws InputError naming source and line for a Kd, Ks, Ke or d that is not
// the number it should be or a colour that is negative; all other statements are passed over.
std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& source);

}  // namespace luxel
