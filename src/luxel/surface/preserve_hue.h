// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace luxel {

// Estimates of single bands may fall below zero where there is little light, and cutting them there leaves
// specks of pure colour. Instead a receiver with a band below zero moves towards the colour of its unit (the
// mean by area of some neighbours) at its own brightness, until no band is below a quarter of what that
// colour would have. Then the bands of the whole unit are scaled, so that its mean of each band does not
// change.
//
// mean: [receiver * bands + band], W/m², is changed. area: [receiver], m². begins: of units, [unit], and the
// end. Units without a band below zero are not touched; what is below zero in a unit whose mean is not above
// it becomes 0.
void preserve_hue(std::span<float> mean, std::size_t bands, std::span<const float> area,
                  std::span<const std::uint32_t> begins);

}  // namespace luxel
