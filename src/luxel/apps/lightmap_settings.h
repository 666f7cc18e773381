// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/apps/option_set.h"
#include "luxel/lightmap/make_lightmap.h"

namespace luxel {

// The options of `lightmap`.
struct LightmapSettings {
  static constexpr double automatic_white = 0.0;
  LightmapOptions lightmap;
  double white = automatic_white;  // W/m²: irradiance that a PNG shows as white
  std::string error_map, preview;  // files; empty: none
  void declare(OptionSet& set);
};

}  // namespace luxel
