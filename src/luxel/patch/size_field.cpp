// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/size_field.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"

namespace luxel {
namespace {

constexpr int max_lines = 10;            // in the circle over an edge
constexpr double max_line = 1.0 / 24.0;  // length of a line that counts over max_edge
constexpr double min_edge = 1.0 / 16.0;  // length of an edge that lines may make too long over max_edge
constexpr double flatness = 1e-3;        // distance from a line's plane over max_edge
constexpr double cell_width = 0.25;      // over max_edge

using Cell = glm::i64vec3;

Cell cell_of(const Vec3d& place, double max_edge) {
  return Cell(glm::floor(place / (cell_width * max_edge)));
}

// Cells far apart may have one key: each line's distance is tested anyway.
std::uint64_t key(const Cell& cell) {
  constexpr int bits = 21;
  constexpr auto mask = (std::uint64_t{1} << bits) - 1;
  const auto low = [](std::int64_t step) { return static_cast<std::uint64_t>(step) & mask; };
  return low(cell.x) << (2 * bits) | low(cell.y) << bits | low(cell.z);
}

}  // namespace

SizeField::SizeField(double max_edge, std::span<const ContactLine> lines,
                     std::span<const CleanTriangle> triangles, const std::vector<Vec3>& positions)
    : max_edge_(max_edge) {
  if (!(max_edge > 0.0)) return;
  for (const auto& line : lines) {
    if (line.other == none || glm::distance(line.ends[0], line.ends[1]) >= max_line * max_edge) continue;
    const auto& c = triangles[line.on].corners;
    const auto middle = 0.5 * (line.ends[0] + line.ends[1]);
    lines_[key(cell_of(middle, max_edge))].push_back(
        {middle, Vec3d(triangle_normal(positions[c[0]], positions[c[1]], positions[c[2]]))});
  }
}

bool SizeField::is_too_long(const Vec3& a, const Vec3& b) const {
  if (!(max_edge_ > 0.0)) return false;
  const Vec3d from(a), to(b);
  const auto length = glm::distance(from, to);
  return length > max_edge_ || (!lines_.empty() && length > min_edge * max_edge_ && has_many_lines(from, to));
}

bool SizeField::has_many_lines(const Vec3d& from, const Vec3d& to) const {
  const auto middle = 0.5 * (from + to);
  const auto radius = 0.5 * glm::distance(from, to);
  int count = 0;
  const auto count_in = [&](const Cell& cell) {
    const auto found = lines_.find(key(cell));
    if (found == lines_.end()) return;
    for (const auto& line : found->second) {
      const auto is_in_plane = [&](const Vec3d& p) {
        return std::abs(glm::dot(line.normal, p - line.middle)) <= flatness * max_edge_;
      };
      if (glm::distance(middle, line.middle) < radius && is_in_plane(from) && is_in_plane(to)) ++count;
    }
  };
  const auto first = cell_of(middle - radius, max_edge_);
  const auto last = cell_of(middle + radius, max_edge_);
  for (auto x = first.x; x <= last.x; ++x)
    for (auto y = first.y; y <= last.y; ++y)
      for (auto z = first.z; z <= last.z && count <= max_lines; ++z) count_in({x, y, z});
  return count > max_lines;
}

}  // namespace luxel
