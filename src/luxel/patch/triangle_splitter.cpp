// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/triangle_splitter.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/triangle.h"
#include "luxel/patch/flat_triangle.h"
#include "luxel/scene/triangle_shape.h"

namespace luxel {

void TriangleSplitter::add(const std::array<std::uint32_t, 3>& corners, const Vec3& normal,
                           std::uint32_t triangle, MaterialId material, std::span<const ContactLine> lines,
                           std::vector<std::uint32_t> of_triangle) {
  normal_ = normal;
  triangle_ = triangle;
  material_ = material;
  all_lines_ = lines;
  split(corners, of_triangle);
}

// Returns the squared length of an edge that is too long, 0 of others.
double TriangleSplitter::excess2(std::uint32_t i, std::uint32_t j) const {
  const auto& p = weld_.positions();
  if (!sizes_.is_too_long(p[i], p[j])) return 0.0;
  const auto d = Vec3d(p[i]) - Vec3d(p[j]);
  return glm::dot(d, d);
}

void TriangleSplitter::split(const std::array<std::uint32_t, 3>& c, const std::vector<std::uint32_t>& lines) {
  const std::array<double, 3> edge2 = {excess2(c[0], c[1]), excess2(c[1], c[2]), excess2(c[2], c[0])};
  const auto k = static_cast<std::size_t>(std::max_element(edge2.begin(), edge2.end()) - edge2.begin());
  const auto i = c[k];
  const auto j = c[(k + 1) % 3];
  const auto apex = c[(k + 2) % 3];
  if (edge2[k] == 0.0) return append(c, lines);
  // a + b equals b + a exactly: both neighbours of the edge compute the same point.
  const auto& p = weld_.positions();
  const auto place = 0.5f * (p[i] + p[j]);
  if (!has_area(p[i], place, p[apex]) || !has_area(place, p[j], p[apex]))
    return append(c, lines);  // halves would have no area in floats
  const auto middle = weld_.index_of(place);
  for (const auto& half : {std::array{i, middle, apex}, std::array{middle, j, apex}})
    split(half, near(half, lines));
}

// Returns the lines that lie over the part or along its boundary.
std::vector<std::uint32_t> TriangleSplitter::near(const std::array<std::uint32_t, 3>& c,
                                                  const std::vector<std::uint32_t>& lines) const {
  if (lines.empty()) return {};
  const auto& p = weld_.positions();
  const std::array points{p[c[0]], p[c[1]], p[c[2]]};
  const FlatTriangle part(points, Vec3d(normal_));
  const auto slack = slack_roundings * coordinate_rounding(points);
  std::vector<std::uint32_t> result;
  for (const auto line : lines)
    if (interval_over(part, all_lines_[line].ends[0], all_lines_[line].ends[1], slack))
      result.push_back(line);
  return result;
}

void TriangleSplitter::append(const std::array<std::uint32_t, 3>& c,
                              const std::vector<std::uint32_t>& lines) {
  if (patches_.size() >= max_count_)
    throw with_hints(InputError(fmt::format("more than {} patches: a longer edge is needed", max_count_)),
                     {{Setting::max_edge}});
  const auto& p = weld_.positions();
  for (const auto line : lines)
    lines_on_patches_.push_back({static_cast<std::uint32_t>(patches_.size()), line});
  patches_.corners.push_back(c);
  patches_.normal.push_back(normal_);
  patches_.area.push_back(static_cast<float>(triangle_area(p[c[0]], p[c[1]], p[c[2]])));
  patches_.material.push_back(material_);
  patches_.triangle.push_back(triangle_);
}

}  // namespace luxel
