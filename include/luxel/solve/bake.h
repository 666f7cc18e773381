// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/patch/make_patches.h"
#include "luxel/scene/scene.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/sampled.h"

namespace luxel {

struct BakeOptions {
  PatchOptions patches = {};
  SampledOptions light = {};
};

/// Cuts a scene into patches as make_patches() does, and also along the edges of shadows of punctual lights
/// and small lamps (lamps/shadow_lines.h), unless options.contacts is off or there is no maximum edge. These
/// lines add at most half of the patches to which the scene is cut, or 4000 where this is more, and at most
/// 25,000 where all lamps have surfaces; the lines with the most light come first. Scenes without such lights
/// have the patches of make_patches(), those without any light at no cost.
///
/// The same bits for any number of threads. Throws what make_patches() and Tracer throw. The monitor receives
/// the stage "patches"; after its stop the set is empty. Cost: beside that of make_patches(), a tracer of the
/// triangles, the search for contacts once more, and about 200 rays per line.
PatchSet make_patches_for_light(const Scene& scene, PatchOptions options = {}, const Context& context = {});

/// Bakes a scene in one call: cuts it into patches, builds a tracer, and solves the light by the sampled
/// method. The result is what write_solution() writes, and what export_glb() and render() show. Programs that
/// solve the same patches more than once, use another method or print a report call the stages themselves:
/// make_patches_for_light(), Tracer, solve_light(). add_default_light() lights a scene without a lamp.
///
/// The same scene, options and seed give the same bits on any number of threads, as long as time does not end
/// the solve. Throws what check_scene(), make_patches() and solve_sampled() throw: InputError where the scene
/// is wrong or has no lamp. After the monitor's stop in the stage "patches" the result has no patches; in the
/// stage "light" it is the light so far. Cost: that of solve_sampled(), nearly all of it.
Baked bake(const Scene& scene, const BakeOptions& options = {}, const Context& context = {});

}  // namespace luxel
