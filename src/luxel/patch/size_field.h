// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "luxel/core/point_cells.h"
#include "luxel/core/vector.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/scene/clean_triangles.h"

namespace luxel {

// How long edges of patches may be: shorter where many short contact lines lie close together, as in the
// outline of a round foot. A patch that holds all of it would be cut into needles from each short line to its
// corners, and along needles light spreads as spikes.
//
// An edge is too long if it is longer than max_edge; or if it is longer than a sixteenth of that, and the
// circle that has the edge as its diameter holds the middles of more than ten lines that lie in the edge's
// plane and are shorter than max_edge / 24.
//
// Thread-safe once made. Cost: some tenths of a microsecond per short line; then as much per edge, more where
// lines of many planes lie close together.
class SizeField {
 public:
  // max_edge: m; 0 for no limit anywhere. lines: on these triangles; edges of shadows do not count, since
  // light is not much different on their two sides.
  SizeField(double max_edge, std::span<const ContactLine> lines, std::span<const CleanTriangle> triangles,
            const std::vector<Vec3>& positions);

  // Returns whether the edge between two points is too long: the same for all triangles at that edge, which
  // may name its ends in either order.
  bool is_too_long(const Vec3& a, const Vec3& b) const;

 private:
  struct ShortLine {
    Vec3d middle;  // m
    Vec3d normal;  // unit, of the plane that it lies in
  };
  bool has_many_lines(const Vec3d& from, const Vec3d& to) const;

  double max_edge_;
  std::vector<ShortLine> lines_;
  std::optional<PointCells> cells_;  // the middles of the lines, if there are any
};

}  // namespace luxel
