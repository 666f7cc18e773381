// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/make_charts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/core/trig.h"
#include "luxel/patch/side.h"
#include "luxel/solution/back_is_lit.h"
#include "luxel/surface/chart_cuts.h"
#include "luxel/surface/cluster_sides.h"
#include "luxel/surface/flat_fragment.h"
#include "luxel/surface/side_nodes.h"

namespace luxel {
namespace {

void check(const PatchSet& patches, const Solution& solution, const ChartOptions& options) {
  const auto values = patches.size() * patches.band_count();
  if (solution.bands != patches.bands || solution.irradiance.front.size() != values ||
      solution.irradiance.back.size() != values)
    throw MismatchError(
        fmt::format("the solution's light is not of these {} patches: solve this scene", patches.size()));
  if (!(options.texel > 0.0f) || !std::isfinite(options.texel))
    throw InputError(fmt::format("a texel must be larger than 0 m, but it is {}", options.texel));
  if (!(options.max_angle >= 1.0f && options.max_angle <= 60.0f))
    throw InputError(
        fmt::format("a chart's angle must be from 1 to 60 degrees, but it is {}", options.max_angle));
  if (!(options.crease_angle >= 0.0f && options.crease_angle <= 180.0f))
    throw InputError(
        fmt::format("the crease angle must be from 0 to 180 degrees, but it is {}", options.crease_angle));
  if (options.max_texels < 1)
    throw InputError(
        fmt::format("a chart must have room for a texel, but it has for {}", options.max_texels));
}

// Light of all bands, W/m².
float light_of(const PatchSet& patches, const Solution& solution, SideId side) {
  const auto bands = patches.band_count();
  const auto* light = solution.irradiance.of(side).data() + side.patch() * bands;
  return std::accumulate(light, light + bands, 0.0f);
}

// Ranks how closely two sides at an edge belong together.
std::tuple<bool, bool, float> affinity(const PatchSet& patches, const SideEdge& edge) {
  const auto a = edge.halves[0].side, b = edge.halves[1].side;
  return {patches.triangle[a.patch()] == patches.triangle[b.patch()],
          patches.material[a.patch()] == patches.material[b.patch()],
          glm::dot(patches.normal_of(a), patches.normal_of(b))};
}

// Charts go on across creases and where another surface stands on one, unless it bends away; ChartCuts cuts
// them there where the light jumps.
LightBorders borders_of(const PatchSet& patches, const Solution& solution,
                        const std::vector<SideEdge>& edges) {
  constexpr float max_bend = 75.0f;  // degrees
  const auto cos_max_bend = cosine_of_degrees(max_bend);
  LightBorders borders;
  for (std::size_t i = 0; i < side_count(patches.size()); ++i)
    borders.light.push_back(light_of(patches, solution, SideId::at(i)));
  const auto is_bent = [&](const SideEdge& edge) {
    const auto a = edge.halves[0].side, b = edge.halves[1].side;
    if (glm::dot(patches.normal_of(a), patches.normal_of(b)) < cos_max_bend) return true;
    // Both lie on one side of the edge: folded onto each other.
    const auto from = patches.vertices[edge.ends[0]];
    const auto along = patches.vertices[edge.ends[1]] - from;
    const auto out = glm::cross(along, patches.normal_of(a));
    return glm::dot(out, patches.centroid(a.patch()) - from) *
               glm::dot(out, patches.centroid(b.patch()) - from) >
           0.0f;
  };
  borders.is_crossed.resize(edges.size());
  std::vector<std::size_t> open;
  std::set<SideId> paired;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    open.clear();
    paired.clear();
    for (end = begin; end < edges.size() && edges[end].ends == edges[begin].ends; ++end) {
      borders.is_crossed[end] = edges[end].smooth;
      if (edges[end].smooth)
        for (const auto& half : edges[end].halves) paired.insert(half.side);
      else if (!is_bent(edges[end]))
        open.push_back(end);
    }
    // Where several surfaces share an edge, each side goes on in one of them.
    if (open.size() > 1)
      std::stable_sort(open.begin(), open.end(), [&](auto a, auto b) {
        return affinity(patches, edges[a]) > affinity(patches, edges[b]);
      });
    for (const auto e : open) {
      const auto a = edges[e].halves[0].side, b = edges[e].halves[1].side;
      if (paired.contains(a) || paired.contains(b)) continue;
      borders.is_crossed[e] = true;
      paired.insert(a);
      paired.insert(b);
    }
  }
  return borders;
}

// The light below which a back is all but dark: two per cent of the mean light of fronts.
float dim_light(const PatchSet& patches, const LightBorders& borders) {
  constexpr double dim = 0.02;
  double sum = 0.0, area = 0.0;
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    const auto own = static_cast<double>(patches.area[p]);
    sum += own * static_cast<double>(borders.light[SideId(p, false).index()]);
    area += own;
  }
  return area > 0.0 ? static_cast<float>(dim * sum / area) : 0.0f;
}

