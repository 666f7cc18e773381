// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/cli/mesh_settings.h"
#include "luxel/cli/quality.h"
#include "luxel/cli/settings.h"
#include "luxel/cli/store_settings.h"

namespace luxel {

// All options of a bake.
struct BakeSettings {
  SceneSettings scene;
  RefineSettings refine;
  LightSettings light;
  StoreSettings keep;
  LookSettings look;
  MeshSettings mesh;
  PictureSettings picture;
  RunSettings run;
  QualitySettings quality;

  void declare(OptionSet& set);
  // Throws UsageError where options contradict each other or nothing would be written.
  void check() const;
};

}  // namespace luxel
