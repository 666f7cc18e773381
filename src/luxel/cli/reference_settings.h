// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/render/path_traced.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// The options of path tracing.
struct ReferenceSettings {
  static constexpr const char* from_points = "points";
  static constexpr const char* from_patches = "patches";
  ReferenceLimits limits;
  std::string bounces_from = from_points;
  std::uint64_t seed = 1;
  PathOptions paths() const;
  // Throws UsageError where nothing would end the run.
  void check() const;
  void declare(OptionSet& set);
};

}  // namespace luxel
