// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/render.h"

#include <cmath>
#include <cstring>
#include <thread>

#include <gtest/gtest.h>

#include "luxel/core/error.h"

#include "support/lit_rooms.h"

namespace luxel {
namespace {

using test::LitPatches;
using test::plain_material;

Image picture(const LitPatches& lit, const Camera& camera, const RenderOptions& options, int threads = 2,
              const Monitor& monitor = {}) {
  const auto context = Context(threads).with_monitor(monitor);
  const Tracer tracer(lit.patches, context);
  return render(lit.patches, make_smooth_light(lit.patches, lit.solution), tracer, camera, options, context);
}

// A closed lit box, with the eye inside.
LitPatches lit_box(float reflectance = 0.5f, float irradiance = 3.0f) {
  LitPatches lit({plain_material("wall", reflectance)});
  test::add_box(lit, Vec3(-1.0f), Vec3(1.0f), test::Facing::inwards, irradiance);
  return lit;
}

// One square metre at z = 0 that faces +z.
LitPatches square(const BandMaterial& material, float front, float back) {
  LitPatches lit({material});
  test::add_plate(lit, {-0.5f, -0.5f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 1, front, back);
  return lit;
}

// Two plates at z = 0 that face +z, with a gap between them along the x-axis, of this width in metres.
LitPatches two_plates(float gap) {
  LitPatches lit({plain_material("paint", 0.5f)});
  const Vec3 along(2.0f, 0.05f, 0.0f), across(0.0f, 1.0f, 0.0f);
  test::add_plate(lit, {-1.0f, -1.025f - 0.5f * gap, 0.0f}, along, across, 1, 2.0f, 0.0f);
  test::add_plate(lit, {-1.0f, -0.025f + 0.5f * gap, 0.0f}, along, across, 1, 2.0f, 0.0f);
  return lit;
}

constexpr RenderOptions small = {.width = 40, .height = 30};
const Camera before = {.eye = {0.0f, 0.0f, 0.5f}, .target = Vec3(0.0f)};
const Camera behind = {.eye = {0.0f, 0.0f, -0.5f}, .target = Vec3(0.0f)};

TEST(Render, a_uniformly_lit_box_has_the_radiance_rho_H_over_pi_everywhere) {
  const auto image =
      picture(lit_box(0.4f, 3.0f), {.eye = {0.3f, 0.1f, 0.2f}, .target = {-1.0f, -0.4f, -1.0f}},
              {.width = 64, .height = 48});
  ASSERT_EQ(image.pixels.size(), 64u * 48u);
  const auto expected = 0.4f * 3.0f / pi;
  for (const auto& pixel : image.pixels)
    for (int band = 0; band < 3; ++band) ASSERT_NEAR(pixel[band], expected, 1e-6f * expected);
}

// A lamp of 1 m x 1 m that faces an eye 2 m away covers (30 / (4 tan 30°))² pixels of a picture 30 pixels
// high. Jittered samples, 64 per pixel on its 52 pixels of edge, leave 0.05 % of standard error or less.
TEST(Render, the_edges_of_a_bright_lamp_are_smooth_after_the_tone_curve) {
  const auto lamp = square(plain_material("lamp", 0.0f, true, 1e4f), 0.0f, 0.0f);
  const Camera camera{.eye = {0.03f, 0.02f, 2.0f}, .target = {0.03f, 0.02f, 0.0f}, .vertical_fov = 60.0f};
  const Tracer tracer(lamp.patches);
  for (const int side : {1, 8, 16}) {
    const auto seen = render_picture(lamp.patches, make_smooth_light(lamp.patches, lamp.solution), tracer,
                                     camera, {.width = 40, .height = 30, .samples_per_side = side});
    const auto shown = tone_map(seen.radiance, {.op = ToneOperator::clamp, .scale = 1.0f}, seen.edges);
    double covered = 0.0;
    for (const auto& pixel : shown.pixels) covered += pixel.g;
    const double edge = 30.0 / (4.0 * std::tan(pi / 6.0));
    EXPECT_NEAR(covered, edge * edge, (side == 1 ? 0.1 : 0.005) * edge * edge) << side;
    EXPECT_EQ(seen.edges.pixels.empty(), side == 1);
  }
}

// A level view over nothing: the horizon is in the middle of the picture, the zenith out of it.
TEST(Render, displays_show_the_sky_with_a_horizon_and_files_its_radiance) {
  auto plate = square(plain_material("plate", 0.5f), 2.0f, 2.0f);
  plate.patches.sky = {3.0f, 3.0f, 3.0f};
  const Tracer tracer(plate.patches);
  const Camera level{.eye = {0.0f, 5.0f, 0.0f}, .target = {0.0f, 5.0f, 1.0f}, .vertical_fov = 90.0f};
  const auto seen =
      render_picture(plate.patches, make_smooth_light(plate.patches, plate.solution), tracer, level, small);
  ASSERT_EQ(seen.sky.pixels.size(), 40u * 30u);
  for (const auto& pixel : seen.radiance.pixels) EXPECT_EQ(pixel, Vec3(3.0f));
  const auto row = [&](int y) { return seen.sky.radiance[static_cast<std::size_t>(40 * y + 20)]; };
  EXPECT_GT(row(14).g, 0.9f * 3.0f);            // 2 degrees above the horizon
  EXPECT_NEAR(row(29).g, 0.75f * 3.0f, 1e-5f);  // ground in a haze
  EXPECT_EQ(row(29).r, row(29).b);
  EXPECT_GT(row(0).b, 1.3f * row(0).r);  // blue above
  for (int y = 1; y < 14; ++y) EXPECT_GT(row(y).r, row(y - 1).r) << y;
}

// The plate covers a part of the picture; with_sky() finds the rest by the same rays.
TEST(Render, a_picture_that_was_made_otherwise_gets_the_same_sky) {
  auto plate = square(plain_material("plate", 0.5f), 2.0f, 2.0f);
  plate.patches.sky = {1.0f, 2.0f, 3.0f};
  const Tracer tracer(plate.patches);
  const Camera camera{.eye = {0.1f, 0.2f, 2.0f}, .target = {0.1f, 0.2f, 0.0f}};
  auto even = small;
  even.samples_per_side = 8;  // as many on edges
  const auto seen =
      render_picture(plate.patches, make_smooth_light(plate.patches, plate.solution), tracer, camera, even);
  const auto other = with_sky(seen.radiance, plate.patches, tracer, camera, even);
  EXPECT_EQ(other.sky.pixels, seen.sky.pixels);
  EXPECT_EQ(other.sky.fraction, seen.sky.fraction);
  EXPECT_LT(seen.sky.pixels.size(), seen.radiance.pixels.size());
  for (std::size_t i = 0; i < seen.sky.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(other.sky.radiance[i][c], seen.sky.radiance[i][c], 1e-5f * seen.sky.radiance[i][c]);
  EXPECT_TRUE(with_sky(seen.radiance, square(plain_material("plate", 0.5f), 2.0f, 2.0f).patches, tracer,
                       camera, small)
                  .sky.pixels.empty());
}

// A crack of 0.07 pixels between two bright plates, not quite along the rows. The 3 columns of samples of a
// coarse pixel miss it with a probability of 0.79 each, the 6 of a fine one with 0.58: 49 % of the pixels
// would show nothing of it, and 4 % do.
TEST(Render, a_crack_thinner_than_a_pixel_is_a_line_and_not_dots) {
  auto lit = two_plates(0.002f);
  const Tracer tracer(lit.patches);
  const Camera camera{.eye = {0.0f, 0.0f, 1.0f}, .target = Vec3(0.0f), .vertical_fov = 60.0f};
  const auto seen = render_picture(lit.patches, make_smooth_light(lit.patches, lit.solution), tracer, camera,
                                   {.width = 40, .height = 40});
  const auto bright = seen.radiance.at(20, 5).g;
  double sum = 0.0;
  int empty = 0;
  for (int x = 5; x < 35; ++x) {
    float dark = 0.0f;  // part of a column that is dark, in pixels
    for (int y = 15; y < 25; ++y) dark += 1.0f - seen.radiance.at(x, y).g / bright;
    if (dark == 0.0f) ++empty;
    sum += static_cast<double>(dark);
  }
  EXPECT_NEAR(sum / 30.0, 0.07, 0.02);
  EXPECT_LE(empty, 4);
}

TEST(Render, a_lamp_shows_its_emission_from_the_front_and_only_reflects_from_behind) {
  const auto lamp = square(plain_material("lamp", 0.5f, true, 10.0f), 2.0f, 4.0f);
  EXPECT_NEAR(picture(lamp, before, small).at(20, 15).g, (10.0f + 0.5f * 2.0f) / pi, 1e-5f);
  EXPECT_NEAR(picture(lamp, behind, small).at(20, 15).g, 0.5f * 4.0f / pi, 1e-5f);
}

TEST(Render, the_back_of_a_one_sided_surface_is_black) {
  const auto wall = square(plain_material("wall", 0.5f, false, 10.0f), 2.0f, 4.0f);
  EXPECT_GT(picture(wall, before, small).at(20, 15).g, 0.0f);
  EXPECT_EQ(picture(wall, behind, small).at(20, 15), Vec3(0.0f));
}

TEST(Render, nothing_seen_is_zero) {
  const auto image = picture(lit_box(), {.eye = {0.0f, 0.0f, 5.0f}, .target = {0.0f, 0.0f, 9.0f}}, small);
  for (const auto& pixel : image.pixels) EXPECT_EQ(pixel, Vec3(0.0f));
}

// A pinhole at distance d shows an area A that is parallel to the picture on A (h / (2 d tan(fov/2)))²
// pixels.
TEST(Render, a_triangle_covers_as_many_pixels_as_the_pinhole_formula_says) {
  LitPatches lit({plain_material("paint", 0.5f)});
  const auto a = lit.vertex({-0.4f, -0.3f, 0.0f});
  const auto b = lit.vertex({0.5f, -0.2f, 0.0f});
  const auto c = lit.vertex({0.1f, 0.6f, 0.0f});
  lit.patch({a, b, c}, pi / 0.5f);  // radiance 1
  for (const auto fov : {20.0f, 60.0f, 100.0f}) {
    const auto distance = 0.8f / std::tan(fov * pi / 360.0f);
    const auto image =
        picture(lit, {.eye = {0.0f, 0.0f, distance}, .target = Vec3(0.0f), .vertical_fov = fov},
                {.width = 320, .height = 240});
    double covered = 0.0;
    for (const auto& pixel : image.pixels) covered += static_cast<double>(pixel.r);
    const auto expected = static_cast<double>(lit.patches.area[0]) * std::pow(240.0 / (2.0 * 0.8), 2.0);
    EXPECT_NEAR(covered, expected, 0.003 * expected) << "field of view " << fov;
  }
}

TEST(Render, left_is_left_and_up_is_up) {
  LitPatches lit({plain_material("paint", 0.5f)});
  test::add_plate(lit, {-0.4f, 0.1f, 0.0f}, {0.2f, 0.0f, 0.0f}, {0.0f, 0.2f, 0.0f}, 1, 1.0f);
  const auto image = picture(lit, {.eye = {0.0f, 0.0f, 1.0f}, .target = Vec3(0.0f), .vertical_fov = 90.0f},
                             {.width = 100, .height = 100});
  // x = -0.3 and y = 0.2 of a picture that spans -1 to 1.
  EXPECT_GT(image.at(35, 40).r, 0.0f);
  EXPECT_EQ(image.at(64, 40), Vec3(0.0f));
  EXPECT_EQ(image.at(35, 59), Vec3(0.0f));
}

TEST(Render, irradiance_runs_linearly_between_the_corners) {
  auto lit = square(plain_material("paint", 0.5f), 0.0f, 0.0f);
  auto light = make_smooth_light(lit.patches, lit.solution);
  for (std::size_t i = 0; i < light.size(); ++i)
    for (std::size_t band = 0; band < 3; ++band)
      light.irradiance.front[3 * i + band] = lit.patches.vertices[light.vertex[i]].x + 0.5f;

  const Context context(2);
  const Tracer tracer(lit.patches, context);
  // The picture's sides are the square's.
  const auto image = render(lit.patches, light, tracer,
                            {.eye = {0.0f, 0.0f, 0.5f}, .target = Vec3(0.0f), .vertical_fov = 90.0f},
                            {.width = 50, .height = 50, .samples_per_side = 4}, context);
  for (int x = 0; x < 50; ++x)
    EXPECT_NEAR(image.at(x, 20).b * pi / 0.5f, (static_cast<float>(x) + 0.5f) / 50.0f, 0.25f / 50.0f);
}

TEST(Render, the_same_bytes_on_one_two_and_seven_threads) {
  auto lit = lit_box();
  for (std::size_t i = 0; i < lit.solution.irradiance.front.size(); ++i)
    lit.solution.irradiance.front[i] += static_cast<float>(i % 7);
  const Camera camera = {.eye = {0.3f, 0.1f, 0.2f}, .target = {-1.0f, -0.4f, -1.0f}};
  const auto one = picture(lit, camera, {.width = 160, .height = 120}, 1);
  for (const auto threads : {2, 7}) {
    const auto many = picture(lit, camera, {.width = 160, .height = 120}, threads);
    EXPECT_EQ(std::memcmp(one.pixels.data(), many.pixels.data(), one.pixels.size() * sizeof(Vec3)), 0)
        << threads << " threads";
  }
}

TEST(Render, a_stop_leaves_the_rows_not_yet_done_black) {
  int calls = 0;
  double last = -1.0;
  bool elsewhere = false;
  const auto caller = std::this_thread::get_id();
  const auto image = picture(lit_box(), {.eye = Vec3(0.0f), .target = {1.0f, 0.3f, 0.2f}},
                             {.width = 256, .height = 64, .samples_per_side = 8}, 2, [&](const Progress& p) {
                               elsewhere |= std::this_thread::get_id() != caller;
                               EXPECT_GT(p.done, last);
                               last = p.done;
                               return ++calls == 3 ? Next::stop : Next::go_on;
                             });
  EXPECT_FALSE(elsewhere);
  ASSERT_EQ(image.pixels.size(), 256u * 64u);
  ASSERT_GT(last, 0.0);
  ASSERT_LT(last, 1.0);
  const auto done = static_cast<int>(std::lround(last * 64));
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 256; ++x) ASSERT_EQ(image.at(x, y).r > 0.0f, y < done) << x << ", " << y;
}

void refuse(const Camera& camera, const RenderOptions& options, const std::string& words) {
  try {
    picture(lit_box(), camera, options);
    FAIL() << "accepted, but should say: " << words;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Render, a_camera_that_sees_nothing_definite_is_refused_with_the_reason) {
  refuse({.eye = Vec3(1.0f), .target = Vec3(1.0f)}, small, "eye and target");
  refuse({.eye = Vec3(0.0f), .target = {0.0f, -2.0f, 0.0f}}, small, "up");
  refuse({.up = Vec3(0.0f)}, small, "up");
  refuse({.eye = {NAN, 0.0f, 0.0f}}, small, "finite");
  refuse({.eye = {1e30f, 0.0f, 0.0f}}, small, "origin");
  refuse({.vertical_fov = 0.0f}, small, "field of view");
  refuse({.vertical_fov = 180.0f}, small, "field of view");
  refuse({.vertical_fov = NAN}, small, "field of view");
  refuse({}, {.width = 0}, "pixels");
  refuse({}, {.height = 32769}, "pixels");
  refuse({}, {.width = 4, .height = 4, .samples_per_side = 0}, "samples_per_side");
}

TEST(Render, light_of_another_scene_is_refused) {
  const auto lit = lit_box();
  const Context context(1);
  const Tracer tracer(lit.patches, context);
  EXPECT_THROW(render(lit.patches, SmoothLight{}, tracer, {}, small, context), MismatchError);
}

TEST(Render, up_may_have_any_length) {
  const Camera camera = {.eye = Vec3(0.0f), .target = {1.0f, 0.3f, 0.2f}};
  auto longer = camera;
  longer.up = {0.0f, 1024.0f, 0.0f};
  EXPECT_EQ(picture(lit_box(), camera, small).pixels, picture(lit_box(), longer, small).pixels);
}

}  // namespace
}  // namespace luxel
