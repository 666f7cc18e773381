// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "luxel/image/tone.h"
#include "luxel/viewer/colour_map.h"

namespace luxel {

// The quantity that surfaces show. The order is that of the panel.
enum class Show { light, irradiance, standard_error, patch_size, level, difference, unshot, grey, sides };
inline constexpr int show_count = 9;

// The display settings. Every choice has a name, which scripts use.
struct Look {
  Show show = Show::light;
  ToneOptions tone = {};
  bool automatic_exposure = true;  // fitted to what is in view; else it stays

  bool lux = true;  // else W/m²
  bool logarithmic = false;
  bool automatic_scale = true;
  float low = 0.0f, high = 1000.0f;  // of a scale that is not automatic
  int isolines = 9;                  // 0: none

  bool wires = false;
  bool normals = false;
  bool boxes = false;
  int box_level = 4;
  bool rays = false;     // of the patch under the cursor
  bool samples = false;  // its direct light
  bool diagnostics = false;
  bool solids = false;  // photometric solids of luminaires

  bool panel = true;   // with the menus
  bool keys = true;    // the line of keys at the bottom
  bool help = false;   // all keys
  bool about = false;  // version and licence

  // Sets the setting of that name: "show", "tone", "exposure", "lux", "log", "low", "isolines", "wires", ...;
  // switches take on and off. Throws InputError, one sentence, where there is no such setting or value.
  void set(std::string_view name, const std::string& value);

  bool operator==(const Look&) const = default;
};

// Reads a number of a script. Throws InputError that names `of`.
float script_number(std::string_view of, const std::string& text);

}  // namespace luxel
