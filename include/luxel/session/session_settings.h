// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "luxel/import/load_scene.h"
#include "luxel/patch/light_groups.h"
#include "luxel/patch/make_patches.h"
#include "luxel/solve/refine_to_light.h"
#include "luxel/solve/solve_light.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

/// Lamps and colours that differ from the scene's own.
struct Lighting {
  std::vector<float> lamps;        ///< how much brighter, at least 0, [light group * bands + band]; empty: 1
  std::vector<float> reflectance;  ///< [0, 1), [material * bands + band]; empty: the scene's own

  bool operator==(const Lighting&) const = default;
};

/// How the scene of a session is read, meshed and lit: the options of `luxel bake`, with the same meaning.
struct SessionSettings {
  LoadOptions load = {};
  bool adds_default_light = false;  ///< to a scene without light, see add_default_light()
  PatchOptions patches = {};
  RefineOptions refine = {.mesh_error = 0.0};  ///< 0: the patches stay; its light and smooth are those below
  LightOptions light = {};
  bool joins_faces = false;                 ///< dense: patches of one uncut face have one value
  std::string focus = "all";                ///< where the seen error matters, see patch/focus.h
  bool stores_transport = true;             ///< sampled: so that lamps and colours can be changed, and saved
  std::vector<LightGroupRule> groups = {};  ///< lamps that are dimmed together; the others go by material
  SmoothOptions smooth{.lights_hidden = true};
  bool begins_at_once = true;  ///< false: shows the mesh, and solves on command
  int threads = 0;             ///< that solve, at a lower priority; 0: every core this process may use

  /// Both are called in the solver's thread. Empty: nothing is done.
  /// Puts the program's version, command line and options into a solution that will be solved so.
  std::function<void(Provenance& provenance, const LightOptions& light)> sign = {};
  /// Returns the options by which an opened solution was solved, for relighting and continuing it. Empty:
  /// those of `light`.
  std::function<LightOptions(const Provenance& provenance)> options_of = {};
};

}  // namespace luxel
