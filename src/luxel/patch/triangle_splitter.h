// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/patch/cut_contacts.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/vertex_weld.h"

namespace luxel {

// Halves a triangle at its longest edge, and the halves again, until no edge is too long; appends the parts
// to a patch set. Whether an edge is halved depends on its own two ends only. Carries contact lines along:
// each part gets those that meet it.
class TriangleSplitter {
 public:
  // max_edge: m, 0 for no splitting. More than max_count patches are an InputError.
  TriangleSplitter(PatchSet& patches, VertexWeld& weld, double max_edge, std::size_t max_count)
      : patches_(patches), weld_(weld), max_count_(max_count), max_edge2_(max_edge * max_edge) {}

  // lines: all contact lines; of_triangle: the numbers of those on this one.
  void add(const std::array<std::uint32_t, 3>& corners, const Vec3& normal, std::uint32_t triangle,
           MaterialId material, std::span<const ContactLine> lines, std::vector<std::uint32_t> of_triangle);

  // The lines of all patches so far, sorted by patch.
  const std::vector<LineOnPatch>& lines_on_patches() const { return lines_on_patches_; }

 private:
  double length2(std::uint32_t i, std::uint32_t j) const;
  void split(const std::array<std::uint32_t, 3>& c, const std::vector<std::uint32_t>& lines);
  std::vector<std::uint32_t> near(const std::array<std::uint32_t, 3>& c,
                                  const std::vector<std::uint32_t>& lines) const;
  void append(const std::array<std::uint32_t, 3>& c, const std::vector<std::uint32_t>& lines);

  PatchSet& patches_;
  VertexWeld& weld_;
  std::size_t max_count_;
  double max_edge2_;
  std::vector<LineOnPatch> lines_on_patches_;
  // Data of the triangle that is being split.
  std::span<const ContactLine> all_lines_;
  Vec3 normal_{0.0f};
  std::uint32_t triangle_ = 0;
  MaterialId material_{};
};

}  // namespace luxel
