// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "luxel/core/vector.h"

namespace luxel {

// The four texels that a place on a square page is read from, and what each of them counts.
struct Footprint {
  std::array<std::size_t, 4> texel{};  // row by row from the top left
  std::array<float, 4> weight{};       // sums to 1

  // at: texels, from the top left; width: of the page.
  Footprint(const Vec2& at, int width) {
    const auto low = glm::floor(at - 0.5f);
    const auto fraction = at - 0.5f - low;
    for (int i = 0; i < 4; ++i) {
      const auto x = std::clamp(static_cast<int>(low.x) + i % 2, 0, width - 1);
      const auto y = std::clamp(static_cast<int>(low.y) + i / 2, 0, width - 1);
      texel[static_cast<std::size_t>(i)] = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + x;
      weight[static_cast<std::size_t>(i)] =
          (i % 2 == 0 ? 1.0f - fraction.x : fraction.x) * (i / 2 == 0 ? 1.0f - fraction.y : fraction.y);
    }
  }
};

}  // namespace luxel
