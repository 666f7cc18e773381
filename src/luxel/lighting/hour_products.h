// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "luxel/core/context.h"

namespace luxel {

// Coefficients of points, packed for products with the skies of many hours: [tile of points][sky patch][point
// of the tile], so that a tile is read once, in order, and the sums of some hours stay in registers.
class PackedColumns {
 public:
  static constexpr std::size_t tile = 8;  // points

  PackedColumns(std::size_t sky_patches, std::size_t points);

  float& at(std::size_t sky_patch, std::size_t point) {
    return values_[(point / tile * sky_patches_ + sky_patch) * tile + point % tile];
  }
  float at(std::size_t sky_patch, std::size_t point) const {
    return values_[(point / tile * sky_patches_ + sky_patch) * tile + point % tile];
  }
  std::size_t sky_patches() const { return sky_patches_; }
  std::size_t points() const { return points_; }

  // Sums over the patches of sky, [hour * sky patches + sky patch], times coefficient: [hour * points +
  // point]. In the order of the patches, so the same bits on any number of threads. Cost: 0.2 ns per hour,
  // point and patch on one thread.
  std::vector<float> times(std::span<const float> sky, const Context& context) const;

 private:
  void times_hours(const float* sky, std::size_t hours, float* light) const;

  std::size_t sky_patches_, points_;
  std::vector<float> values_;
};

}  // namespace luxel
