// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/cli/keep_settings.h"
#include "luxel/cli/mesh_settings.h"
#include "luxel/cli/settings.h"

namespace luxel {

// All options of a bake.
struct BakeSettings {
  SceneSettings scene;
  RefineSettings refine;
  LightSettings light;
  KeepSettings keep;
  LookSettings look;
  MeshSettings mesh;
  PictureSettings picture;
  RunSettings run;

  void declare(OptionSet& set);
  // Throws UsageError where options contradict each other or nothing would be written.
  void check() const;
};

}  // namespace luxel
