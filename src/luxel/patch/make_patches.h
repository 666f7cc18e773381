// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/patch/patch_set.h"
#include "luxel/report/log.h"
#include "luxel/scene/scene.h"

namespace luxel {

inline constexpr float no_max_edge = 0.0f;      // triangles as they come
inline constexpr float automatic_edge = -1.0f;  // from the scene: about PatchOptions::target_count patches

struct PatchOptions {
  float max_edge = automatic_edge;  // m; longer edges are split in halves; or one of the two words above
  std::size_t target_count =
      50'000;  // patches that the automatic edge aims at (more where triangles are finer)
  std::size_t max_count = 20'000'000;  // more is an InputError that says which max_edge would fit
};

// Splits every edge longer than max_edge in halves, and those again. Whether an edge is split depends on its
// own two ends only, so neighbours split a shared edge alike and no cracks appear. Each step bisects a
// triangle's longest edge (Rivara 1984), which keeps angles from degrading. Triangles without area, and
// triangles that lie exactly on another one, are left out and counted in a warning; of two that coincide the
// lamp, else the first, stays, two-sided if they face opposite ways.
PatchSet make_patches(const Scene& scene, const PatchOptions& options = {}, const LogSink& log = {});

// The edge that automatic_edge stands for in this scene, m.
float automatic_max_edge(const Scene& scene, std::size_t target_count);

}  // namespace luxel
