// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/area_settings.h"

namespace luxel {

void AreaSettings::declare(OptionSet& set) {
  set.heading("Areas");
  set.add_text("areas", "FILE", file,
               "TOML or glTF file of calculation areas, such as task areas and escape routes, with their "
               "requirements");
  set.add_text("scene", "FILE", scene,
               "--areas: the solved scene, which has the names of its objects and groups");
  set.add_choice("drawing", {"lines", "values", "both"}, drawing,
                 "--areas: what an .svg shows: isolux lines, the values at the points, or both");
}

void AreaSettings::check() const {
  if (is_given()) return;
  if (!scene.empty()) throw UsageError("--scene belongs to --areas");
  if (drawing != AreaSettings().drawing) throw UsageError("--drawing belongs to --areas");
}

std::vector<CalculationArea> AreaSettings::areas(const RequirementTable& requirements,
                                                 const Vec3d& up) const {
  return read_areas(file, requirements, up);
}

}  // namespace luxel
