// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/quantise.h"

#include <algorithm>
#include <cmath>

#include "luxel/image/image.h"

namespace luxel {

Rgba16 quantise(const Vec3& colour) {
  const auto channel = [](float c) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(c, 0.0f, 1.0f) * 65535.0f));
  };
  return {channel(colour.r), channel(colour.g), channel(colour.b), 65535};
}

Vec3 srgb_codes(const Vec3& c) { return {srgb_encode(c.r), srgb_encode(c.g), srgb_encode(c.b)}; }

}  // namespace luxel
