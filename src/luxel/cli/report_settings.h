// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/cli/requirement_settings.h"
#include "luxel/lighting/glare.h"
#include "luxel/render/probe_light.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// Options of `report`.
struct ReportSettings {
  std::string title, project, author;
  std::string date;                         // empty: the day on which the solution's file was written
  double plane_height = 0.8, border = 0.0;  // m: above the floor; along the walls
  std::string areas, scene;                 // files; empty: none
  ProbeOptions probe;
  RequirementSettings required;  // of the working plane
  double maintenance = 0.0;  // of working plane and surfaces; 0: that at the top of the file of areas, else 1
  double hours = 2500.0;     // h per year at full power; 0: no estimate of energy
  std::string observers;     // file; empty: none
  bool has_unfolded = true;
  double eye_height = 1.2;  // m above the floor
  GlareOptions glare;
  bool has_picture = true;

  void declare(OptionSet& set);
  // Transfers what several measurements share; call it before they are used. Throws UsageError where options
  // need --areas. uses_scene: something else needs --scene.
  void settle(bool uses_scene);
};

}  // namespace luxel
