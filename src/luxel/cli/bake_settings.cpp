// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/bake_settings.h"

#include "luxel/cli/outputs.h"

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
  std::vector<NamedOutput> others;
  if (!keep.checkpoint.empty()) others.push_back({"--checkpoint", keep.checkpoint});
  check_before_work(run, picture, all_kinds, others);
}

}  // namespace luxel
