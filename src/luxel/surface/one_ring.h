// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/disjoint_sets.h"
#include "luxel/patch/patch_set.h"
#include "luxel/surface/hanging_vertices.h"

namespace luxel {

// The patches that meet at one vertex, and which of their sides are one smooth surface there. Sides, not
// patches, are joined, so that a neighbour wound the other way goes on with its back, and a wall that stands
// on a floor parts the light in front of it but not the light below, whether it shares the floor's vertices
// or only touches it (PatchSet::contacts). Where edges lie on each other without sharing their ends
// (T-junctions) patches are joined too. Holds its scratch memory, so one ring is filled again for vertex
// after vertex.
class OneRing {
 public:
  // cos_crease: cosine of the crease angle.
  OneRing(const PatchSet& patches, float cos_crease) : patches_(patches), cos_crease_(cos_crease) {}

  // corners: 3 * patch + corner (0, 1, 2) of every patch that has the vertex, ascending; hanging: the patches
  // on whose edges it hangs. Kept as copies; members stand in this order. Cost: one sort of the members.
  void fill(std::span<const std::uint32_t> corners, std::span<const HangingVertex> hanging);

  std::size_t size() const { return members_.size(); }
  std::size_t corner_count() const { return corner_count_; }
  bool is_hanging(std::size_t i) const { return i >= corner_count_; }
  std::uint32_t patch(std::size_t i) const { return members_[i].patch; }
  std::uint32_t corner(std::size_t i) const { return members_[i].place; }  // of its patch, if it has one here

  // Name of the smooth surface that a side of member i belongs to, below 2 * size(): the smallest side in it,
  // where 2 * i is the front of member i and 2 * i + 1 its back.
  std::uint32_t surface(std::size_t i, bool back) const { return surface_[2 * i + (back ? 1 : 0)]; }

 private:
  struct Member {
    std::uint32_t patch;
    std::uint32_t place;  // corner, or edge on which the vertex hangs
  };
  // One member at one edge that leaves the vertex, or another surface that only touches the edge.
  struct Sector {
    std::uint32_t edge;    // name of the edge: the other end of one of the sectors along it
    std::uint32_t other;   // the sector's own other end, which may lie nearer or farther
    std::uint32_t member;  // index into members_, or none
    bool outwards;         // the patch's winding runs along the edge away from the vertex
    double angle;          // place around the edge, growing but not in proportion with the angle, [0, 4)
  };

  void list_sectors();
  bool join_open_edges();
  bool on_one_line(const Sector& a, const Sector& b) const;
  void join_around_edge(std::span<const Sector> sectors);
  void join_facing(const Sector& from, const Sector& to);

  const PatchSet& patches_;
  float cos_crease_;
  std::uint32_t vertex_ = 0;
  std::size_t corner_count_ = 0;
  std::vector<Member> members_;
  DisjointSets sets_;                   // of sides, while filling
  std::vector<std::uint32_t> surface_;  // of each side
  std::vector<Sector> sectors_;
  std::vector<Sector> pages_;        // of one edge
  std::vector<std::uint32_t> open_;  // sectors that no other member shares
};

}  // namespace luxel
