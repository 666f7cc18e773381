// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "luxel/lighting/areas.h"
#include "luxel/lighting/glare.h"
#include "luxel/lighting/verdict.h"

namespace luxel {

// UGR of an observer with a name.
struct NamedGlare {
  std::string name;
  Vec3d eye{0.0};  // m, in the coordinates of the scene's file
  ObservedGlare glare;
};

// Judges UGR <= required by the highest of all observers. Met where no lamp dazzles any of them; not known
// where there are none, or where one sees a dark background. The note names the observer.
Verdict judge_glare(std::span<const NamedGlare> observers, double required);

// Judges the UGR that an area requires, by the observers whose eyes lie above or below its polygon; by all
// observers where none does, as the note states. Nothing where the area requires none.
std::optional<Verdict> judge_glare(const CalculationArea& area, std::span<const NamedGlare> observers,
                                   const Vec3d& up);

}  // namespace luxel
