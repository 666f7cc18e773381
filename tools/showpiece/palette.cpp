// SPDX-License-Identifier: Apache-2.0
#include "showpiece/palette.h"

#include <array>

namespace luxel::showpiece {
namespace {

constexpr auto dark = Vec3d(0.0);

// Lamps are given by what a shop would print on the box. A lamp of P lumens and A square metres of skin has
// the luminance P / (179 lm/W pi A) in W/(m² sr); the tint has luminance one (Rec. 709) and the warmth of an
// incandescent bulb seen by an eye half used to it.
Vec3d warm(double lumens, double area) {
  constexpr auto tint = Vec3d(1.22, 0.97, 0.66);
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
    Pigment{Paint::night_city, "night_city", {0.03, 0.03, 0.05}, dark},
    Pigment{Paint::night_city_far, "night_city_far", {0.06, 0.07, 0.12}, dark},
    Pigment{Paint::lamp_floor_bulb, "lamp_floor_bulb", {0.80, 0.80, 0.80}, warm(1100.0, 0.0254)},
    Pigment{Paint::lamp_floor_shade, "lamp_floor_shade", {0.72, 0.65, 0.52}, warm(300.0, 0.36)},
    Pigment{Paint::lamp_table_bulb, "lamp_table_bulb", {0.80, 0.80, 0.80}, warm(600.0, 0.0154)},
    Pigment{Paint::lamp_table_shade, "lamp_table_shade", {0.72, 0.62, 0.46}, warm(200.0, 0.20)},
    Pigment{Paint::lamp_pendant, "lamp_pendant", {0.80, 0.80, 0.80}, warm(1500.0, 0.0314)},
    Pigment{Paint::lamp_corridor, "lamp_corridor", {0.80, 0.80, 0.80}, warm(1600.0, 0.196)},
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

}  // namespace luxel::showpiece
