// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/core/context.h"
#include "luxel/core/vector.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/patch/triangle_pairs.h"

namespace luxel {

// The order of contact lines: by the triangle that they lie on, then by the one that causes them.
inline bool comes_before(const ContactLine& a, const ContactLine& b) {
  return std::tuple(a.on, a.other) < std::tuple(b.on, b.other);
}

// The lines that meet(i, j, lines) adds for each pair of triangles whose boxes overlap, in the order above.
// The same for any number of threads, if all lines of one (on, other) come from one pair. meet: thread-safe.
// Throws InputError where there are more lines than `most`.
template <typename Meet>
std::vector<ContactLine> lines_of_pairs(std::span<const Bounds> boxes, std::size_t most,
                                        const Context& context, const Meet& meet) {
  const OverlappingPairs pairs(boxes, context);
  std::vector<std::vector<ContactLine>> of_part(pairs.parts());
  std::atomic<std::size_t> count = 0;
  context.for_chunks(pairs.parts(), 1, [&](std::size_t part, std::size_t, int) {
    auto& lines = of_part[part];
    pairs.for_pairs(part, [&](std::uint32_t i, std::uint32_t j) {
      const auto before = lines.size();
      meet(i, j, lines);
      if (lines.size() != before && (count += lines.size() - before) > most) refuse_contacts(most);
    });
  });
  std::vector<ContactLine> lines;
  for (const auto& some : of_part) lines.insert(lines.end(), some.begin(), some.end());
  std::stable_sort(lines.begin(), lines.end(), comes_before);
  return lines;
}

// The direction from the line through two vertices to a third one, at right angles to the line; unit.
inline Vec3d away_from_edge(const std::vector<Vec3>& positions, std::uint32_t a, std::uint32_t b,
                            std::uint32_t vertex) {
  const Vec3d origin(positions[a]);
  const auto along = glm::normalize(Vec3d(positions[b]) - origin);
  const auto d = Vec3d(positions[vertex]) - origin;
  return glm::normalize(d - glm::dot(d, along) * along);
}

}  // namespace luxel
