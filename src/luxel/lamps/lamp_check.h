// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/hint.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The share of rays of one lamp material that leave the scene and the distance of the others, from its
// emitting front and, for comparison, from its back.
struct LampView {
  struct Side {
    double escaped = 0.0;          // share of rays that leave the scene
    double median_distance = 0.0;  // m, of those that do not
  };
  std::size_t material = 0;   // index into PatchSet::materials
  std::vector<double> power;  // W, [band]
  std::size_t patches = 0;
  Side front, back;
};

// One entry for each material that emits and has patches, in the order of materials. A thousand rays per side
// of a lamp, some milliseconds; the same answer each time.
std::vector<LampView> view_from_lamps(const PatchSet& patches, const Tracer& tracer, const Context& context);

enum class LampFault {
  no_fault,
  lights_nothing,  // it shines out of the scene
  faces_wall,      // it shines against a surface right before it, while its back has room
};
LampFault judge(const LampView& view);
// Returns whether its back faces the scene, so that it may have to be flipped.
bool turning_helps(const LampView& view);

// Describes the problem of a lamp as a sentence, empty if there is none; the same with a remedy.
std::string lamp_fact(const PatchSet& patches, const LampView& view);
struct LampWarning {
  std::string text;  // empty: nothing is wrong
  std::vector<Hint> hints;
};
LampWarning lamp_warning(const PatchSet& patches, const LampView& view);

}  // namespace luxel
