// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/runs/mesh_settings.h"
#include "luxel/runs/quality.h"
#include "luxel/runs/settings.h"
#include "luxel/runs/store_settings.h"

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
  // Throws UsageError where options contradict each other.
  void check() const;
};

}  // namespace luxel
