// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/scene/scene.h"

#include "bench/field_error.h"

namespace luxel::bench {

// A scene whose triangles are as large as they can be, to be cut by make_patches.
struct UncutScene {
  std::string name;
  Scene scene;
  TrueNormal normal;
};

// The Cornell box, the office and the two rooms of scenes.h; a room with a wall of no thickness and a box,
// both standing in the middle of a floor of two triangles; and one with a ball and a column.
std::vector<UncutScene> reconstruction_scenes();

}  // namespace luxel::bench
