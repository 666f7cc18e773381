// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "luxel/core/none.h"

namespace luxel {

// A region of a plane in triangles (fragments), as a mesh that can be changed step by step. Points stand on a
// grid of integers, where the side of a line on which a point lies is decided exactly; so the fragments are
// counter-clockwise and cover the region without overlap, whatever is done.
class FragmentMesh {
 public:
  static constexpr std::int64_t grid = std::int64_t{1} << 29;

  struct Point {
    std::int64_t x, y;  // 0 to grid
  };
  // across[k] is the fragment beyond the edge from v[k] to the next corner; none at the boundary.
  struct Fragment {
    std::array<std::uint32_t, 3> v;
    std::array<std::uint32_t, 3> across;
  };
  // Edge k of a fragment: from v[k] to the next.
  struct Edge {
    std::uint32_t fragment = none;
    std::uint32_t k = 0;
  };
  using Ends = std::pair<std::uint32_t, std::uint32_t>;

  // One triangle: points 0, 1, 2 are its corners, at (0, 0), (grid, 0) and (0, grid).
  FragmentMesh();
  // Fragments that are counter-clockwise, do not overlap and name each other across their common edges.
  FragmentMesh(std::vector<Point> points, std::vector<Fragment> fragments);

  const std::vector<Point>& points() const { return points_; }
  const std::vector<Fragment>& fragments() const { return fragments_; }
  // Ends of an edge, and the third corner of its fragment.
  std::uint32_t from(Edge e) const { return fragments_[e.fragment].v[e.k]; }
  std::uint32_t to(Edge e) const { return fragments_[e.fragment].v[(e.k + 1) % 3]; }
  std::uint32_t apex(Edge e) const { return fragments_[e.fragment].v[(e.k + 2) % 3]; }
  // The same edge in its other fragment; that fragment is none at the boundary.
  Edge other_side(Edge e) const;

  // Above 0 where a, b, c turn to the left: twice the area in grid steps.
  std::int64_t turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  // A point that no fragment has yet; the last one may be taken back.
  std::uint32_t add_point(const Point& p);
  void take_back() { points_.pop_back(), fragment_at_.pop_back(); }
  // A fragment that holds the point, its boundary included.
  std::uint32_t fragment_with(std::uint32_t point) const;
  // The edges that leave a point, one of each fragment that has it.
  std::vector<Edge> spokes(std::uint32_t point) const;
  // An edge between the points, in either direction; its fragment is none where there is no such edge.
  Edge edge_between(std::uint32_t a, std::uint32_t b) const;

  // The point must be inside the fragment.
  void split_fragment(std::uint32_t fragment, std::uint32_t point);
  // The edge becomes two that meet in the point, which need not be on it exactly.
  bool can_split(Edge e, std::uint32_t point) const;
  void split_edge(Edge e, std::uint32_t point);
  // The edge becomes the other diagonal of its two fragments.
  bool can_flip(Edge e) const;
  void flip(Edge e);

 private:
  void set(std::uint32_t fragment, std::array<std::uint32_t, 3> v, std::array<std::uint32_t, 3> across);
  // The fragment beyond an edge now has another neighbour.
  void redirect(std::uint32_t fragment, std::uint32_t old_neighbour, std::uint32_t neighbour);
  std::uint32_t next_number() const { return static_cast<std::uint32_t>(fragments_.size()); }

  std::vector<Point> points_;
  std::vector<std::uint32_t> fragment_at_;  // some fragment of each point
  std::vector<Fragment> fragments_;
};

}  // namespace luxel
