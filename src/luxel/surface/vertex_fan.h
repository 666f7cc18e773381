// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel {

// The patch corners that meet at one vertex, and which of their sides are one smooth surface there. Sides,
// not patches, are joined, so that a neighbour wound the other way goes on with its back, and a wall that
// stands on a floor parts the light in front of it but not the light below. Holds its scratch memory, so one
// fan is filled again for vertex after vertex.
class VertexFan {
 public:
  // cos_crease: cosine of the crease angle.
  VertexFan(const PatchSet& patches, float cos_crease) : patches_(patches), cos_crease_(cos_crease) {}

  // corners: 3 * patch + corner (0, 1, 2) of every patch at the vertex, ascending; kept as a copy.
  // Cost: one sort of the corners.
  void fill(std::span<const std::uint32_t> corners);

  std::size_t size() const { return corners_.size(); }
  std::uint32_t corner(std::size_t i) const { return corners_[i]; }
  std::uint32_t patch(std::size_t i) const { return corners_[i] / 3; }

  // Name of the smooth surface that a side of corner i belongs to, below 2 * size(): the smallest side in it,
  // where 2 * i is the front of corner i and 2 * i + 1 its back.
  std::uint32_t surface(std::size_t i, bool back) const { return surface_[2 * i + (back ? 1 : 0)]; }

 private:
  // One patch at one edge that leaves the vertex.
  struct Wing {
    std::uint32_t other;   // the edge's other end
    std::uint32_t corner;  // index into corners_
    bool outwards;         // the patch's winding runs along the edge away from the vertex
    double angle;          // place around the edge, growing but not in proportion with the angle, [0, 4)
  };

  void list_wings();
  void join_around_edge(std::span<Wing> wings);
  void join_facing(const Wing& from, const Wing& to);
  std::uint32_t root(std::uint32_t side);

  const PatchSet& patches_;
  float cos_crease_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> surface_;  // union-find parents while filling
  std::vector<Wing> wings_;
};

}  // namespace luxel
