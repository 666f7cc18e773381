// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/lighting/areas.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// Maintenance factors that the light of a solution contains: those of its luminaires.
struct LuminaireMaintenance {
  double low = 1.0, high = 1.0;  // of all luminaires; both 1 where there are none
  bool is_initial() const { return low >= 1.0; }
  bool is_uniform() const { return low == high; }
};

LuminaireMaintenance luminaire_maintenance(const PatchSet& patches);

// The factors that the light on an area has been multiplied by: that of the luminaires, in the solution, and
// that of the area, on top of it. One of the two should be 1.
struct AppliedMaintenance {
  LuminaireMaintenance luminaires;
  MaintenanceFactor area;

  // Product of both, such as 0.8; nothing where the factors of the luminaires differ.
  std::optional<double> factor() const;
  bool is_initial() const { return luminaires.is_initial() && area.factor >= 1.0; }
  bool is_twice() const { return !luminaires.is_initial() && area.factor < 1.0; }
  // "initial", "maintenance factor 0.80", "maintenance factor 0.64 (luminaires 0.80, area 0.80)".
  std::string text() const;
};

// "0.80", or "0.80 (LLMF 0.93, LSF 1, LMF 0.92, RMF 0.94)" where the parts are known.
std::string text_of(const MaintenanceFactor& maintenance);

// The sentence of a warning where maintenance applies twice; else empty. area: its name.
std::string maintenance_warning(const AppliedMaintenance& applied, const std::string& area);

}  // namespace luxel
