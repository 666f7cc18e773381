// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/patch/flat_triangle.h"
#include "luxel/scene/fragment_mesh.h"

namespace luxel {

// One triangle cut into fragments whose edges hold given points and lines: a constrained Delaunay
// triangulation (Lawson 1977; lines enforced by flips, Sloan 1993). A point, or a crossing of lines, that is
// no farther than `tolerance` from another point becomes that point, and a line bends by as much to run
// through it.
//
// Points are identified by numbers: 0, 1, 2 are the corners. Cost: about a microsecond per point, and what
// lines cross.
class TriangleCut {
 public:
  // tolerance: m, well below the triangle's height.
  TriangleCut(const FlatTriangle& triangle, double tolerance);

  // A point on edge k, at this share of its length, in (0, 1). The points of an edge come in the order from
  // corner k to the next, and before all points inside.
  std::uint32_t add_on_edge(std::size_t k, double fraction);
  // A point inside; the number of the one that is there already, if there is one.
  std::uint32_t add_inside(const Vec3d& place);
  // Makes the line from a to b a chain of edges that carry the tag.
  void add_line(std::uint32_t a, std::uint32_t b, std::uint32_t tag);
  // Flips edges that are no lines until no angle can be bettered (Delaunay).
  void improve();

  std::size_t points() const { return mesh_.points().size(); }
  Vec3d place(std::uint32_t point) const;
  const std::vector<FragmentMesh::Fragment>& fragments() const {
    return mesh_.fragments();
  }  // counter-clockwise
  // The edges that lie on lines, the lower point first, with the lines' tags.
  const std::map<FragmentMesh::Ends, std::vector<std::uint32_t>>& lines() const { return tags_; }

 private:
  using Edge = FragmentMesh::Edge;
  using Ends = FragmentMesh::Ends;
  struct PlanePoint {
    double x, y;  // m
  };

  PlanePoint in_plane(std::uint32_t point) const;
  double distance(std::uint32_t a, std::uint32_t b) const;
  double distance_to_segment(std::uint32_t p, std::uint32_t a, std::uint32_t b) const;
  bool is_on_the_way(std::uint32_t c, std::uint32_t a, std::uint32_t b) const;
  bool is_line(Edge e) const;

  // The edge becomes two, and so does a line on it.
  void split_edge(Edge e, std::uint32_t point);
  void move_tags(Edge e, std::uint32_t point);
  bool would_better(Edge e) const;
  void legalize(std::vector<Ends> open);

  // One step of a line from a to b: the point by way of which it must go, b itself once they share an edge;
  // none where there is no way.
  std::uint32_t advance(std::uint32_t a, std::uint32_t b);
  // Returns the point where a line from a to b meets the line on edge e; may add a point there.
  std::uint32_t cross(Edge e, std::uint32_t a, std::uint32_t b);
  // Flips the crossed edges until a and b share one.
  bool clear_way(std::uint32_t a, std::uint32_t b, std::vector<Ends> crossed);

  FlatTriangle triangle_;
  double tolerance_;
  std::array<PlanePoint, 2> step_;  // a grid step in x and in y
  std::array<std::uint32_t, 3> last_on_edge_{0, 1, 2};
  FragmentMesh mesh_;
  std::map<Ends, std::vector<std::uint32_t>> tags_;
};

}  // namespace luxel
