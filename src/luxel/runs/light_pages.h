// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/make_lightmap.h"
#include "luxel/runs/lightmap_settings.h"
#include "luxel/runs/reporter.h"
#include "luxel/runs/time_budget.h"
#include "luxel/scene/scene.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Record of the making of pages of light, for reports.
struct PagesRecord {
  int pages = 0, page_size = 0;  // texels per side
  bool as_file_has_it = false;   // laid out by the scene's file
  double error_target = 0.0;     // of a texel; 0: none is gathered
  LightmapReport made;
};

struct LightPages {
  Lightmap lightmap;
  PagesRecord record;
};

// Input of the atlas pages. scene: null where it is not available; metres_per_unit: as it was loaded.
struct PagesInput {
  const PatchSet& patches;
  const Solution& solution;
  const Scene* scene = nullptr;
  double metres_per_unit = 1.0;
};

// Lays surfaces out, as in the scene's file where that is requested and possible, and gathers their light;
// reports the result. budget: ends the gathering of texels, null: never. After a Ctrl-C while texels are
// gathered the rest of them hold interpolated light; after one in any other stage the result is empty. Throws
// the errors of the stages.
std::optional<LightPages> make_light_pages(const PagesInput& input, const LightmapSettings& settings,
                                           const Tracer* tracer, const Context& context, Reporter& reporter,
                                           const TimeBudget* budget = nullptr);

}  // namespace luxel
