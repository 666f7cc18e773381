// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/mapped_surfaces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "luxel/core/barycentric.h"
#include "luxel/core/none.h"
#include "luxel/export/surface_maker.h"
#include "luxel/patch/side.h"
#include "luxel/surface/cut_along_edges.h"

namespace luxel {
namespace {

// Corners of the triangle on a chart that contains all of it, extrapolated from its largest patch, as charts
// are flat.
std::array<Vec2, 3> whole_uv(const RoundTripScene& round_trip, std::uint32_t triangle, bool back,
                             const Atlas& atlas) {
  const auto& area = round_trip.patches.area;
  const auto begin = round_trip.of_triangles.begin(triangle), end = round_trip.of_triangles.end(triangle);
  auto largest = begin;
  for (auto p = begin; p < end; ++p)
    if (area[p] > area[largest]) largest = p;
  const SideId side(largest, back);
  const auto points = round_trip.patches.points(largest);
  std::array<Vec2, 3> uv{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto w = barycentric(points, round_trip.scene.positions[round_trip.scene.triangles[triangle][i]]);
    for (std::size_t k = 0; k < 3; ++k)
      uv[i] += static_cast<float>(w[static_cast<int>(k)]) * atlas.uv(side, k);
  }
  return uv;
}

// Surfaces by side and page, in the order of first use.
class PagedSurfaces {
 public:
  PagedSurfaces(const RoundTripScene& round_trip, const RoundTripPart& part, const Atlas& atlas,
                const PageCuts& cuts)
      : round_trip_(round_trip), part_(part), atlas_(atlas), cuts_(cuts) {}

  void add(std::size_t i, bool back) {
    const auto t = part_.triangles[i];
    const auto begin = round_trip_.of_triangles.begin(t), end = round_trip_.of_triangles.end(t);
    if (begin == end) return;
    if (cuts_.is_cut(t))
      for (auto p = begin; p < end; ++p) add_patch(i, p, back);
    else if (const auto chart = atlas_.chart_of[SideId(begin, back).index()]; chart != none)
      add_whole(i, chart, back);
  }

  std::vector<RoundTripSurface> finish() { return filled(std::move(makers_)); }

 private:
  // A border point of a triangle that is not cut.
  struct OnBorder {
    DrawnCorner corner;
    BorderPoint point;
    Vec2 uv{0.0f};
  };

  // The triangle's corners, and between them the points that its neighbours have.
  std::vector<OnBorder> border_of(std::size_t i, std::size_t back) const {
    const auto t = part_.triangles[i];
    std::array<std::map<double, std::uint32_t>, 3> between;  // [edge][fraction of its length]
    for (auto p = round_trip_.of_triangles.begin(t); p < round_trip_.of_triangles.end(t); ++p)
      for (const auto point : round_trip_.patches.corners[p])
        if (cuts_.is_drawn(point))
          if (const auto place = place_on_edge(round_trip_, t, point))
            between[place->edge][place->fraction] = point;
    const auto own = own_corners(part_, i);
    const auto uv = whole_uv(round_trip_, t, back, atlas_);
    const auto& of_scene = round_trip_.scene.triangles[t];
    std::vector<OnBorder> border;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto next = (k + 1) % 3, before = (k + 2) % 3;
      border.push_back(
          {own[k], {Vec3d(round_trip_.scene.positions[of_scene[k]]), 1u << k | 1u << before}, uv[k]});
      for (const auto& [fraction, point] : between[k])
        border.push_back({corner_of(round_trip_, part_, i, point),
                          {Vec3d(round_trip_.patches.vertices[point]), 1u << k},
                          uv[k] + static_cast<float>(fraction) * (uv[next] - uv[k])});
    }
    return border;
  }

  void add_whole(std::size_t i, std::uint32_t chart, std::size_t back) {
    const auto border = border_of(i, back);
    std::vector<BorderPoint> points;
    for (const auto& on : border) points.push_back(on.point);
    for (const auto& [a, b, c] : cut_along_edges(points))
      add({border[a].corner, border[b].corner, border[c].corner}, {border[a].uv, border[b].uv, border[c].uv},
          chart, back);
  }

  void add_patch(std::size_t i, std::uint32_t patch, bool back) {
    const SideId side(patch, back);
    if (!atlas_.has(side)) return;
    add(corners_of_patch(round_trip_, part_, i, patch),
        {atlas_.uv(side, 0), atlas_.uv(side, 1), atlas_.uv(side, 2)}, atlas_.chart_of[side.index()], back);
  }

  void add(std::array<DrawnCorner, 3> corners, const std::array<Vec2, 3>& uv, std::uint32_t chart,
           std::size_t back) {
    for (std::size_t c = 0; c < 3; ++c) {
      corners[c].light = chart;
      corners[c].uv = uv[c];
    }
    const auto page = atlas_.places[chart].page;
    const auto [found, is_new] = number_of_.try_emplace({back, page}, makers_.size());
    if (is_new) makers_.emplace_back(part_, back == 1, page);
    makers_[found->second].add(corners);
  }

  const RoundTripScene& round_trip_;
  const RoundTripPart& part_;
  const Atlas& atlas_;
  const PageCuts& cuts_;
  std::vector<SurfaceMaker> makers_;
  std::map<std::pair<std::size_t, std::uint32_t>, std::size_t> number_of_;
};

}  // namespace

PageCuts::PageCuts(const RoundTripScene& round_trip, const Atlas& atlas)
    : is_cut_(round_trip.scene.triangles.size(), false),
      is_drawn_(round_trip.patches.vertices.size(), false) {
  for (std::uint32_t t = 0; t < is_cut_.size(); ++t) {
    const auto begin = round_trip.of_triangles.begin(t), end = round_trip.of_triangles.end(t);
    for (auto p = begin; p < end; ++p)
      for (const bool back : {false, true})
        if (atlas.chart_of[SideId(p, back).index()] != atlas.chart_of[SideId(begin, back).index()])
          is_cut_[t] = true;
    if (!is_cut_[t]) continue;
    for (auto p = begin; p < end; ++p)
      for (const auto point : round_trip.patches.corners[p]) is_drawn_[point] = true;
  }
}

std::vector<RoundTripSurface> mapped_surfaces(const RoundTripScene& round_trip, const RoundTripPart& part,
                                              const Atlas& atlas, const PageCuts& cuts) {
  PagedSurfaces surfaces(round_trip, part, atlas, cuts);
  for (std::size_t i = 0; i < part.triangles.size(); ++i)
    for (const std::size_t back : {0, 1}) surfaces.add(i, back);
  return surfaces.finish();
}

}  // namespace luxel
