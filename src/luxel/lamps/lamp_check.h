// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// What the rays of one lamp material meet, from its shining front and, for comparison, from its back.
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
std::vector<LampView> view_from_lamps(const PatchSet& patches, const Tracer& tracer, const Workers& workers);

enum class LampFault {
  none,
  lights_nothing,  // it shines out of the scene
  faces_wall,      // it shines against a surface right before it, while its back has room
};
LampFault judge(const LampView& view);
// Whether its back looks into the scene, so that to turn it round may be what was meant.
bool turning_helps(const LampView& view);

// What is the matter with a lamp, as a sentence, or nothing; the same with what to do about it.
std::string lamp_fact(const PatchSet& patches, const LampView& view);
std::string lamp_fault(const PatchSet& patches, const LampView& view);

}  // namespace luxel
