// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/lighting/grid_figures.h"
#include "luxel/lighting/verdict.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// The general colour rendering index Ra that a photometric file states, as an interval: "80" and "Ra>80",
// the groups of CIE 29.2 (1A: 90 to 100, 1B: 80 to 89, 2A: 70 to 79, 2B: 60 to 69, 3: 40 to 59, 4: 20 to 39),
// and the codes of light colours ("840": 80 to 89). Nothing where the text has none of these.
std::optional<Figure> colour_rendering_of(const std::string& text);

// Judges the least Ra of the luminaires of a scene. Not known where there are none, where the scene has other
// lamps, or where a file does not state it, unless another one is too small.
Verdict judge_colour_rendering(const PatchSet& patches, double required);

}  // namespace luxel
