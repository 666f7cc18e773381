// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/patch/patch_set.h"
#include "luxel/runs/reporter.h"
#include "luxel/runs/settings.h"
#include "luxel/scene/scene.h"
#include "luxel/solve/solve_light.h"

namespace luxel {

// "room.obj: 32 triangles, 4 materials, cut into 52,916 patches".
std::string describe_scene(const std::string& file, const Scene& scene, const PatchSet& patches);

// Reads the scene of the settings and makes it ready for a solve: the two functions below. Throws what
// load_scene() throws. up: "y", "z" or "auto", for luminaires that aim down. method: that solves the scene.
Scene load_lit_scene(const SceneSettings& settings, const std::string& up, const Context& context,
                     Reporter& reporter, Method method = Method::sampled);

// Returns the options for load_scene().
LoadOptions load_options(const SceneSettings& settings, const std::string& up);

// Moves luminaires out of surfaces, and gives a scene without light the default light (add_default_light())
// where --sky is auto; reports both.
void light_up(const SceneSettings& settings, Scene& scene, const Context& context, Reporter& reporter,
              Method method = Method::sampled);

}  // namespace luxel
