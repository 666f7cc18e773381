// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/patch_levels.h"

#include <algorithm>
#include <cmath>

namespace luxel {

std::vector<std::uint8_t> patch_levels(const PatchSet& patches) {
  const auto& triangle = patches.triangle;
  const auto last = triangle.empty() ? 0u : *std::max_element(triangle.begin(), triangle.end());
  std::vector<double> whole(last + std::size_t{1}, 0.0);
  for (std::size_t p = 0; p < patches.size(); ++p) whole[triangle[p]] += static_cast<double>(patches.area[p]);
  std::vector<std::uint8_t> levels(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
    levels[p] = static_cast<std::uint8_t>(
        std::lround(std::max(0.0, std::log2(whole[triangle[p]] / static_cast<double>(patches.area[p])))));
  return levels;
}

std::vector<float> patch_sizes(const PatchSet& patches) {
  std::vector<float> sizes(patches.size(), 0.0f);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto points = patches.points(p);
    for (std::size_t k = 0; k < 3; ++k)
      sizes[p] = std::max(sizes[p], glm::distance(points[k], points[(k + 1) % 3]));
  }
  return sizes;
}

}  // namespace luxel
