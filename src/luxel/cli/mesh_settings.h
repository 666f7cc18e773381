// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/cli/lightmap_settings.h"
#include "luxel/cli/option_set.h"
#include "luxel/export/target_application.h"
#include "luxel/scene/scene.h"

namespace luxel {

// How a GLB has its light.
struct MeshSettings {
  TargetApplication program = TargetApplication::any;  // that reads it
  std::string as = "vertex";
  bool keep_topology = false;
  LightmapSettings pages;  // of as lightmap and emissive
  void declare(OptionSet& set);
  bool on_pages() const { return as != "vertex"; }
  // Throws UsageError where options contradict each other.
  void check() const;
  // Throws UsageError where an option is of no output that is asked for. Not to be asked of options that an
  // earlier run had.
  void check_outputs(const std::vector<std::string>& outputs) const;
};

// A mesh that is wished for, and what is known of the file behind it.
struct MeshWish {
  const MeshSettings* settings = nullptr;  // none: the defaults
  const Scene* scene = nullptr;            // none: not at hand
  double metres_per_unit = 1.0;            // as it was loaded
};

}  // namespace luxel
