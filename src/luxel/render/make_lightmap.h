// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "luxel/core/progress.h"
#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/gather_texels.h"
#include "luxel/render/lightmap.h"
#include "luxel/render/solve_seams.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/given_layout.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct LightmapOptions {
  std::optional<double> texels_per_metre = {};  // nothing: as many as fill half of a page of 512 x 512
  int page_size = 1024;                         // texels, the most a page is wide and high
  int margin = 2;                               // texels between charts; filled from both sides
  float crease_angle = 30.0f;                   // degrees, as in SmoothOptions
  TexelOptions texels = {};
};

struct LightmapReport {
  std::size_t charts = 0;
  TexelReport texels;
  SeamReport seams;
};

// What the options ask for, or what suits the surfaces where they leave it open.
double texels_per_metre(const PatchSet& patches, const Solution& solution, const LightmapOptions& options);

// The light of surfaces that are laid out already, here or by the scene's file: texels gathered, seams
// solved, margins filled. After the monitor's stop in the stage "texels" the rest of these hold interpolated
// light, and it is not asked again; in any other stage, and there are no pages. As make_lightmap() in all
// else.
Lightmap fill_lightmap(const PatchSet& patches, const Solution& solution, const Tracer* tracer,
                       const LaidOut& laid, const LightmapOptions& options, const Workers& workers,
                       LightmapReport* report = nullptr, const Monitor& monitor = {});

// A lightmap of all lit surfaces: charts are made and packed, texels gathered, seams solved, margins filled.
// tracer: none, and there is no final gather. The same bytes on any number of threads. Throws what the stages
// throw.
Lightmap make_lightmap(const PatchSet& patches, const Solution& solution, const Tracer* tracer,
                       const LightmapOptions& options, const Workers& workers,
                       LightmapReport* report = nullptr, const Monitor& monitor = {});

}  // namespace luxel
