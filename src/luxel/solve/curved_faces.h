// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// Input triangles that are faces of a curved surface: a smooth vertex of theirs has another normal. From face
// to face light steps by their normals, which the reconstruction takes for the slope of a smooth surface.
// Cuts do not bring the light of the faces nearer to it, they only bring out the steps. So there a difference
// of light counts only as far as there is one within the face too, as at the edge of a shadow.
class CurvedFaces {
 public:
  // light: of the patches. Keeps a reference to the patches alone.
  CurvedFaces(const PatchSet& patches, const SmoothLight& light);

  const PatchSet& patches() const { return patches_; }
  bool has(std::size_t patch) const { return is_curved_[patches_.triangle[patch]] != 0; }

 private:
  const PatchSet& patches_;
  std::vector<std::uint8_t> is_curved_;  // [input triangle]
};

// The patches of one face that meet at a corner, where faces are curved.
class FaceCorners {
 public:
  // Cost: a sort of the patches of curved faces that have been cut.
  FaceCorners(const CurvedFaces& faces, const SmoothLight& light);

  // Calls body(patch) for the patches of the same face at a corner of a patch: the patch itself among them.
  template <typename Body>
  void for_patches_at(std::size_t patch, std::size_t corner, Body body) const {
    const auto begin = places_[3 * patch + corner];
    if (begin == alone) return body(patch);
    const auto& at = list_[begin];
    for (auto i = begin; i < list_.size() && list_[i].is_at(at); ++i) body(list_[i].patch);
  }

 private:
  // A corner of a patch on a curved face that was cut.
  struct Place {
    std::uint32_t triangle = 0, vertex = 0, patch = 0;  // a smooth vertex
    bool is_at(const Place& o) const { return triangle == o.triangle && vertex == o.vertex; }
  };
  static constexpr std::uint32_t alone = 0xffffffff;

  std::vector<Place> list_;            // sorted
  std::vector<std::uint32_t> places_;  // [3 * patch + corner]: the first of its kind in list_; or alone
};

}  // namespace luxel
