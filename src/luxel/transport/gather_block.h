// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/transport/gather_sides.h"

namespace luxel {

// Neighbouring sides whose rays are traced together: those of one block of positions, and all fronts or all
// backs.
constexpr std::uint32_t gather_block_positions = 1024;

// Where blocks begin: slots, and at the end the number of slots.
std::vector<std::uint32_t> gather_block_begins(const GatherSides& sides);

}  // namespace luxel
