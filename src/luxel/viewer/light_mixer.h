// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/session/progressive_session.h"

namespace luxel {

// Sliders of lamps and colours of surfaces, as a person sets them: in linear sRGB, whatever bands the light
// has.
struct LightMixer {
  struct Lamps {
    std::string name;
    float factor = 1.0f;     // times as bright, 0 or more
    Vec3 tint = Vec3(1.0f);  // times the colour
    bool operator==(const Lamps&) const = default;
  };
  struct Surface {
    std::string name;
    Vec3 own = Vec3(0.0f), colour = Vec3(0.0f);  // reflectance, [0, 1)
    bool is_lamp = false;
    bool operator==(const Surface&) const = default;
  };
  std::vector<Lamps> lamps;        // [light group]
  std::vector<Surface> materials;  // [material]

  LightMixer() = default;
  // As the scene has them.
  explicit LightMixer(const PatchSet& patches);

  bool is_untouched() const;
  bool operator==(const LightMixer&) const = default;
  // What the solver is told. Bands without colour stay as they are. The tint of a group of luminaires changes
  // their colour but not their lumens.
  Lighting lighting(const PatchSet& patches) const;
};

}  // namespace luxel
