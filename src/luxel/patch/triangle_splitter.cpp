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
namespace {

constexpr double needle2 = 1.0 / 16.0;  // square of the shortest edge of a needle over that of its longest
constexpr double slice2 = 2.25;  // of a slice's length over that of the needle's shortest edge, at most

double length2(const Vec3& a, const Vec3& b) {
  const auto d = Vec3d(a) - Vec3d(b);
  return glm::dot(d, d);
}

// a + b equals b + a exactly: both neighbours of an edge compute the same point.
Vec3 middle_of(const Vec3& a, const Vec3& b) { return 0.5f * (a + b); }

}  // namespace

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
  return sizes_.is_too_long(p[i], p[j]) ? length2(p[i], p[j]) : 0.0;
}

void TriangleSplitter::split(const std::array<std::uint32_t, 3>& c, const std::vector<std::uint32_t>& lines) {
  const std::array<double, 3> edge2 = {excess2(c[0], c[1]), excess2(c[1], c[2]), excess2(c[2], c[0])};
  const auto k = static_cast<std::size_t>(std::max_element(edge2.begin(), edge2.end()) - edge2.begin());
  const auto i = c[k];
  const auto j = c[(k + 1) % 3];
  const auto apex = c[(k + 2) % 3];
  if (edge2[k] == 0.0) return append(c, lines);
  if (const auto parts = slices(c); !parts.empty()) {
    for (const auto& part : parts) split(part, near(part, lines));
    return;
  }
  const auto& p = weld_.positions();
  const auto place = middle_of(p[i], p[j]);
  if (!has_area(p[i], place, p[apex]) || !has_area(place, p[j], p[apex]))
    return append(c, lines);  // halves would have no area in floats
  const auto middle = weld_.index_of(place);
  for (const auto& half : {std::array{i, middle, apex}, std::array{middle, j, apex}})
    split(half, near(half, lines));
}

std::vector<std::array<std::uint32_t, 3>> TriangleSplitter::slices(const std::array<std::uint32_t, 3>& c) {
  const auto edge2 = [&](std::uint32_t i, std::uint32_t j) {
    return length2(weld_.positions()[i], weld_.positions()[j]);
  };
  std::size_t tip = 0;  // opposite the shortest edge
  for (const std::size_t k : {1u, 2u})
    if (edge2(c[(k + 1) % 3], c[(k + 2) % 3]) < edge2(c[(tip + 1) % 3], c[(tip + 2) % 3])) tip = k;
  const auto a = c[tip], b = c[(tip + 1) % 3], d = c[(tip + 2) % 3];
  const auto shortest2 = edge2(b, d);
  if (!(shortest2 < needle2 * std::max(edge2(a, b), edge2(a, d))) || excess2(a, b) == 0.0 ||
      excess2(a, d) == 0.0)
    return {};
  std::vector<std::uint32_t> right{a}, left{a};
  add_halving_points(a, b, slice2 * shortest2, right);
  add_halving_points(a, d, slice2 * shortest2, left);
  std::vector<std::array<std::uint32_t, 3>> parts;
  for (std::size_t r = 0, l = 0; r + 1 < right.size() || l + 1 < left.size();) {
    const bool is_right = l + 1 == left.size() || (r + 1 < right.size() && edge2(right[r + 1], left[l]) <=
                                                                               edge2(right[r], left[l + 1]));
    const auto next = is_right ? right[++r] : left[++l];
    if (r + l == 1) continue;  // the part at the tip needs the next point too
    parts.push_back(is_right ? std::array{right[r - 1], next, left[l]}
                             : std::array{right[r], next, left[l - 1]});
  }
  const auto& p = weld_.positions();
  const auto is_flat = [&](const auto& t) { return !has_area(p[t[0]], p[t[1]], p[t[2]]); };
  return std::any_of(parts.begin(), parts.end(), is_flat) ? std::vector<std::array<std::uint32_t, 3>>{}
                                                          : parts;
}

void TriangleSplitter::add_halving_points(std::uint32_t a, std::uint32_t b, double shortest2,
                                          std::vector<std::uint32_t>& points) {
  if (excess2(a, b) > shortest2) {
    const auto middle = weld_.index_of(middle_of(weld_.positions()[a], weld_.positions()[b]));
    add_halving_points(a, middle, shortest2, points);
    add_halving_points(middle, b, shortest2, points);
  } else {
    points.push_back(b);
  }
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
