// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

inline constexpr float no_max_edge = 0.0f;      ///< triangles as they come
inline constexpr float automatic_edge = -1.0f;  ///< from the scene: about PatchOptions::target_count patches

/// A straight segment of the edge of a shadow, or of where a penumbra begins or ends.
struct ShadowLine {
  std::uint32_t triangle = 0;   ///< that it lies on: an index into Scene::triangles
  std::array<Vec3d, 2> ends{};  ///< m, in the plane of the triangle, on it or on its boundary
  Vec3d lit_side = Vec3d(0.0);  ///< unit normal of the triangle, on the side that the light reaches
};

struct PatchOptions {
  float max_edge = automatic_edge;  ///< m; longer edges are split in halves; or one of the two words above
  /// patches that the automatic edge aims at (more where triangles are finer)
  std::size_t target_count = 50'000;
  std::size_t max_count = 20'000'000;  ///< more is an InputError with a max_edge that fits
  bool contacts = true;  ///< cut where surfaces touch or pass through each other, or hang close before them
  /// Lines, and patches that these add, where surfaces touch: more is an InputError. 0: 12 patches per
  /// triangle, at least 200,000, beyond which triangles stay whole where lines are densest, with a warning;
  /// more than 64 lines per triangle (200,000 at least, four million or 12 per triangle at most) are an
  /// InputError.
  std::size_t max_contacts = 0;
  float contact_gap = 1e-4f;  ///< m; surfaces so near touch (at most a hundredth of their shortest edge)
  /// Cut along these, too. make_patches_for_light() (solve/bake.h) finds them; any order, any number.
  std::vector<ShadowLine> shadow_lines = {};
  /// Without textures and colours of corners where they set reflectance: for shapes and lamps alone.
  bool plain_reflectance = false;
};

/// Splits every edge longer than max_edge in halves, recursively. Whether an edge is split depends on its
/// own two ends only, so neighbours split a shared edge alike and no cracks appear. Each step bisects a
/// triangle's longest edge: no angle gets smaller than half the smallest of the input triangle (Rosenberg and
/// Stenger 1975; Rivara 1984), and slivers become short fragments as wide as they were. Triangles without
/// area, and triangles that lie exactly on another one, are left out and counted in a warning; of two that
/// coincide the lamp, else the first, stays, two-sided if they face opposite ways.
///
/// Then the patches are cut along the lines where other surfaces touch or pass through theirs
/// (contact_lines.h) and along the outlines of things close before them, nearer than 0.35 of max_edge and a
/// hundredth of the scene's diagonal (near_lines.h). These become edges and PatchSet::contacts; see
/// cut_contacts.h. Patches are cut along PatchOptions::shadow_lines too: light may jump across them on their
/// lit side. Patches that no such line meets stay as they are. Where surfaces overlap in one plane, the
/// smaller one remains (overlaps.h). About two seconds of processor time for a million triangles, most of it
/// shared by the threads, and 20 us per line. The same bits for any number of threads.
///
/// The monitor receives the stage "patches"; after its stop the set is empty.
PatchSet make_patches(const Scene& scene, const PatchOptions& options = {}, const Context& context = {});

/// Throws the InputError of make_patches() where surfaces touch or pass through each other along more lines
/// than max_contact_lines(). Does nothing if PatchOptions::contacts is false. Call it before tracing rays in
/// an untrusted scene: if most triangles intersect, each ray tests hundreds of them. Cost: half of
/// make_patches().
void check_contacts(const Scene& scene, const PatchOptions& options, const Context& context = {});

/// Returns the limit of the lines where surfaces touch in a scene of this many triangles.
std::size_t max_contact_lines(const PatchOptions& options, std::size_t triangles);

/// Returns the edge that automatic_edge means in this scene, m.
float automatic_max_edge(const Scene& scene, std::size_t target_count);

}  // namespace luxel
