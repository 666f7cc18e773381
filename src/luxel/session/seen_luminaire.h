// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// A luminaire under the cursor.
struct SeenLuminaire {
  std::string name;       // of the luminaire, as the scene has it
  std::string file;       // photometric, as the user named it
  std::string group;      // light group; empty where all light is one
  double lumens = 0.0;    // lm, as it is dimmed now
  double distance = 0.0;  // m, along the ray
};

// The nearest luminaire whose opening, as displays show it, is on the ray before a surface at this distance
// (infinite: none); an opening up to 5 mm behind it counts as well. patches: with the lamps as they are lit.
// Microseconds per thousand luminaires.
std::optional<SeenLuminaire> seen_luminaire(const PatchSet& patches, const Ray& ray, float distance);

}  // namespace luxel
