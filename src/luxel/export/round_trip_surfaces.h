// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/export/round_trip_parts.h"
#include "luxel/patch/patch_set.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// A vertex that the file does not have: a place in one of its triangles.
struct RoundTripVertex {
  std::array<std::uint32_t, 3> of{};  // vertices of the primitive
  Vec3d weights{0.0};                 // of theirs; they sum to one
};

// One side of a part as it is to be written. Vertices of the primitive's own come first, then those added.
struct RoundTripSurface {
  bool back = false;
  std::uint32_t page = 0;          // of a lightmap
  std::vector<std::uint32_t> own;  // of the primitive's vertices; ascending
  std::vector<RoundTripVertex> added;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // as the file winds them
  std::vector<std::uint32_t> light;  // [vertex]: a vertex of SmoothLight, or of the scene, or none
  std::vector<Vec2> uv;              // [vertex]: on the lightmap
  bool has_all_own = true;           // whether triangles use them or not: their arrays may stay as they are
  bool as_it_was = false;            // the primitive's own vertices and triangles, in their order
};

// The patches into which each triangle of a scene was cut, in rows.
class PatchesOfTriangles {
 public:
  // Patches stand in the order of their triangles.
  PatchesOfTriangles(const PatchSet& patches, std::size_t triangles);
  std::uint32_t begin(std::size_t triangle) const { return begin_[triangle]; }
  std::uint32_t end(std::size_t triangle) const { return begin_[triangle + 1]; }

 private:
  std::vector<std::uint32_t> begin_;
};

// Data that does not change while parts are cut.
struct RoundTripScene {
  const Scene& scene;
  const PatchSet& patches;
  const PatchesOfTriangles& of_triangles;
  const std::vector<bool>& back_is_lit;  // [patch]
};

// The file's own triangles, with the light at the scene's vertices. A back is there where light fell on it.
std::vector<RoundTripSurface> uncut_surfaces(const RoundTripScene& round_trip, const RoundTripPart& part);

// Patches, with the smooth light at theirs.
std::vector<RoundTripSurface> cut_surfaces(const RoundTripScene& round_trip, const RoundTripPart& part,
                                           const SmoothLight& light);

}  // namespace luxel
