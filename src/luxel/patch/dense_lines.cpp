// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/dense_lines.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <unordered_set>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"

namespace luxel {
namespace {

constexpr double patches_per_crossing = 2.0;  // triangles about a point more in a triangulation

// Where lines must be left out, most are of a tangle: patches that the others may add, over the limit.
constexpr double sparse_part = 0.25;

struct CutTriangle {
  std::uint32_t triangle = 0;
  double density = 0.0;  // 1/m
  double added = 0.0;    // patches expected
};

// The triangles with contact lines, in their order.
std::vector<CutTriangle> cut_triangles(const std::vector<ContactLine>& lines,
                                       const std::vector<CleanTriangle>& triangles,
                                       const std::vector<Vec3>& positions, double max_edge) {
  std::vector<CutTriangle> result;
  for (auto line = lines.begin(); line != lines.end();) {
    const auto on = line->on;
    double count = 0.0, length = 0.0;
    for (; line != lines.end() && line->on == on; ++line) {
      if (line->other == none) continue;
      count += 1.0;
      length += glm::distance(line->ends[0], line->ends[1]);
    }
    if (count == 0.0) continue;
    const auto& c = triangles[on].corners;
    const auto area = triangle_area(positions[c[0]], positions[c[1]], positions[c[2]]);
    const auto edges_crossed = max_edge > 0.0 ? length / max_edge : 0.0;
    const auto crossings = std::min(length * length / (std::numbers::pi * area), 0.5 * count * (count - 1.0));
    result.push_back({on, length / area, patches_per_crossing * (count + edges_crossed + crossings)});
  }
  return result;
}

}  // namespace

std::size_t leave_out_dense_lines(std::vector<ContactLine>& lines,
                                  const std::vector<CleanTriangle>& triangles,
                                  const std::vector<Vec3>& positions, double max_edge, double max_added) {
  auto cut = cut_triangles(lines, triangles, positions, max_edge);
  std::stable_sort(cut.begin(), cut.end(),
                   [](const CutTriangle& a, const CutTriangle& b) { return a.density < b.density; });
  const auto expected = std::accumulate(cut.begin(), cut.end(), 0.0,
                                        [](double sum, const CutTriangle& t) { return sum + t.added; });
  if (expected <= max_added) return 0;
  double added = 0.0;
  auto kept = cut.begin();
  while (kept != cut.end()) {
    const auto next = std::find_if(
        kept, cut.end(), [density = kept->density](const CutTriangle& t) { return t.density > density; });
    for (auto t = kept; t != next; ++t) added += t->added;
    if (added > sparse_part * max_added) break;
    kept = next;
  }
  std::unordered_set<std::uint32_t> whole;
  for (auto t = kept; t != cut.end(); ++t) whole.insert(t->triangle);
  std::erase_if(lines,
                [&](const ContactLine& line) { return line.other != none && whole.contains(line.on); });
  return whole.size();
}

}  // namespace luxel
