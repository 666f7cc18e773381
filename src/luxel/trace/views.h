// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/patch/side.h"

namespace luxel {

// Viewpoints and the patch sides that each of them sees.
//
// A view is a list of directions of equal solid angle. A direction that leaves a dark scene, or that meets
// the absorbing back of a one-sided surface, is not in the list.
struct Views {
  // Codes in `seen` beside the indices of sides.
  static constexpr std::uint32_t sky = 0x7fffffffu;
  // Set where the surface is outside of the focus: it counts for the adaptation of the eye, not for the
  // error.
  static constexpr std::uint32_t unfocused = 0x80000000u;

  std::vector<Vec3> eye;             // [view], m, in the coordinates of the patches
  std::vector<float> weight;         // [view], they add up to 1
  std::size_t cameras = 0;           // number of views of cameras, which are the last
  std::vector<std::uint32_t> first;  // [view], and the end: its directions are seen[first[v] .. first[v + 1])
  std::vector<std::uint32_t> seen;   // [direction]: index into `sides`, or sky; may have `unfocused` set
  std::vector<SideId> sides;         // sides that are seen, ascending

  std::size_t size() const { return eye.size(); }
  std::span<const std::uint32_t> seen_by(std::size_t view) const {
    return std::span(seen).subspan(first[view], first[view + 1] - first[view]);
  }
};

}  // namespace luxel
