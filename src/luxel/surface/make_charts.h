// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/side_edges.h"

namespace luxel {

struct ChartOptions {
  float texel = 0.05f;         // m, of a side: gaps thinner than two of them part a chart
  float crease_angle = 30.0f;  // degrees; charts end where neighbours meet at a sharper angle, as SmoothLight
  float max_angle = 50.0f;  // degrees, 1 to 60; sides that face farther away from a chart's middle leave it
  int max_texels = 1000;    // a chart is no wider and no higher: it must fit on a page
};

// Sides of patches that are laid flat together: projected along one direction, none covers another. Or a
// single point, for all backs that are nearly dark.
struct Chart {
  std::vector<SideId> sides;     // ascending
  Vec3d origin{0.0};             // m; a corner of the smallest box around it
  std::array<Vec3d, 2> axes{};   // unit, at right angles; the box lies along them, the longer side first
  std::array<double, 2> size{};  // m, of the box
  bool is_point = false;
  double stretch = 1.0;  // to lay it out by: then its sides cover as many texels as if none were averted
};

struct Charts {
  std::vector<Chart> charts;
  std::vector<std::uint32_t> of_side;  // [side]: its chart, or none
  std::vector<SideEdge> edges;         // where sides meet; seams are those of two charts

  // Position of a point (m) in a chart's box, m along its axes.
  static std::array<double, 2> place(const Chart& chart, const Vec3& point) {
    const auto d = Vec3d(point) - chart.origin;
    return {glm::dot(d, chart.axes[0]), glm::dot(d, chart.axes[1])};
  }
};

// Cuts the surfaces into charts: smooth surface_parts (SideNodes), and of curved ones the parts that face
// much the same way. Every front is in one; a back only where light fell on its surface_part.
//
// Within a chart light runs on from every side to its neighbours, so that texels may be read between: where
// another surface stands on one, across a gap or a wall thinner than two texels, and where it would be too
// large for a page, a chart is cut in two along a straight line.
//
// Charts stand in the order of their first sides, the same on any number of threads; after the monitor's stop
// there are none. Cost: linear but for sorts; cuts go through their chart once each.
//
// Throws MismatchError where the solution is not of these patches, InputError where an option is out of its
// range.
Charts make_charts(const PatchSet& patches, const Solution& solution, const ChartOptions& options,
                   const Context& context = {});

}  // namespace luxel
