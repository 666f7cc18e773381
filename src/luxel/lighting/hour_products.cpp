// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/hour_products.h"

#include <algorithm>
#include <array>

namespace luxel {
namespace {

constexpr std::size_t tile = PackedColumns::tile;
constexpr std::size_t hours_per_chunk = 32;
constexpr std::size_t hours_at_once = 4;

// The sums of one tile for some hours: their number is a compile-time constant, so that they stay in
// registers.
template <std::size_t Hours>
std::array<std::array<float, tile>, Hours> sums_of(const float* sky, const float* column,
                                                   std::size_t patches) {
  std::array<std::array<float, tile>, Hours> sums{};
  for (std::size_t p = 0; p < patches; ++p, column += tile)
    for (std::size_t h = 0; h < Hours; ++h)
      for (std::size_t i = 0; i < tile; ++i) sums[h][i] += sky[h * patches + p] * column[i];
  return sums;
}

}  // namespace

PackedColumns::PackedColumns(std::size_t sky_patches, std::size_t points)
    : sky_patches_(sky_patches),
      points_(points),
      values_((points + tile - 1) / tile * tile * sky_patches, 0.0f) {}

void PackedColumns::times_hours(const float* sky, std::size_t hours, float* light) const {
  for (std::size_t first = 0; first < points_; first += tile) {
    const auto* column = &values_[first * sky_patches_];
    const auto count = std::min(tile, points_ - first);
    std::size_t h = 0;
    const auto put = [&](const auto& sums) {
      for (const auto& sum : sums) std::copy_n(sum.begin(), count, &light[h++ * points_ + first]);
    };
    while (h + hours_at_once <= hours)
      put(sums_of<hours_at_once>(&sky[h * sky_patches_], column, sky_patches_));
    while (h < hours) put(sums_of<1>(&sky[h * sky_patches_], column, sky_patches_));
  }
}

std::vector<float> PackedColumns::times(std::span<const float> sky, const Context& context) const {
  const auto hours = sky_patches_ > 0 ? sky.size() / sky_patches_ : 0;
  std::vector<float> light(hours * points_);
  context.for_chunks(hours, hours_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    times_hours(&sky[begin * sky_patches_], end - begin, &light[begin * points_]);
  });
  return light;
}

}  // namespace luxel
