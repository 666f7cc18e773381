// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace luxel {

/// Index that refers to no element, in every array of indices. No array has this many elements.
inline constexpr std::uint32_t none = 0xffffffffu;

}  // namespace luxel
