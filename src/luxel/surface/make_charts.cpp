// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/make_charts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/core/trig.h"
#include "luxel/patch/side.h"
#include "luxel/solution/back_is_lit.h"
#include "luxel/surface/chart_cuts.h"
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

// Grows surface_parts that face much the same way.
class Pieces {
 public:
  Pieces(const PatchSet& patches, const std::vector<SideEdge>& edges, const EdgesOfSides& of_sides,
         float cos_angle)
      : patches_(patches),
        edges_(edges),
        of_sides_(of_sides),
        cos_angle_(static_cast<double>(cos_angle)),
        taken_(side_count(patches.size()), true),
        seen_(side_count(patches.size()), 0) {}

  // Every front, and the backs of surface_parts where light fell.
  void want_lit(const Solution& solution) {
    const auto holds_light = [&](SideId side) {
      return !side.is_back() || patches_.material_of(side.patch()).two_sided;
    };
    for (std::uint32_t p = 0; p < patches_.size(); ++p) taken_[SideId(p, false).index()] = false;
    for (std::uint32_t p = 0; p < patches_.size(); ++p) {
      const SideId back(p, true);
      if (!taken_[back.index()] || !back_is_lit(solution, p)) continue;
      for (const auto side : reach(back, holds_light, true)) taken_[side.index()] = false;
    }
  }

  bool is_taken(SideId side) const { return taken_[side.index()]; }

  // The surface_part around a side, and the direction it faces: the mean of its normals, so that on a bent
  // sheet it reaches as far to both sides as it may. The seed stays in it.
  std::vector<SideId> grow(SideId seed, Vec3d& direction) {
    constexpr int max_rounds = 8;
    direction = facing(patches_, seed);
    std::vector<SideId> surface_part;
    for (int round = 0; round < max_rounds; ++round) {
      surface_part = reach(
          seed, [&](auto side) { return glm::dot(facing(patches_, side), direction) >= cos_angle_; }, false);
      Vec3d sum(0.0);
      for (const auto side : surface_part)
        sum += static_cast<double>(patches_.area[side.patch()]) * facing(patches_, side);
      const auto length = glm::length(sum);
      if (!(length > 0.0)) break;
      const auto mean = sum / length;
      constexpr double as_good = 1.0 - 1e-6;
      if (round + 1 == max_rounds || glm::dot(mean, direction) > as_good ||
          glm::dot(facing(patches_, seed), mean) < cos_angle_)
        break;
      direction = mean;
    }
    surface_part = without_overlaps(patches_, surface_part, direction).kept;
    for (const auto side : surface_part) taken_[side.index()] = true;
    return surface_part;
  }

 private:
  // The sides that smooth edges reach from here through sides that may be taken, nearest first.
  template <typename Accepts>
  std::vector<SideId> reach(SideId seed, const Accepts& accepts, bool through_taken) {
    ++round_;
    std::vector<SideId> found = {seed};
    seen_[seed.index()] = round_;
    for (std::size_t i = 0; i < found.size(); ++i)
      for (const auto e : of_sides_.at(found[i])) {
        if (!edges_[e].smooth) continue;
        const auto& halves = edges_[e].halves;
        const auto other = halves[halves[0].side == found[i] ? 1 : 0].side;
        if (seen_[other.index()] == round_ || (taken_[other.index()] && !through_taken) || !accepts(other))
          continue;
        seen_[other.index()] = round_;
        found.push_back(other);
      }
    return found;
  }

  const PatchSet& patches_;
  const std::vector<SideEdge>& edges_;
  const EdgesOfSides& of_sides_;
  double cos_angle_;
  std::vector<bool> taken_;          // [side]: in a chart, or wanted in none
  std::vector<std::uint32_t> seen_;  // [side]: the last round that came by
  std::uint32_t round_ = 0;
};

}  // namespace

Charts make_charts(const PatchSet& patches, const Solution& solution, const ChartOptions& options,
                   const Context& context) {
  check(patches, solution, options);
  Charts charts;
  charts.edges =
      find_side_edges(patches, make_side_nodes(patches, cosine_of_degrees(options.crease_angle), context));
  const EdgesOfSides of_sides(side_count(patches.size()), charts.edges);

  Pieces surface_parts(patches, charts.edges, of_sides, cosine_of_degrees(options.max_angle));
  surface_parts.want_lit(solution);
  ChartCuts cuts(patches, charts.edges, of_sides, options);
  constexpr std::size_t sides_per_report = 256;
  const auto all = side_count(patches.size());
  for (std::size_t i = 0; i < all; ++i) {
    const auto side = SideId::at(i);
    const auto done = static_cast<double>(i) / static_cast<double>(all);
    if (i % sides_per_report == 0 && context.report({"charts", done}) == Next::stop) return {};
    if (surface_parts.is_taken(side)) continue;
    Vec3d direction;
    auto surface_part = surface_parts.grow(side, direction);
    for (auto& chart : cuts.cut(std::move(surface_part), direction))
      charts.charts.push_back(std::move(chart));
  }

  std::sort(charts.charts.begin(), charts.charts.end(),
            [](const Chart& a, const Chart& b) { return a.sides.front() < b.sides.front(); });
  charts.of_side.assign(side_count(patches.size()), none);
  for (std::uint32_t c = 0; c < charts.charts.size(); ++c)
    for (const auto side : charts.charts[c].sides) charts.of_side[side.index()] = c;
  return charts;
}

}  // namespace luxel
