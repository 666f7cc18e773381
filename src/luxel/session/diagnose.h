// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/bounds.h"
#include "luxel/core/context.h"
#include "luxel/session/light_walks.h"

namespace luxel {

struct CheckOptions {
  std::size_t places = 5;  // reported per diagnostic
  std::size_t paths = 0;   // of light, for the estimate of what is lost; 0: a quarter of the triangles, but
                           // at least 16,384
  std::uint64_t seed = 1;
};

// Report of `luxel check` on a scene.
struct CheckReport {
  std::vector<Diagnostic> diagnostics;  // diagnostics before doubts before notes, the graver kinds first
  std::size_t triangles = 0;            // of the scene
  std::size_t lit_triangles = 0;        // that carry light
  std::size_t components = 0, closed_components = 0;
  double area = 0.0;  // m²
  Bounds box;         // m, counted from the scene's origin
  LightWalks walks;
  std::size_t dark_walks = 0;  // random walks from each side that no light was found from
  std::uint64_t rays = 0;
  bool is_whole = true;  // false: stopped by the monitor, and diagnostics may be missing

  std::size_t count(Severity severity) const;
};

// Finds the defects of a scene before its light is solved: of the mesh by sorting, of the light by rays
// (about 10 million for a million triangles). Does not change the scene. The same report on any number of
// threads. About 10 s per million triangles on one core, half of it rays; 500 bytes per triangle. Throws what
// make_patches() throws.
CheckReport diagnose(const Scene& scene, const CheckOptions& options, const Context& context = {});

}  // namespace luxel
