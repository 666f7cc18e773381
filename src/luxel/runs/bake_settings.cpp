// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/bake_settings.h"

namespace luxel {

void BakeSettings::declare(OptionSet& set) {
  scene.declare(set);
  scene.declare_contacts(set);
  refine.declare(set);
  scene.declare_sky(set);
  scene.declare_luminaires(set);
  scene.declare_spectra(set);
  light.declare(set);
  keep.declare(set);
  look.declare(set);
  mesh.declare(set);
  picture.declare(set);
  run.declare(set, all_kinds);
  light.declare_run(set);
  keep.declare_run(set);
  quality.declare(set);
}

void BakeSettings::check() const {
  scene.check();
  light.check();
  mesh.check();
}

}  // namespace luxel
