// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/export/target_application.h"
#include "luxel/runs/lightmap_settings.h"
#include "luxel/runs/option_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Form of the light in a GLB.
struct MeshSettings {
  TargetApplication program = TargetApplication::any;  // that reads it
  std::string as = "vertex";
  bool keep_topology = false;
  bool simplify = true;
  MeshCompression compression = MeshCompression::quantised;
  LightmapSettings pages;  // of as lightmap and emissive
  void declare(OptionSet& set);
  bool on_pages() const { return as != "vertex"; }
  // Throws UsageError where options contradict each other.
  void check() const;
  // Throws UsageError where an option belongs to no requested output. Not to be called for options of an
  // earlier run.
  void check_outputs(const std::vector<std::string>& outputs) const;
};

// A requested mesh, and the file of its scene.
struct MeshWish {
  const MeshSettings* settings = nullptr;  // null: the defaults
  const Scene* scene = nullptr;            // null: not available
  double metres_per_unit = 1.0;            // as it was loaded
};

}  // namespace luxel
