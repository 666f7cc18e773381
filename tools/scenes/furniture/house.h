// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "scenes/made_scene.h"

namespace luxel::scenes {

// A town house with a saddle roof whose ridge runs along x, its front in the plane z = 0 facing +z, its left
// front corner at the origin.
struct House {
  double width = 6.0, depth = 8.0;
  int storeys = 2;
  int columns = 3;      // of windows
  int door_column = 1;  // from the left
  bool arched_door = false;
  bool gable_to_street = false;  // the ridge runs along z
  bool shutters = true;
  Paint plaster = Paint::plaster_ochre;
  Paint door = Paint::door_blue;
};

// Adds the house's objects, turned about the vertical and moved to its place.
void add_house(MadeScene& scene, const std::string& name, const House& house, const Vec3d& at, double turn);

}  // namespace luxel::scenes
