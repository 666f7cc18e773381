// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/lightmap.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct LaidOut;

/// Input of a lightmap.
struct LightmapInput {
  const PatchSet& patches;
  const Solution& solution;        ///< of these patches
  const Tracer* tracer = nullptr;  ///< of these patches; needed where texels are gathered
};

/// The requested number, or an automatic one that suits the surfaces.
double texels_per_metre(const PatchSet& patches, const Solution& solution, const LightmapOptions& options);

/// Computes the light of surfaces that have a layout, by Luxel or the scene's file: texels gathered, seams
/// solved, margins filled. After the monitor's stop in the stage "texels" the rest of these hold interpolated
/// light; after a stop in another stage there are no pages. Otherwise as make_lightmap().
///
Lightmap fill_lightmap(const LightmapInput& input, const LaidOut& laid, const LightmapOptions& options,
                       LightmapReport* report = nullptr, const Context& context = {});

/// Computes a lightmap of all lit surfaces: charts are made and packed, texels gathered, seams solved,
/// margins filled. Without a tracer there is no final gather. The same bytes on any number of threads. Throws
/// what the stages throw.
Lightmap make_lightmap(const LightmapInput& input, const LightmapOptions& options,
                       LightmapReport* report = nullptr, const Context& context = {});

}  // namespace luxel
