// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel::scenes {

// A luminaire of our own. Angles in degrees, type C as in IES files: the length lies along 0-180, the wall of
// a wall washer is at 90. Values are rounded to what the files hold, so that both formats have the same
// light.
struct MadeLuminaire {
  const char* name;   // "led-panel"
  const char* about;  // a few words
  std::vector<double> vertical = {}, horizontal = {};
  std::vector<double> per_klm = {};  // cd per 1000 lm of the lamps, [horizontal][vertical]
  double lamp_flux = 0.0;            // lm; of the luminaire itself where absolute
  double efficiency = 1.0;           // luminaire flux over lamp flux; 1 where absolute
  bool absolute = true;
  double watts = 0.0;
  Vec3d size = Vec3d(0.0);  // m: length, width, height of the luminous opening
  bool round = false;       // a disk of this length
};

std::span<const MadeLuminaire> luminaire_list();

// The text of a photometric file of the luminaire with this name; ending: ".ies" (LM-63-2002) or ".ldt"
// (EULUMDAT). Throws std::out_of_range for an unknown name or ending.
std::string luminaire_file(std::string_view name, std::string_view ending);

}  // namespace luxel::scenes
