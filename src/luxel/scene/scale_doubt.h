// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/scene/scene.h"

namespace luxel {

// A scene whose size suggests that its file counts in another unit than it was loaded with.
struct ScaleDoubt {
  double extent = 0.0;  // m, the longest side of its box
  bool is_large = false;
  const char* unit = "";  // that makes a room of it: "centimetres"
  double metres = 1.0;    // per this unit: the factor for the scale
};

// Conservative: terrain, halls, buildings and small objects are not doubted. Large is a scene of 150 m or
// more that is 60 m high and wide, too, and as closed as a room; small is one below 30 mm.
std::optional<ScaleDoubt> doubt_scale(const Scene& scene);

// A sentence about lamps so bright that their emission is probably in another unit; empty where there are
// none: a million lumens or more, above 5000 lm for each m² of floor (ten times an office, more than a
// television studio), from lamps that are small parts of the scene.
std::string doubt_lumens(const Scene& scene);

}  // namespace luxel
