// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/back_gap.h"

#include <vector>

#include "luxel/core/bounds.h"

namespace luxel {

float back_gap(const PatchSet& patches, TargetApplication program) {
  constexpr float of_diagonal = 5e-5f;
  if (!profile_of(program).shows_both_faces) return 0.0f;
  Bounds box;
  for (const auto& p : patches.vertices) box.add(p);
  return of_diagonal * glm::length(box.size());
}

void move_outwards(std::span<Vec3> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
                   float distance) {
  std::vector<Vec3> normal(positions.size(), Vec3(0.0f));
  for (const auto& t : triangles) {
    const auto across = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    for (const auto corner : t) normal[corner] += across;
  }
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (const auto length = glm::length(normal[i]); length > 0.0f)
      positions[i] += distance / length * normal[i];
}

}  // namespace luxel
