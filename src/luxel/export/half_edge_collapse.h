// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/export/displayed_corners.h"
#include "luxel/patch/patch_set.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// Removes vertices of a mesh by half-edge collapses (Hoppe et al., Mesh Optimization, SIGGRAPH 1993): the
// patches around a vertex are replaced by triangles between its neighbours. See simplify_mesh.h for the
// choice of vertices.
class HalfEdgeCollapse {
 public:
  // Keeps references. stays: [patch], whose vertices are not removed.
  HalfEdgeCollapse(const PatchSet& patches, const SmoothLight& light, const DisplayedCorners& displayed,
                   const std::vector<bool>& stays);

  // Passes until no vertex can be removed. A pass removes vertices none of which are neighbours, so that
  // triangles grow evenly.
  void run();

  bool is_gone(std::size_t patch) const { return is_gone_[patch]; }
  // The current corners of a patch, as corners of the patches from which they were taken.
  const std::array<CornerId, 3>& corners(std::size_t patch) const { return corners_[patch]; }
  // The patches that this one replaces, in part or whole, some more than once.
  std::vector<std::uint32_t> replaced_by(std::size_t patch) const;

 private:
  // A patch around a vertex, after a collapse.
  struct NewTriangle {
    std::uint32_t patch = 0;
    std::uint32_t k = 0;         // its corner where the removed vertex was
    CornerId corner = 0;         // what takes its place
    std::uint32_t triangle = 0;  // of the input
    std::uint32_t sheet = 0;     // smooth vertex at the removed vertex
  };
  // A removed corner, and the new triangle that shows its light: an index.
  struct Covered {
    CornerId corner;
    std::size_t by;
  };
  // Doubled areas of an input triangle around the vertex.
  struct Areas {
    std::uint32_t triangle;
    double before, after, tolerance;
  };

  std::uint32_t vertex(CornerId corner) const { return patches_.corners[corner / 3][corner % 3]; }
  std::uint32_t smooth(CornerId corner) const { return light_.corners[corner / 3][corner % 3]; }
  Vec3d place(CornerId corner) const { return Vec3d(patches_.vertices[vertex(corner)]); }
  std::uint32_t corner_at(std::uint32_t patch, std::uint32_t vertex) const;
  std::array<CornerId, 3> corners_of(const NewTriangle& t) const;

  const std::vector<std::uint32_t>& star_of(std::uint32_t vertex);
  bool remove(std::uint32_t vertex);
  double try_collapse(std::uint32_t v, std::uint32_t u, const std::vector<std::uint32_t>& star, double best);
  bool make_triangles(std::uint32_t v, std::uint32_t u, const std::vector<std::uint32_t>& star);
  void add_area(const Areas& more);
  // The new triangle of the patch's input triangle and sheet at a place; none: there is none.
  std::size_t covering(std::uint32_t patch, std::uint32_t k, const Vec3d& at, Vec3& weights) const;
  bool cover(CornerId corner, std::uint32_t patch, std::uint32_t k, float& largest);
  bool cover_middles(std::uint32_t patch, std::uint32_t k, float& largest) const;
  void apply(std::uint32_t v, const std::vector<std::uint32_t>& star);

  double signed_area(std::uint32_t patch, const std::array<CornerId, 3>& corners) const;
  double shape(const std::array<CornerId, 3>& corners) const;
  double area_rounding(const std::array<CornerId, 3>& corners) const;
  Vec3d weights_in(const NewTriangle& t, const Vec3d& at) const;

  const PatchSet& patches_;
  const SmoothLight& light_;
  const DisplayedCorners& displayed_;
  const std::vector<bool>& stays_;
  std::vector<std::array<CornerId, 3>> corners_;    // [patch]
  std::vector<bool> is_gone_;                       // [patch]
  std::vector<std::vector<std::uint32_t>> around_;  // [vertex]: patches, gone ones among them
  std::vector<std::vector<CornerId>> removed_;      // [patch]: removed corners that it shows
  // Scratch of a collapse.
  std::vector<std::uint32_t> ring_;  // vertices around the current one
  std::vector<NewTriangle> collapsing_, triangles_, best_triangles_;
  std::vector<Areas> areas_;
  std::vector<Covered> covered_, best_covered_;
};

}  // namespace luxel
