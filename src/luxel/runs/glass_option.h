// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/import/load_scene.h"

namespace luxel {

// Reads "0.8", "NAME=0.8", "NAME=0.7,0.8,0.75" or, with a transmissivity as Radiance's glass has it,
// "NAME=tn:0.96". Throws UsageError.
GlassOption parse_glass(const std::string& text);

// As parse_glass() reads it: always a transmittance.
std::string glass_as_text(const GlassOption& option);

}  // namespace luxel
