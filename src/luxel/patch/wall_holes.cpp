// SPDX-License-Identifier: Apache-2.0
// Holes in flat walls: each plane with several triangles is rasterised; a connected empty region is a hole.
// The edge of the raster counts as closed, so that a door, which the floor closes, is a hole too.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"
#include "luxel/patch/open_polygons.h"

namespace luxel {
namespace {

constexpr double plane_tolerance = 2e-4;  // of the extent: how far apart triangles of one wall may lie
constexpr std::size_t min_triangles = 3;
constexpr std::size_t max_planes = 512;                          // the largest planes only
constexpr std::size_t all_cells = 1 << 23;                       // of all rasters together: about 0.1 s
constexpr std::size_t min_cells = 1 << 12, max_cells = 1 << 18;  // per raster
constexpr double max_layers = 8.0;  // area of a plane's triangles over that of its raster; more: a heap
constexpr std::size_t min_hole_cells = 8;  // per hole
constexpr std::size_t min_width = 3;       // of a hole, cells
constexpr double min_fill = 0.4;           // area of a hole over that of its polygon
constexpr double min_hull = 0.95;          // area of the hull of corners over that of the cells
constexpr std::size_t max_corners = 12;    // a hole with more is replaced by its axis-aligned rectangle

using Flat = std::array<double, 2>;

class Picture {
 public:
  // area: of all members, m².
  Picture(std::span<const Triangle3> triangles, std::span<const std::uint32_t> members, double area,
          std::size_t cells)
      : frame_(frame_of(triangles, members)) {
    for (const auto t : members) {
      auto& flat = triangles_.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        flat[k] = frame_.flat(triangles[t][k]);
        for (std::size_t i = 0; i < 2; ++i) {
          low_[i] = std::min(low_[i], flat[k][i]);
          high_[i] = std::max(high_[i], flat[k][i]);
        }
      }
    }
    const Flat size = {high_[0] - low_[0], high_[1] - low_[1]};
    cell_ = std::sqrt(size[0] * size[1] / static_cast<double>(cells));
    if (!(cell_ > 0.0)) return;
    for (std::size_t i = 0; i < 2; ++i) count_[i] = static_cast<std::size_t>(size[i] / cell_) + 1;
    if (count_[0] * count_[1] > 2 * cells) return;  // a narrow strip
    if (area > max_layers * size[0] * size[1]) return;
    label_.assign(count_[0] * count_[1], none);
    for (const auto& triangle : triangles_) fill(triangle);
  }

  void find_holes(std::vector<OpenPolygon>& found) {
    for (std::size_t i = 0; i < label_.size(); ++i)
      if (label_[i] == none) flood(i);
    if (holes_.empty()) return;
    collect_corners();
    for (auto& hole : holes_)
      if (auto polygon = polygon_of(hole); !polygon.empty()) found.push_back(std::move(polygon));
  }

 private:
  static constexpr std::uint32_t wall = 0xfffffffeu, speck = 0xfffffffdu;

  struct Hole {
    std::array<std::size_t, 2> low{}, high{};  // cells, both included
    std::size_t cells = 0;
    std::vector<Flat> corners;
  };

