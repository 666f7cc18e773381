// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/session/progressive_session.h"

namespace luxel {

// Sliders of lamps and colours of surfaces, as set by the user: in linear sRGB, for any bands of the
// light.
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
  // The scene's own lamps and colours.
  explicit LightMixer(const PatchSet& patches);

  bool is_untouched() const;
  bool operator==(const LightMixer&) const = default;
  // Returns the lighting for the solver. Bands without colour stay as they are. The tint of a group of
  // luminaires changes their colour but not their lumens.
  Lighting lighting(const PatchSet& patches) const;
};

}  // namespace luxel
