// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/flat_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "luxel/core/cross.h"

namespace luxel {
namespace {

using Point = glm::dvec2;

constexpr double rounding = 1e-5;  // of the box

// Returns whether an edge of a has all of b beyond it, within the tolerance.
bool has_edge_between(const FlatCover::Triangle& a, const FlatCover::Triangle& b, double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto edge = a[(k + 1) % 3] - a[k];
    double reach = -std::numeric_limits<double>::infinity();
    for (const auto& p : b) reach = std::max(reach, cross(edge, p - a[k]));
    if (reach <= tolerance * glm::length(edge)) return true;
  }
  return false;
}

bool is_inside(const FlatCover::Triangle& t, const Point& p) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(cross(t[(k + 1) % 3] - t[k], p - t[k]) >= 0.0)) return false;
  return true;
}

}  // namespace

FlatCover::FlatCover(const Point& low, const Point& high, std::size_t count) : low_(low) {
  constexpr double max_cells = 1000.0;  // along a side
  const auto size = high - low;
  const auto longest = std::max(size.x, size.y);
  tolerance_ = rounding * longest;
  const auto even = std::sqrt(size.x * size.y / static_cast<double>(std::max<std::size_t>(1, count)));
  if (longest > 0.0) cell_ = std::max(even, longest / max_cells);
  width_ = cell_of(size.x) + 1;
  height_ = cell_of(size.y) + 1;
  cells_.resize(width_ * height_);
}

std::size_t FlatCover::cell_of(double x) const { return static_cast<std::size_t>(std::max(0.0, x) / cell_); }

Box<Point> FlatCover::box_of(const Triangle& t) {
  Box<Point> box;
  for (const auto& p : t) box.add(p);
  return box;
}

template <typename Body>
void FlatCover::for_cells(const Box<Point>& box, const Body& body) {
  const auto low = box.low - low_, high = box.high - low_;
  for (auto y = cell_of(low.y); y <= std::min(cell_of(high.y), height_ - 1); ++y)
    for (auto x = cell_of(low.x); x <= std::min(cell_of(high.x), width_ - 1); ++x)
      body(cells_[y * width_ + x]);
}

bool FlatCover::add(const Triangle& t) {
  const auto box = box_of(t);
  const auto is_apart = [&](std::uint32_t i) {
    const auto& other = boxes_[i];
    return box.high.x <= other.low.x || box.high.y <= other.low.y || other.high.x <= box.low.x ||
           other.high.y <= box.low.y || has_edge_between(t, triangles_[i], tolerance_) ||
           has_edge_between(triangles_[i], t, tolerance_);
  };
  bool is_free = true;
  for_cells(box, [&](const auto& cell) {
    for (const auto i : cell) is_free = is_free && is_apart(i);
  });
  if (is_free) put(t, box);
  return is_free;
}

void FlatCover::put(const Triangle& t) { put(t, box_of(t)); }

void FlatCover::put(const Triangle& t, const Box<Point>& box) {
  for_cells(box, [&](auto& cell) { cell.push_back(static_cast<std::uint32_t>(triangles_.size())); });
  triangles_.push_back(t);
  boxes_.push_back(box);
}

std::uint32_t FlatCover::at(const Point& place) const {
  const auto from_low = place - low_;
  if (!(from_low.x >= 0.0 && from_low.y >= 0.0) || cell_of(from_low.x) >= width_ ||
      cell_of(from_low.y) >= height_)
    return none;
  const auto& cell = cells_[cell_of(from_low.y) * width_ + cell_of(from_low.x)];
  const auto found =
      std::find_if(cell.begin(), cell.end(), [&](auto i) { return is_inside(triangles_[i], place); });
  return found == cell.end() ? none : *found;
}

}  // namespace luxel
