// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/mapped_surfaces.h"

#include <map>
#include <utility>

#include "luxel/export/surface_maker.h"
#include "luxel/math/barycentric.h"

namespace luxel {
namespace {

// Where the triangle's corners come to lie on a chart that has all of it: what its largest patch says, for
// charts are flat.
std::array<Vec2, 3> whole_uv(const KeptScene& kept, std::uint32_t triangle, std::size_t side_of_first,
                             const Atlas& atlas) {
  const auto& area = kept.patches.area;
  const auto begin = kept.of_triangles.begin(triangle), end = kept.of_triangles.end(triangle);
  auto largest = begin;
  for (auto p = begin; p < end; ++p)
    if (area[p] > area[largest]) largest = p;
  const auto side = 2 * std::size_t{largest} + side_of_first;
  const auto points = kept.patches.points(largest);
  std::array<Vec2, 3> uv{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto w = barycentric(points, kept.scene.positions[kept.scene.triangles[triangle][i]]);
    for (std::size_t k = 0; k < 3; ++k)
      uv[i] += static_cast<float>(w[static_cast<int>(k)]) * atlas.uv(side, k);
  }
  return uv;
}

// Surfaces by side and page, in the order in which they are first wanted.
class PagedSurfaces {
 public:
  PagedSurfaces(const KeptScene& kept, const KeptPart& part, const Atlas& atlas)
      : kept_(kept), part_(part), atlas_(atlas) {}

  void add(std::size_t i, std::size_t back) {
    const auto t = part_.triangles[i];
    const auto begin = kept_.of_triangles.begin(t), end = kept_.of_triangles.end(t);
    if (begin == end) return;
    const auto first = chart_of(begin, back);
    bool whole = true;
    for (auto p = begin; p < end; ++p) whole = whole && chart_of(p, back) == first;
    if (!whole) {
      for (auto p = begin; p < end; ++p) add_patch(i, p, back);
    } else if (first != Charts::none) {
      add(own_corners(part_, i), whole_uv(kept_, t, back, atlas_), first, back);
    }
  }

  std::vector<KeptSurface> finish() { return filled(std::move(makers_)); }

 private:
  std::uint32_t chart_of(std::uint32_t patch, std::size_t back) const {
    return atlas_.chart_of[2 * std::size_t{patch} + back];
  }

  void add_patch(std::size_t i, std::uint32_t patch, std::size_t back) {
    const auto side = 2 * std::size_t{patch} + back;
    if (!atlas_.has(side)) return;
    add(corners_of_patch(kept_, part_, i, patch),
        {atlas_.uv(side, 0), atlas_.uv(side, 1), atlas_.uv(side, 2)}, atlas_.chart_of[side], back);
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

  const KeptScene& kept_;
  const KeptPart& part_;
  const Atlas& atlas_;
  std::vector<SurfaceMaker> makers_;
  std::map<std::pair<std::size_t, std::uint32_t>, std::size_t> number_of_;
};

}  // namespace

std::vector<KeptSurface> mapped_surfaces(const KeptScene& kept, const KeptPart& part, const Atlas& atlas) {
  PagedSurfaces surfaces(kept, part, atlas);
  for (std::size_t i = 0; i < part.triangles.size(); ++i)
    for (const std::size_t back : {0, 1}) surfaces.add(i, back);
  return surfaces.finish();
}

}  // namespace luxel
