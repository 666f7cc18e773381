// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/surface/make_charts.h"
#include "luxel/surface/side_edges.h"

namespace luxel {

// The edges of each side (indices into `edges`), in rows.
class EdgesOfSides {
 public:
  EdgesOfSides(std::size_t sides, const std::vector<SideEdge>& edges);
  std::span<const std::uint32_t> at(SideId side) const {
    return std::span(edges_).subspan(begin_[side.index()], begin_[side.index() + 1] - begin_[side.index()]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> edges_;
};

// Edges that charts may cross, and the light of sides.
struct LightBorders {
  std::vector<bool> is_crossed;  // [edge]: whether a chart may go on across it
  std::vector<float> light;      // [side], W/m², all bands; 0 as below a box that stands on a floor
  bool is_dark(SideId side) const { return !(light[side.index()] > 0.0f); }
};

// Cuts flat fragments until each can be a chart: connected, on a page, and without a row of texels between
// places between which light is discontinuous.
class ChartCuts {
 public:
  // Keeps references.
  ChartCuts(const PatchSet& patches, const std::vector<SideEdge>& edges, const EdgesOfSides& of_sides,
            const LightBorders& borders, const ChartOptions& options);

  // sides: seen along `direction` none covers another. Throws InputError where one patch alone is too large.
  std::vector<Chart> cut(std::vector<SideId> sides, const Vec3d& direction);

  // Sides by connected part, each from its first side outwards.
  std::vector<std::vector<SideId>> connected(const std::vector<SideId>& sides);

 private:
  // A straight line across a chart's box: to its left the cross product is positive.
  struct Line {
    glm::dvec2 point{0.0}, along{0.0};
  };
  struct Cut {
    bool wanted = false;
    Line line;
    std::vector<std::uint32_t> edges = {};  // on the line; if they part the chart, it ends there
  };
  using Sides = std::vector<SideId>;

  Cut cut_of(const Chart& chart);
  Cut across_page(const Chart& chart) const;
  Cut at_jump(const Chart& chart) const;
  Cut at_thin_gap(const Chart& chart) const;
  // A part of a border, on the chart.
  struct Border {
    glm::dvec2 from{0.0}, to{0.0};
    double length = 0.0;
    float light = 0.0f;         // of the side that has it, W/m²
    std::uint32_t edge = none;  // where sides of the chart meet
  };
  // Cuts along the line that contains the longest of the borders, if they are longer than so many metres.
  Cut along_longest(const Chart& chart, std::vector<Border> borders, double shortest) const;
  // Returns whether the middle of a side lies to the left of a line.
  bool lies_left(const Chart& chart, const Line& line, SideId side) const;
  // Returns whether some sides lie to the left and some do not.
  bool parts(const Chart& chart, const Line& line) const;
  // Returns whether no lit side of the same fragment goes on beyond the edge k of a side.
  bool is_border(SideId side, std::uint32_t k) const;
  void label(const Sides& sides);

  const PatchSet& patches_;
  const std::vector<SideEdge>& edges_;
  const EdgesOfSides& of_sides_;
  const LightBorders& borders_;
  const ChartOptions& options_;
  // Pieces that the cut makes of a chart.
  std::vector<Sides> pieces(const Chart& chart, const Cut& cut);

  std::vector<bool> is_barred_;          // [edge], by the cut at hand
  std::vector<std::uint32_t> fragment_;  // [side]: the fragment it was last in
  std::uint32_t fragments_ = 0;
};

}  // namespace luxel
