// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Random places on the surfaces of a scene, and cosine rays from there.
class StartSides {
 public:
  // Keeps a reference. Half of the places are dealt by area, half by input triangle, so that a house in a
  // wide landscape gets its part. Patches where may_start is 0 get none; empty: all may. Two-sided surfaces
  // give both of their sides.
  StartSides(const PatchSet& patches, const std::vector<std::uint8_t>& may_start);

  bool empty() const { return !(total_ > 0.0); }
  // A side, 2 * patch + 1 for the back, from a uniform number.
  std::uint32_t pick(float u) const;

 private:
  const PatchSet& patches_;
  std::vector<double> sum_;  // [patch], inclusive
  double total_ = 0.0;
};

// A cosine ray from a uniform point of a side, lifted off the surface. u: uniform.
Ray ray_from_side(const PatchSet& patches, std::uint32_t side, const std::array<float, 4>& u);

}  // namespace luxel
