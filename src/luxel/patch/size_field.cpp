// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/size_field.h"

#include <cmath>
#include <cstdint>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"

namespace luxel {
namespace {

constexpr int max_lines = 10;            // in the circle over an edge
constexpr double max_line = 1.0 / 24.0;  // length of a line that counts over max_edge
constexpr double min_edge = 1.0 / 16.0;  // length of an edge that lines may make too long over max_edge
constexpr double flatness = 1e-3;        // distance from a line's plane over max_edge
constexpr double cell_width = 0.25;      // over max_edge

}  // namespace

SizeField::SizeField(double max_edge, std::span<const ContactLine> lines,
                     std::span<const CleanTriangle> triangles, const std::vector<Vec3>& positions)
    : max_edge_(max_edge) {
  if (!(max_edge > 0.0)) return;
  std::vector<PointCells::Point> middles;
  for (const auto& line : lines) {
    if (line.other == none || glm::distance(line.ends[0], line.ends[1]) >= max_line * max_edge) continue;
    const auto& c = triangles[line.on].corners;
    const auto middle = 0.5 * (line.ends[0] + line.ends[1]);
    middles.push_back({middle, static_cast<std::uint32_t>(lines_.size())});
    lines_.push_back({middle, Vec3d(triangle_normal(positions[c[0]], positions[c[1]], positions[c[2]]))});
  }
  if (!lines_.empty()) cells_.emplace(middles, cell_width * max_edge);
}

bool SizeField::is_too_long(const Vec3& a, const Vec3& b) const {
  if (!(max_edge_ > 0.0)) return false;
  const Vec3d from(a), to(b);
  const auto length = glm::distance(from, to);
  return length > max_edge_ || (cells_ && length > min_edge * max_edge_ && has_many_lines(from, to));
}

bool SizeField::has_many_lines(const Vec3d& from, const Vec3d& to) const {
  const auto middle = 0.5 * (from + to);
  const auto radius = 0.5 * glm::distance(from, to);
  int count = 0;
  cells_->for_each_in(middle - radius, middle + radius, [&](std::uint32_t i) {
    if (count > max_lines) return;
    const auto& line = lines_[i];
    const auto is_in_plane = [&](const Vec3d& p) {
      return std::abs(glm::dot(line.normal, p - line.middle)) <= flatness * max_edge_;
    };
    if (glm::distance(middle, line.middle) < radius && is_in_plane(from) && is_in_plane(to)) ++count;
  });
  return count > max_lines;
}

}  // namespace luxel