  double centre(std::size_t axis, std::size_t i) const {
    return low_[axis] + (static_cast<double>(i) + 0.5) * cell_;
  }
  // The first cell whose centre is at x or above.
  std::size_t first_from(std::size_t axis, double x) const {
    const auto at = std::ceil((x - low_[axis]) / cell_ - 0.5);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count_[axis])));
  }

  void fill(const std::array<Flat, 3>& t) {
    const auto slack = 1e-6 * cell_;
    const auto low = std::min({t[0][1], t[1][1], t[2][1]}) - slack;
    const auto high = std::max({t[0][1], t[1][1], t[2][1]}) + slack;
    for (auto row = first_from(1, low); row < count_[1] && centre(1, row) <= high; ++row) {
      const auto y = std::clamp(centre(1, row), low + slack, high - slack);
      auto left = high_[0], right = low_[0];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto &p = t[k], &q = t[(k + 1) % 3];
        if ((p[1] - y) * (q[1] - y) > 0.0) continue;
        const auto x = p[1] == q[1] ? p[0] : p[0] + (q[0] - p[0]) * (y - p[1]) / (q[1] - p[1]);
        left = std::min({left, x, p[1] == q[1] ? q[0] : x});
        right = std::max({right, x, p[1] == q[1] ? q[0] : x});
      }
      for (auto i = first_from(0, left - slack); i < count_[0] && centre(0, i) <= right + slack; ++i)
        label_[row * count_[0] + i] = wall;
    }
  }

  void flood(std::size_t start) {
    const auto label = static_cast<std::uint32_t>(holes_.size());
    Hole hole{{start % count_[0], start / count_[0]}, {start % count_[0], start / count_[0]}, 0, {}};
    std::vector<std::size_t> open = {start};
    label_[start] = label;
    for (; !open.empty(); ++hole.cells) {
      const auto at = open.back();
      open.pop_back();
      const std::array<std::size_t, 2> cell = {at % count_[0], at / count_[0]};
      for (std::size_t i = 0; i < 2; ++i) {
        hole.low[i] = std::min(hole.low[i], cell[i]);
        hole.high[i] = std::max(hole.high[i], cell[i]);
        const auto step = i == 0 ? 1 : count_[0];
        for (const bool up : {false, true}) {
          if (up ? cell[i] + 1 == count_[i] : cell[i] == 0) continue;
          const auto next = up ? at + step : at - step;
          if (label_[next] != none) continue;
          label_[next] = label;
          open.push_back(next);
        }
      }
    }
    if (hole.cells >= min_hole_cells) return holes_.push_back(std::move(hole));
    for (auto row = hole.low[1]; row <= hole.high[1]; ++row)
      for (auto i = hole.low[0]; i <= hole.high[0]; ++i)
        if (label_[row * count_[0] + i] == label) label_[row * count_[0] + i] = speck;
  }

  // Corners of triangles beside a hole are corners of the hole.
  void collect_corners() {
    for (const auto& triangle : triangles_)
      for (const auto& p : triangle) {
        std::array<std::size_t, 2> first{}, last{};
        for (std::size_t i = 0; i < 2; ++i) {
          const auto at = static_cast<std::size_t>((p[i] - low_[i]) / cell_);
          first[i] = at > 0 ? at - 1 : 0;
          last[i] = std::min(at + 1, count_[i] - 1);
        }
        auto seen = none;
        for (auto row = first[1]; row <= last[1]; ++row)
          for (auto i = first[0]; i <= last[0]; ++i)
            if (const auto label = label_[row * count_[0] + i]; label < holes_.size() && label != seen) {
              holes_[label].corners.push_back(p);
              seen = label;
            }
      }
  }

  OpenPolygon polygon_of(Hole& hole) const {
    for (std::size_t i = 0; i < 2; ++i)
      if (hole.high[i] - hole.low[i] + 1 < min_width) return {};
    const auto area = static_cast<double>(hole.cells) * cell_ * cell_;
    auto hull = convex_hull(std::move(hole.corners));
    if (hull.size() < 3 || hull.size() > max_corners || area_of(hull) < min_hull * area) {
      const Flat low = {centre(0, hole.low[0]) - cell_, centre(1, hole.low[1]) - cell_};
      const Flat high = {centre(0, hole.high[0]) + cell_, centre(1, hole.high[1]) + cell_};
      hull = {low, {high[0], low[1]}, high, {low[0], high[1]}};
    }
    if (area < min_fill * area_of(hull)) return {};
    OpenPolygon polygon;
    for (const auto& p : hull) polygon.push_back(frame_.in_space(p));
    return polygon;
  }

  FlatFrame frame_;
  std::vector<std::array<Flat, 3>> triangles_;
  Flat low_ = {1e30, 1e30}, high_ = {-1e30, -1e30};
  double cell_ = 0.0;  // m
  std::array<std::size_t, 2> count_{};
  std::vector<std::uint32_t> label_;  // [row][column]
  std::vector<Hole> holes_;
};

}  // namespace

std::vector<OpenPolygon> find_wall_holes(std::span<const Triangle3> triangles, double extent) {
  auto planes = group_by_plane(triangles, plane_tolerance * extent);
  std::erase_if(planes, [](const auto& plane) { return plane.size() < min_triangles; });
  std::vector<std::pair<double, std::size_t>> by_area;
  for (std::size_t i = 0; i < planes.size(); ++i)
    by_area.emplace_back(-std::accumulate(planes[i].begin(), planes[i].end(), 0.0,
                                          [&](double sum, std::uint32_t t) {
                                            const auto& [a, b, c] = triangles[t];
                                            return sum + triangle_area(a, b, c);
                                          }),
                         i);
  std::sort(by_area.begin(), by_area.end());
  by_area.resize(std::min(by_area.size(), max_planes));
  std::vector<OpenPolygon> holes;
  if (by_area.empty()) return holes;
  const auto cells = std::clamp(all_cells / by_area.size(), min_cells, max_cells);
  for (const auto& [area, i] : by_area) Picture(triangles, planes[i], -area, cells).find_holes(holes);
  return holes;
}

}  // namespace luxel
