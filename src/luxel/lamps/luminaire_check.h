// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// A surface that takes light of a luminaire because of where the luminaire was placed.
struct LuminaireFault {
  enum class Kind {
    crosses,  // the surface passes through the opening
    hides     // it lies right before the opening
  };
  Kind kind = Kind::crosses;
  std::size_t light = 0;  // an index into PatchSet::point_lights
  std::size_t patch = 0;  // of the surface
  Vec3d move{0.0};        // m, the shift that frees the luminaire from it
};

// Luminaires with an opening that a surface wider than the opening crosses, or hides from less than 50 mm
// before it, in the order of the lights; surfaces within `recess` of an opening do no harm. A model of the
// housing is no fault. Some rays per luminaire; the same answer each time.
std::vector<LuminaireFault> find_luminaire_faults(const PatchSet& patches, const Tracer& tracer);

// Faults of one kind by luminaires of one file at one material.
struct LuminaireFaultGroup {
  LuminaireFault::Kind kind = LuminaireFault::Kind::crosses;
  std::string file, material;
  std::vector<LuminaireFault> faults;
  double distance = 0.0;  // m, the longest move
  // "12 luminaires of 'office.ldt' reach 50 mm through a surface of 'ceiling'"; and what to do.
  std::string fact, remedy;
};
std::vector<LuminaireFaultGroup> group_faults(const PatchSet& patches,
                                              const std::vector<LuminaireFault>& faults);

// "12 luminaires of 'office.ldt' reach 50 mm through a surface of 'ceiling': moved away from it by as much".
std::string moved_text(const LuminaireFaultGroup& group);

// Moves each luminaire that a surface crosses out of it, into the half of space where it emits more, so that
// a luminaire whose height is that of its ceiling hangs below. One that would meet another surface there
// stays. Returns the faults that are mended. The same scene gets the same places. Cost: building a Tracer;
// nothing where no luminaire has an opening with a height.
std::vector<LuminaireFaultGroup> move_luminaires_free(Scene& scene, const Context& context);

}  // namespace luxel
