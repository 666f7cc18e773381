// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "luxel/math/bounds.h"

namespace luxel {

// Calls visit(i, j) once, i < j, for each two boxes that overlap or touch. The order is the same on every
// host. Cost: n log n to sort the boxes into a tree, and what the pairs cost; about a second for a million
// triangles of a mesh. Up to 2^31 boxes, none of them empty.
void for_overlapping_pairs(std::span<const Bounds> boxes,
                           const std::function<void(std::uint32_t, std::uint32_t)>& visit);

}  // namespace luxel
