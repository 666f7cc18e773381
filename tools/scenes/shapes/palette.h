// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "luxel/core/vector.h"

namespace luxel::scenes {

// What the things in the scenes are made of. Names that begin with lamp_ or window_ shine; what belongs to
// one light group shares its first two words (lamp_floor_bulb, lamp_floor_shade).
enum class Paint {
  cream_wall,
  terracotta_wall,
  sage_wall,
  ceiling_white,
  corridor_yellow,
  corridor_floor,
  painted_wood,
  floor_oak_1,
  floor_oak_2,
  floor_oak_3,
  floor_oak_4,
  walnut,
  oak,
  black_steel,
  brass,
  teal_cloth,
  ochre_cloth,
  coral_cloth,
  plum_cloth,
  linen_cloth,
  rug_cream,
  rug_indigo,
  rug_rust,
  curtain_rose,
  paper,
  paper_dark,
  book_red,
  book_blue,
  book_green,
  book_yellow,
  book_black,
  book_white,
  book_orange,
  porcelain,
  glaze_turquoise,
  glaze_cobalt,
  clay,
  soil,
  leaf_dark,
  leaf_light,
  orange_peel,
  plaster_white,
  plaster_ochre,
  plaster_rose,
  plaster_blue,
  plaster_green,
  stone_pale,
  stone_warm,
  stone_grey,
  stone_dark,
  marble,
  brick,
  roof_tile,
  slate,
  paving_1,
  paving_2,
  paving_3,
  asphalt,
  grass,
  hedge,
  bark,
  foliage_1,
  foliage_2,
  blossom,
  water,
  concrete,
  steel_grey,
  plastic_white,
  plastic_black,
  carpet_blue,
  carpet_grey,
  linoleum,
  birch,
  chalkboard,
  bronze,
  tile_white,
  tile_green,
  terrazzo_1,
  terrazzo_2,
  glass_dark,
  door_blue,
  door_red,
  shutter_green,
  canvas,
  wax,
  bottle_green,
  bottle_amber,
  box_white,
  box_red,
  box_green,
  night_city,
  night_city_far,
  lamp_floor_bulb,
  lamp_floor_shade,
  lamp_table_bulb,
  lamp_table_shade,
  lamp_pendant,
  lamp_corridor,
  lamp_office,
  lamp_monitor,
  lamp_washer,
  lamp_stairs,
  lamp_cafe_bulb,
  lamp_cafe_counter,
  lamp_candle,
  lamp_study,
  lamp_box,
  window_city_lights,
  window_sky_1,  // the horizon
  window_sky_2,
  window_sky_3,
  window_sky_4,
  window_sky_5,
  window_sky_6,
  window_sky_7,
  window_sky_8,  // the zenith
  count          // how many there are
};

struct Pigment {
  Paint paint;
  const char* name;
  Vec3d reflectance;  // linear sRGB, 0 to 1
  Vec3d radiance;     // W/(m² sr) a band, of the front side
};

// One pigment for each paint, in the order of the enumeration.
std::span<const Pigment> palette();

inline bool shines(const Pigment& pigment) { return pigment.radiance.g > 0.0; }

}  // namespace luxel::scenes
