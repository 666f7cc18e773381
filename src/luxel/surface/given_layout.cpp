// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/given_layout.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "luxel/core/barycentric.h"
#include "luxel/core/cross.h"
#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/core/triangle.h"
#include "luxel/core/trig.h"
#include "luxel/patch/side.h"
#include "luxel/surface/side_nodes.h"

namespace luxel {
namespace {

using Point = glm::dvec2;

void check(const Scene& scene, const PatchSet& patches, const GivenLayout& given) {
  const auto triangles = scene.triangles.size();
  if (given.uvs.size() != triangles || given.page.size() != triangles)
    throw MismatchError(fmt::format("the layout has {} triangles but {} has {}: take that of this scene",
                                    given.uvs.size(), scene.source, triangles));
  for (const auto t : patches.triangle)
    if (t >= triangles) throw MismatchError(fmt::format("the patches are not of {}", scene.source));
}

double uv_area(const std::array<Vec2, 3>& uv) {
  const auto b = Point(uv[1]) - Point(uv[0]), c = Point(uv[2]) - Point(uv[0]);
  return 0.5 * std::abs(cross(b, c));
}

// Calls visit for each texel whose middle lies well inside the triangle.
template <typename Visit>
void for_texels_inside(const std::array<Vec2, 3>& uv, int size, const Visit& visit) {
  constexpr double well = 1e-3;  // of the triangle's height, as neighbours share their edges
  std::array<Point, 3> t;
  for (std::size_t k = 0; k < 3; ++k) t[k] = static_cast<double>(size) * Point(uv[k]) - 0.5;
  const auto b = t[1] - t[0], c = t[2] - t[0];
  const auto area = cross(b, c);
  if (area == 0.0) return;
  const auto low = glm::ceil(glm::min(glm::min(t[0], t[1]), t[2]));
  const auto high = glm::floor(glm::max(glm::max(t[0], t[1]), t[2]));
  for (auto y = std::max(0, static_cast<int>(low.y)); y <= std::min(size - 1, static_cast<int>(high.y)); ++y)
    for (auto x = std::max(0, static_cast<int>(low.x)); x <= std::min(size - 1, static_cast<int>(high.x));
         ++x) {
      const auto p = Point(x, y) - t[0];
      const auto v = cross(p, c) / area, w = cross(b, p) / area;
      if (v > well && w > well && v + w < 1.0 - well)
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x));
    }
}

}  // namespace

bool overlaps(const Scene& scene, const PatchSet& patches, const GivenLayout& given, int page_size) {
  check(scene, patches, given);
  constexpr double tolerated = 1e-3;
  std::vector<bool> counts(scene.triangles.size(), false);
  for (const auto t : patches.triangle) counts[t] = true;
  const auto per_page = static_cast<std::size_t>(page_size) * static_cast<std::size_t>(page_size);
  std::vector<bool> taken(per_page * given.pages, false);
  std::size_t all = 0, twice = 0;
  for (std::size_t t = 0; t < counts.size(); ++t) {
    if (!counts[t]) continue;
    for_texels_inside(given.uvs[t], page_size, [&](std::size_t texel) {
      const auto at = given.page[t] * per_page + texel;
      ++all;
      if (taken[at]) ++twice;
      taken[at] = true;
    });
    // The remaining triangles cannot lower the result: they claim at most every texel once.
    if (static_cast<double>(twice) > tolerated * static_cast<double>(twice + taken.size())) return true;
  }
  return static_cast<double>(twice) > tolerated * static_cast<double>(all);
}

LaidOut lay_out(const Scene& scene, const PatchSet& patches, const GivenLayout& given,
                const GivenPageOptions& options, const Context& context) {
  assert(options.page_size > 0 && options.margin >= 0);
  const auto page_size = options.page_size;
  check(scene, patches, given);
  LaidOut laid;
  laid.charts.edges =
      find_side_edges(patches, make_side_nodes(patches, cosine_of_degrees(options.crease_angle), context));
  laid.charts.charts.resize(given.pages);
  laid.charts.of_side.assign(side_count(patches.size()), none);

  auto& atlas = laid.atlas;
  atlas.page_size = page_size;
  atlas.pages = static_cast<int>(given.pages);
  atlas.margin = options.margin;
  for (std::uint32_t p = 0; p < given.pages; ++p) atlas.places.push_back({p, 0, 0, page_size, page_size});
  atlas.corners.resize(side_count(patches.size()));
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    const SideId front(p, false);
    const auto t = patches.triangle[p];
    const auto& of_scene = scene.triangles[t];
    const std::array whole = {scene.positions[of_scene[0]], scene.positions[of_scene[1]],
                              scene.positions[of_scene[2]]};
    const auto points = patches.points(p);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto w = barycentric(whole, points[k]);
      Point at(0.0);
      for (std::size_t i = 0; i < 3; ++i) at += w[static_cast<int>(i)] * Point(given.uvs[t][i]);
      atlas.corners[front.index()][k] = Vec2(static_cast<double>(page_size) * at);
    }
    laid.charts.of_side[front.index()] = given.page[t];
    laid.charts.charts[given.page[t]].sides.push_back(front);
  }
  atlas.chart_of = laid.charts.of_side;
  return laid;
}

int page_size_for(const Scene& scene, const GivenLayout& given, double texels_per_metre, int most) {
  std::vector<double> metres(given.pages, 0.0), pages(given.pages, 0.0);  // areas: m², fractions of a page
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const auto& c = scene.triangles[t];
    metres[given.page[t]] +=
        triangle_area(scene.positions[c[0]], scene.positions[c[1]], scene.positions[c[2]]);
    pages[given.page[t]] += uv_area(given.uvs[t]);
  }
  double wanted = 1.0;
  for (std::size_t p = 0; p < metres.size(); ++p)
    if (pages[p] > 0.0) wanted = std::max(wanted, texels_per_metre * std::sqrt(metres[p] / pages[p]));
  int size = 8;
  while (size < wanted && size < most) size *= 2;
  return std::min(size, most);
}

}  // namespace luxel
