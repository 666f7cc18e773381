// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace luxel {

/// The index of nothing, in every array of indices. No array holds so many elements.
inline constexpr std::uint32_t none = 0xffffffffu;

}  // namespace luxel
