// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/dense_truth.h"

namespace luxel::truth {

// A small room cut into patches, with the light that a perfect solver would find on these very patches.
struct KnownRoom {
  std::string name;
  PatchSet patches;
  TrueLight truth;
  double truth_error = 0.0;  // relative, of the area-weighted whole; see the row sums in dense_truth_test
};

// A cube under a luminous ceiling: a lamp huge and near. 384 patches.
KnownRoom luminous_ceiling();
// Two plates, open all round: most of the light is lost. 256 patches.
KnownRoom open_plates();
// A furnace of six greys with a block in its midst: all surfaces emit 1 - reflectance, so H = 1 everywhere,
// by theory and in spite of shadows. 432 patches.
KnownRoom mixed_furnace();
// A room of coloured walls under a red and a blue lamp. 384 patches.
KnownRoom coloured_room();
// A cube with a small lamp and a plate hung below it: a deep shadow with a soft edge, a plate lit on both
// sides. 400 patches.
KnownRoom hung_plate();
// The same with a plate of opal plastic, which transmits two fifths of the light. Not one of known_rooms().
KnownRoom opal_plate();
// The L-shaped room, lit round the corner: the far end gets a hundredth of the light. 448 patches.
KnownRoom l_shaped();

// All of them, by name, made when called.
struct RoomMaker {
  const char* name;
  KnownRoom (*make)();
};
const std::vector<RoomMaker>& known_rooms();

// The plate of hung_plate() and the inner walls of l_room(), as screens.
std::vector<ConvexPolygon> hung_plate_screens();
std::vector<ConvexPolygon> l_room_screens();

}  // namespace luxel::truth