// Takes out clusters that need no texels of their own: backs that are all but dark, as within furniture that
// is not quite closed, and dark fronts whose backs are lit, as of surfaces that face the wrong way.
std::vector<SideId> take_dim_sides(std::vector<SideCluster>& clusters, const LightBorders& borders,
                                   const std::vector<bool>& is_wanted, float dim) {
  const auto is_dim = [&](SideId side) {
    return side.is_back() ? borders.light[side.index()] <= dim
                          : borders.is_dark(side) && is_wanted[side.opposite().index()];
  };
  std::vector<SideId> taken;
  std::erase_if(clusters, [&](const SideCluster& cluster) {
    if (!std::all_of(cluster.sides.begin(), cluster.sides.end(), is_dim)) return false;
    taken.insert(taken.end(), cluster.sides.begin(), cluster.sides.end());
    return true;
  });
  std::sort(taken.begin(), taken.end());
  return taken;
}

// Every front, and the backs of connected surfaces on which light fell.
std::vector<bool> lit_sides(const PatchSet& patches, const Solution& solution,
                            const std::vector<SideEdge>& edges, const EdgesOfSides& of_sides) {
  std::vector<bool> is_wanted(side_count(patches.size()), false);
  std::vector<SideId> open;
  const auto take = [&](SideId side) {
    if (is_wanted[side.index()]) return;
    is_wanted[side.index()] = true;
    open.push_back(side);
  };
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    if (back_is_lit(solution, p)) take({p, true});
  while (!open.empty()) {
    const auto side = open.back();
    open.pop_back();
    for (const auto e : of_sides.at(side)) {
      const auto& halves = edges[e].halves;
      const auto other = halves[halves[0].side == side ? 1 : 0].side;
      if (edges[e].smooth && (!other.is_back() || patches.material_of(other.patch()).two_sided)) take(other);
    }
  }
  for (std::uint32_t p = 0; p < patches.size(); ++p) is_wanted[SideId(p, false).index()] = true;
  return is_wanted;
}

}  // namespace

Charts make_charts(const PatchSet& patches, const Solution& solution, const ChartOptions& options,
                   const Context& context) {
  check(patches, solution, options);
  Charts charts;
  const auto cos_crease = cosine_of_degrees(options.crease_angle);
  charts.edges = find_side_edges(patches, make_side_nodes(patches, cos_crease, context));
  const EdgesOfSides of_sides(side_count(patches.size()), charts.edges);
  const auto borders = borders_of(patches, solution, charts.edges);
  const auto is_wanted = lit_sides(patches, solution, charts.edges, of_sides);

  auto clusters = cluster_sides({patches, charts.edges, borders.is_crossed, is_wanted,
                                 static_cast<double>(cosine_of_degrees(options.max_angle))},
                                context);
  if (auto dim = take_dim_sides(clusters, borders, is_wanted, dim_light(patches, borders)); !dim.empty()) {
    Chart point;
    point.is_point = true;
    point.sides = std::move(dim);
    charts.charts.push_back(std::move(point));
  }
  ChartCuts cuts(patches, charts.edges, of_sides, borders, options);
  constexpr std::size_t clusters_per_report = 64;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const auto done = static_cast<double>(i) / static_cast<double>(clusters.size());
    if (i % clusters_per_report == 0 && context.report({"charts", 0.5 + 0.5 * done}) == Next::stop) return {};
    // A surface that winds over itself is laid out one layer at a time.
    auto open = cuts.connected(clusters[i].sides);
    while (!open.empty()) {
      const auto placed = without_overlaps(patches, open.back(), clusters[i].direction);
      open.pop_back();
      for (auto& part : cuts.connected(placed.over)) open.push_back(std::move(part));
      for (auto& chart : cuts.cut(placed.kept, clusters[i].direction))
        charts.charts.push_back(std::move(chart));
    }
  }

  std::sort(charts.charts.begin(), charts.charts.end(),
            [](const Chart& a, const Chart& b) { return a.sides.front() < b.sides.front(); });
  charts.of_side.assign(side_count(patches.size()), none);
  for (std::uint32_t c = 0; c < charts.charts.size(); ++c)
    for (const auto side : charts.charts[c].sides) charts.of_side[side.index()] = c;
  return charts;
}

}  // namespace luxel
