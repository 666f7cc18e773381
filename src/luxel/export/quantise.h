// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "luxel/core/vector.h"

namespace luxel {

using Rgba16 = std::array<std::uint16_t, 4>;

// A linear colour, clamped to [0, 1], opaque.
Rgba16 quantise(const Vec3& colour);

// The sRGB codes of a linear colour, [0, 1].
Vec3 srgb_codes(const Vec3& linear);

}  // namespace luxel
