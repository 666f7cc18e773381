// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/patch/cut_contacts.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/size_field.h"
#include "luxel/scene/vertex_weld.h"

namespace luxel {

// Halves a triangle at its longest edge that is too long, and the halves again, until none is; appends the
// parts to a patch set. Needles are cut across first, into parts about as long as they are wide: their halves
// would be as narrow for their length. Whether an edge is halved depends on its own two ends only. Carries
// contact lines along: each part gets those that meet it.
class TriangleSplitter {
 public:
  // More than max_count patches are an InputError.
  TriangleSplitter(PatchSet& patches, VertexWeld& weld, const SizeField& sizes, std::size_t max_count)
      : patches_(patches), weld_(weld), sizes_(sizes), max_count_(max_count) {}

  // lines: all contact lines; of_triangle: the numbers of those on this one.
  void add(const std::array<std::uint32_t, 3>& corners, const Vec3& normal, std::uint32_t triangle,
           MaterialId material, std::span<const ContactLine> lines, std::vector<std::uint32_t> of_triangle);

  // The lines of all patches so far, sorted by patch.
  const std::vector<LineOnPatch>& lines_on_patches() const { return lines_on_patches_; }

 private:
  double excess2(std::uint32_t i, std::uint32_t j) const;
  void split(const std::array<std::uint32_t, 3>& c, const std::vector<std::uint32_t>& lines);
  // The parts of a needle whose two long edges are too long; none of other triangles.
  std::vector<std::array<std::uint32_t, 3>> slices(const std::array<std::uint32_t, 3>& c);
  // Appends the points that halve an edge which is too long, and its halves that are and are longer than
  // shortest2, the square of a length in m; the end b comes last.
  void add_halving_points(std::uint32_t a, std::uint32_t b, double shortest2,
                          std::vector<std::uint32_t>& points);
  std::vector<std::uint32_t> near(const std::array<std::uint32_t, 3>& c,
                                  const std::vector<std::uint32_t>& lines) const;
  void append(const std::array<std::uint32_t, 3>& c, const std::vector<std::uint32_t>& lines);

  PatchSet& patches_;
  VertexWeld& weld_;
  const SizeField& sizes_;
  std::size_t max_count_;
  std::vector<LineOnPatch> lines_on_patches_;
  // Data of the triangle that is being split.
  std::span<const ContactLine> all_lines_;
  Vec3 normal_{0.0f};
  std::uint32_t triangle_ = 0;
  MaterialId material_{};
};

}  // namespace luxel
