// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/gtc/packing.hpp>

namespace luxel {

// The number as an IEEE 754 half: 11 bits of precision from 6e-5 to 65504, fewer down to 6e-8.
inline std::uint16_t half_of(float value) { return glm::packHalf1x16(value); }

}  // namespace luxel
