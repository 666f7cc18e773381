// SPDX-License-Identifier: Apache-2.0
#include "scenes/shapes/palette.h"

#include <array>

namespace luxel::scenes {
namespace {

constexpr auto dark = Vec3d(0.0);

// Lamps are given by what a shop would print on the box. A lamp of P lumens and A square metres of skin has
// the luminance P / (179 lm/W pi A) in W/(m² sr); the tint has luminance one (Rec. 709) and the warmth of an
// incandescent bulb seen by an eye half used to it.
Vec3d warm(double lumens, double area) {
  constexpr auto tint = Vec3d(1.22, 0.97, 0.66);
  return tint * (lumens / (179.0 * 3.14159265358979 * area));
}

// The same for the whiter light of offices and museums.
Vec3d neutral(double lumens, double area) {
  constexpr auto tint = Vec3d(1.08, 0.99, 0.86);
  return tint * (lumens / (179.0 * 3.14159265358979 * area));
}

// The sky of the blue hour, by its luminance in cd/m².
Vec3d sky(double candela, const Vec3d& tint) {
  const auto luminance_of_tint = 0.2126 * tint.r + 0.7152 * tint.g + 0.0722 * tint.b;
  return tint * (candela / (179.0 * luminance_of_tint));
}

const std::array pigments = {
    Pigment{Paint::cream_wall, "cream_wall", {0.70, 0.65, 0.56}, dark},
    Pigment{Paint::terracotta_wall, "terracotta_wall", {0.50, 0.18, 0.11}, dark},
    Pigment{Paint::sage_wall, "sage_wall", {0.30, 0.40, 0.27}, dark},
    Pigment{Paint::ceiling_white, "ceiling_white", {0.80, 0.79, 0.75}, dark},
    Pigment{Paint::corridor_yellow, "corridor_yellow", {0.78, 0.56, 0.20}, dark},
    Pigment{Paint::corridor_floor, "corridor_floor", {0.34, 0.22, 0.14}, dark},
    Pigment{Paint::painted_wood, "painted_wood", {0.76, 0.74, 0.69}, dark},
    Pigment{Paint::floor_oak_1, "floor_oak_1", {0.36, 0.22, 0.12}, dark},
    Pigment{Paint::floor_oak_2, "floor_oak_2", {0.40, 0.25, 0.14}, dark},
    Pigment{Paint::floor_oak_3, "floor_oak_3", {0.33, 0.20, 0.11}, dark},
    Pigment{Paint::floor_oak_4, "floor_oak_4", {0.43, 0.28, 0.16}, dark},
    Pigment{Paint::walnut, "walnut", {0.19, 0.10, 0.055}, dark},
    Pigment{Paint::oak, "oak", {0.47, 0.31, 0.17}, dark},
    Pigment{Paint::black_steel, "black_steel", {0.06, 0.06, 0.065}, dark},
    Pigment{Paint::brass, "brass", {0.52, 0.37, 0.14}, dark},
    Pigment{Paint::teal_cloth, "teal_cloth", {0.03, 0.20, 0.30}, dark},
    Pigment{Paint::ochre_cloth, "ochre_cloth", {0.70, 0.42, 0.07}, dark},
    Pigment{Paint::coral_cloth, "coral_cloth", {0.70, 0.19, 0.13}, dark},
    Pigment{Paint::plum_cloth, "plum_cloth", {0.27, 0.06, 0.14}, dark},
    Pigment{Paint::linen_cloth, "linen_cloth", {0.68, 0.62, 0.52}, dark},
    Pigment{Paint::rug_cream, "rug_cream", {0.68, 0.61, 0.48}, dark},
    Pigment{Paint::rug_indigo, "rug_indigo", {0.06, 0.09, 0.27}, dark},
    Pigment{Paint::rug_rust, "rug_rust", {0.52, 0.15, 0.07}, dark},
    Pigment{Paint::curtain_rose, "curtain_rose", {0.62, 0.24, 0.22}, dark},
    Pigment{Paint::paper, "paper", {0.78, 0.74, 0.65}, dark},
    Pigment{Paint::paper_dark, "paper_dark", {0.10, 0.13, 0.20}, dark},
    Pigment{Paint::book_red, "book_red", {0.50, 0.06, 0.06}, dark},
    Pigment{Paint::book_blue, "book_blue", {0.06, 0.14, 0.42}, dark},
    Pigment{Paint::book_green, "book_green", {0.07, 0.27, 0.13}, dark},
    Pigment{Paint::book_yellow, "book_yellow", {0.74, 0.53, 0.09}, dark},
    Pigment{Paint::book_black, "book_black", {0.06, 0.055, 0.06}, dark},
    Pigment{Paint::book_white, "book_white", {0.74, 0.71, 0.65}, dark},
    Pigment{Paint::book_orange, "book_orange", {0.72, 0.26, 0.05}, dark},
    Pigment{Paint::porcelain, "porcelain", {0.80, 0.79, 0.76}, dark},
    Pigment{Paint::glaze_turquoise, "glaze_turquoise", {0.07, 0.38, 0.46}, dark},
    Pigment{Paint::glaze_cobalt, "glaze_cobalt", {0.05, 0.11, 0.45}, dark},
    Pigment{Paint::clay, "clay", {0.55, 0.25, 0.14}, dark},
    Pigment{Paint::soil, "soil", {0.06, 0.04, 0.03}, dark},
    Pigment{Paint::leaf_dark, "leaf_dark", {0.06, 0.24, 0.06}, dark},
    Pigment{Paint::leaf_light, "leaf_light", {0.14, 0.36, 0.08}, dark},
    Pigment{Paint::orange_peel, "orange_peel", {0.78, 0.31, 0.03}, dark},
    Pigment{Paint::plaster_white, "plaster_white", {0.78, 0.77, 0.74}, dark},
    Pigment{Paint::plaster_ochre, "plaster_ochre", {0.68, 0.50, 0.26}, dark},
    Pigment{Paint::plaster_rose, "plaster_rose", {0.66, 0.40, 0.33}, dark},
    Pigment{Paint::plaster_blue, "plaster_blue", {0.38, 0.50, 0.60}, dark},
    Pigment{Paint::plaster_green, "plaster_green", {0.44, 0.52, 0.36}, dark},
    Pigment{Paint::stone_pale, "stone_pale", {0.70, 0.65, 0.56}, dark},
    Pigment{Paint::stone_warm, "stone_warm", {0.60, 0.51, 0.40}, dark},
    Pigment{Paint::stone_grey, "stone_grey", {0.44, 0.43, 0.40}, dark},
    Pigment{Paint::stone_dark, "stone_dark", {0.20, 0.19, 0.18}, dark},
    Pigment{Paint::marble, "marble", {0.78, 0.76, 0.72}, dark},
    Pigment{Paint::brick, "brick", {0.42, 0.19, 0.12}, dark},
    Pigment{Paint::roof_tile, "roof_tile", {0.46, 0.18, 0.10}, dark},
    Pigment{Paint::slate, "slate", {0.15, 0.17, 0.20}, dark},
    Pigment{Paint::paving_1, "paving_1", {0.42, 0.40, 0.36}, dark},
    Pigment{Paint::paving_2, "paving_2", {0.36, 0.34, 0.31}, dark},
    Pigment{Paint::paving_3, "paving_3", {0.47, 0.44, 0.39}, dark},
    Pigment{Paint::asphalt, "asphalt", {0.15, 0.15, 0.16}, dark},
    Pigment{Paint::grass, "grass", {0.13, 0.26, 0.06}, dark},
    Pigment{Paint::hedge, "hedge", {0.06, 0.16, 0.05}, dark},
    Pigment{Paint::bark, "bark", {0.17, 0.11, 0.07}, dark},
    Pigment{Paint::foliage_1, "foliage_1", {0.10, 0.26, 0.06}, dark},
    Pigment{Paint::foliage_2, "foliage_2", {0.16, 0.33, 0.08}, dark},
    Pigment{Paint::blossom, "blossom", {0.72, 0.42, 0.44}, dark},
    Pigment{Paint::water, "water", {0.06, 0.14, 0.16}, dark},
    Pigment{Paint::concrete, "concrete", {0.46, 0.45, 0.43}, dark},
    Pigment{Paint::steel_grey, "steel_grey", {0.42, 0.43, 0.45}, dark},
    Pigment{Paint::plastic_white, "plastic_white", {0.74, 0.74, 0.72}, dark},
    Pigment{Paint::plastic_black, "plastic_black", {0.05, 0.05, 0.06}, dark},
    Pigment{Paint::carpet_blue, "carpet_blue", {0.10, 0.15, 0.24}, dark},
    Pigment{Paint::carpet_grey, "carpet_grey", {0.24, 0.25, 0.27}, dark},
    Pigment{Paint::linoleum, "linoleum", {0.36, 0.32, 0.22}, dark},
    Pigment{Paint::birch, "birch", {0.64, 0.50, 0.32}, dark},
    Pigment{Paint::chalkboard, "chalkboard", {0.05, 0.12, 0.09}, dark},
    Pigment{Paint::bronze, "bronze", {0.20, 0.13, 0.07}, dark},
    Pigment{Paint::tile_white, "tile_white", {0.76, 0.77, 0.75}, dark},
    Pigment{Paint::tile_green, "tile_green", {0.08, 0.26, 0.20}, dark},
    Pigment{Paint::terrazzo_1, "terrazzo_1", {0.60, 0.57, 0.52}, dark},
    Pigment{Paint::terrazzo_2, "terrazzo_2", {0.30, 0.28, 0.27}, dark},
    Pigment{Paint::glass_dark, "glass_dark", {0.07, 0.09, 0.11}, dark},
    Pigment{Paint::door_blue, "door_blue", {0.06, 0.14, 0.30}, dark},
    Pigment{Paint::door_red, "door_red", {0.42, 0.06, 0.05}, dark},
    Pigment{Paint::shutter_green, "shutter_green", {0.10, 0.26, 0.18}, dark},
    Pigment{Paint::canvas, "canvas", {0.74, 0.70, 0.60}, dark},
    Pigment{Paint::wax, "wax", {0.76, 0.70, 0.56}, dark},
    Pigment{Paint::bottle_green, "bottle_green", {0.06, 0.20, 0.08}, dark},
    Pigment{Paint::bottle_amber, "bottle_amber", {0.40, 0.18, 0.04}, dark},
    Pigment{Paint::box_white, "box_white", {0.73, 0.73, 0.73}, dark},
    Pigment{Paint::box_red, "box_red", {0.61, 0.06, 0.05}, dark},
    Pigment{Paint::box_green, "box_green", {0.12, 0.44, 0.10}, dark},
    Pigment{Paint::night_city, "night_city", {0.03, 0.03, 0.05}, dark},
    Pigment{Paint::night_city_far, "night_city_far", {0.06, 0.07, 0.12}, dark},
    Pigment{Paint::lamp_floor_bulb, "lamp_floor_bulb", {0.80, 0.80, 0.80}, warm(1100.0, 0.0254)},
    Pigment{Paint::lamp_floor_shade, "lamp_floor_shade", {0.72, 0.65, 0.52}, warm(300.0, 0.36)},
    Pigment{Paint::lamp_table_bulb, "lamp_table_bulb", {0.80, 0.80, 0.80}, warm(600.0, 0.0154)},
    Pigment{Paint::lamp_table_shade, "lamp_table_shade", {0.72, 0.62, 0.46}, warm(200.0, 0.20)},
    Pigment{Paint::lamp_pendant, "lamp_pendant", {0.80, 0.80, 0.80}, warm(1500.0, 0.0314)},
    Pigment{Paint::lamp_corridor, "lamp_corridor", {0.80, 0.80, 0.80}, warm(1600.0, 0.196)},
    Pigment{Paint::lamp_office, "lamp_office", {0.70, 0.70, 0.70}, neutral(3600.0, 0.72)},
    Pigment{Paint::lamp_monitor, "lamp_monitor", {0.05, 0.05, 0.06}, sky(180.0, {0.55, 0.75, 1.00})},
    Pigment{Paint::lamp_washer, "lamp_washer", {0.80, 0.80, 0.80}, neutral(1100.0, 0.0100)},
    Pigment{Paint::lamp_stairs, "lamp_stairs", {0.80, 0.80, 0.80}, warm(1500.0, 0.1963)},
    Pigment{Paint::lamp_cafe_bulb, "lamp_cafe_bulb", {0.80, 0.80, 0.80}, warm(900.0, 0.0314)},
    Pigment{Paint::lamp_cafe_counter, "lamp_cafe_counter", {0.80, 0.80, 0.80}, warm(2200.0, 0.20)},
    Pigment{Paint::lamp_candle, "lamp_candle", {0.80, 0.70, 0.50}, warm(14.0, 0.0016)},
    Pigment{Paint::lamp_study, "lamp_study", {0.80, 0.80, 0.80}, warm(800.0, 0.0201)},
    Pigment{Paint::lamp_box, "lamp_box", {0.78, 0.78, 0.78}, {16.5, 12.0, 5.5}},
    Pigment{Paint::window_city_lights, "window_city_lights", {0.10, 0.10, 0.10}, {0.150, 0.090, 0.032}},
    Pigment{Paint::window_sky_1, "window_sky_1", {0.05, 0.05, 0.06}, sky(14.0, {1.00, 0.60, 0.44})},
    Pigment{Paint::window_sky_2, "window_sky_2", {0.05, 0.05, 0.06}, sky(13.0, {0.84, 0.62, 0.66})},
    Pigment{Paint::window_sky_3, "window_sky_3", {0.05, 0.05, 0.06}, sky(12.0, {0.58, 0.58, 0.86})},
    Pigment{Paint::window_sky_4, "window_sky_4", {0.05, 0.05, 0.06}, sky(10.8, {0.38, 0.51, 0.96})},
    Pigment{Paint::window_sky_5, "window_sky_5", {0.05, 0.05, 0.06}, sky(9.6, {0.26, 0.43, 1.00})},
    Pigment{Paint::window_sky_6, "window_sky_6", {0.05, 0.05, 0.06}, sky(8.4, {0.19, 0.36, 1.00})},
    Pigment{Paint::window_sky_7, "window_sky_7", {0.05, 0.05, 0.06}, sky(7.4, {0.14, 0.30, 1.00})},
    Pigment{Paint::window_sky_8, "window_sky_8", {0.05, 0.05, 0.06}, sky(6.5, {0.10, 0.26, 1.00})},
};
static_assert(pigments.size() == static_cast<std::size_t>(Paint::count));

}  // namespace

std::span<const Pigment> palette() { return pigments; }

}  // namespace luxel::scenes
