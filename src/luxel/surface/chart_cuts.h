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

// Which edges each side has (indices into `edges`), in rows.
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

// Cuts flat fragments until each can be a chart: connected, on a page, and no texel of it between two places
// that light does not run on between.
class ChartCuts {
 public:
  // Keeps references.
  ChartCuts(const PatchSet& patches, const std::vector<SideEdge>& edges, const EdgesOfSides& of_sides,
            const ChartOptions& options);

  // sides: seen along `direction` none covers another. Throws InputError where one patch alone is too large.
  std::vector<Chart> cut(std::vector<SideId> sides, const Vec3d& direction);

 private:
  // A straight line across a chart's box: to its left the cross product is positive.
  struct Line {
    glm::dvec2 point{0.0}, along{0.0};
  };
  struct Cut {
    bool wanted = false;
    Line line;
  };
  using Sides = std::vector<SideId>;

  std::vector<Sides> connected(const Sides& sides);
  Cut cut_of(const Chart& chart);
  Cut across_page(const Chart& chart) const;
  Cut at_contact(const Chart& chart);
  Cut at_thin_gap(const Chart& chart) const;
  // By its middle.
  bool lies_left(const Chart& chart, const Line& line, SideId side) const;
  // Whether some sides lie to the left and some do not.
  bool parts(const Chart& chart, const Line& line) const;
  // The edge k of a side, if it is a border: no side of the same fragment goes on there.
  bool is_border(SideId side, std::uint32_t k) const;
  void label(const Sides& sides);

  const PatchSet& patches_;
  const std::vector<SideEdge>& edges_;
  const EdgesOfSides& of_sides_;
  const ChartOptions& options_;
  std::vector<std::uint32_t> fragment_;  // [side]: the fragment it was last in
  std::uint32_t fragments_ = 0;
  std::vector<bool> cut_in_vain_;  // [edge]: a line through it parts nothing
};

}  // namespace luxel
