// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/parallel/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/report/progress.h"
#include "luxel/solve/sampled.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

struct RefineOptions {
  double mesh_error = 0.02;  // asked for: area-weighted relative RMS of what the size of patches does
  std::size_t max_patches = 1'000'000;
  int max_levels = 12;
  // How the light is solved that decides: to 0.7 of mesh_error, or to the error here where that is larger.
  SampledOptions light = {};
  SmoothOptions smooth = {};  // how light is reconstructed from patches: its error is what counts
};

enum class RefineStop {
  mesh_error_reached,
  patch_limit,
  level_limit,
  drowned_in_noise,  // what is left of the error cannot be told from noise
  stopped_by_user
};

// One mesh on the way.
struct RefineLevel {
  std::size_t patches = 0;
  double mesh_error = 0.0;      // as estimated for this mesh
  double sampling_error = 0.0;  // of the light that decided
  std::uint64_t rays = 0;       // traced for it
};

struct RefineReport {
  RefineStop stop = RefineStop::stopped_by_user;
  double mesh_error = 0.0;  // of the mesh that is the result; a solution's own error is apart from it
  std::vector<RefineLevel> levels;
};

// Puts patches where the light needs them. The light is solved coarsely; patches are cut in four where the
// field reconstructed from them (surface/smooth_light.h) does not stand for it; the light is solved again,
// and what the parts say of the field on the whole is what the whole had wrong, d² in squares. Where halving
// leaves the share r of a squared error, what the parts still have wrong is d² r / (1 - r). r is taken from
// the last two levels, between a half, which is what a jump leaves, and a quarter. Cut
// first is what differs most, until what is left alone is a third of what is allowed (Dörfler 1996). Patches
// that are large beside the scene are cut once whatever they say: what lies wholly inside of one cannot be
// seen from outside.
//
// The same bits on any number of threads. Cost: a coarse solve a level; levels grow about as the jumps get
// longer in patches.
PatchSet refine_to_light(PatchSet patches, const RefineOptions& options, RefineReport& report,
                         const Workers& workers, const Monitor& monitor = {});

}  // namespace luxel
