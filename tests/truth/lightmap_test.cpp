// SPDX-License-Identifier: Apache-2.0
// Texels whose light is known: a furnace, surfaces in the dark behind a wall or under a box, a closed form,
// and light paths from the same points.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/core/warp.h"
#include "luxel/patch/side.h"
#include "luxel/render/dilate.h"
#include "luxel/render/gather_texels.h"
#include "luxel/render/make_lightmap.h"
#include "luxel/render/point_gather.h"
#include "luxel/render/point_irradiance.h"
#include "luxel/render/solve_seams.h"
#include "luxel/render/texel_places.h"
#include "luxel/solve/sampled.h"

#include "support/lightmap_scenes.h"
#include "support/point_factor.h"

namespace luxel {
namespace {

using test::add_box;
using test::add_room;
using test::even_light;

struct LitScene {
  PatchSet patches;
  Solution light;
};

LitScene bake(const Scene& scene, float max_edge, double error = 0.02) {
  LitScene baked{make_patches(scene, {.max_edge = max_edge}), {}};
  const Context context;
  const Tracer tracer(baked.patches, context);
  solve_sampled(baked.patches, tracer, baked.light, {.error = error, .error_measure = ErrorMeasure::power},
                context);
  return baked;
}

Lightmap lightmap_of(const LitScene& baked, LightmapOptions options, LightmapReport* report = nullptr) {
  const Context context(2);
  const Tracer tracer(baked.patches, context);
  return make_lightmap({baked.patches, baked.light, &tracer}, options, report, context);
}

// Light that a reader looks up at a place of a side.
Vec3 read(const Lightmap& map, SideId side, const Vec2& weights) {
  const auto& t = map.atlas.corners[side.index()];
  const auto at = t[0] + weights.x * (t[1] - t[0]) + weights.y * (t[2] - t[0]);
  return look_up(map.pages[map.atlas.page_of(side)].irradiance, at);
}

// Places spread over a side, corners among them; calls body(weights).
template <typename Body>
void for_places(const Body& body) {
  constexpr int steps = 4;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) body(Vec2(i, j) / static_cast<float>(steps));
}

TEST(Lightmap, of_a_furnace_is_one_on_every_texel_and_in_the_margins) {
  const auto patches = make_patches(truth::furnace(Vec3(0.2f, 0.5f, 0.8f), Vec3(0.6f)), {.max_edge = 0.15f});
  const auto map = make_lightmap({patches, even_light(patches, 1.0f)},
                                 {.texels_per_metre = 30.0, .margin = 3}, nullptr, Context(2));
  ASSERT_EQ(map.pages.size(), 1u);
  std::size_t dilated = 0;
  const auto& page = map.pages[0];
  for (std::size_t i = 0; i < page.texels.size(); ++i) {
    if (page.texels[i] == Texel::empty) {
      EXPECT_EQ(page.irradiance.pixels[i], Vec3(0.0f));
      continue;
    }
    dilated += page.texels[i] == Texel::dilated ? 1 : 0;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(page.irradiance.pixels[i][c], 1.0f, 1e-5f);
  }
  EXPECT_GT(dilated, 1000u);
}

// Gathered again at the same points, with emission, bounces and shadows. A standard error of eight replicates
// is exceeded six times with a risk of 0.05 % (Student's t with 7 degrees), 8 times with 0.01 %; few in 600
// are.
TEST(Lightmap, a_final_gather_in_a_furnace_gives_one_within_its_error) {
  const auto patches = make_patches(truth::furnace(Vec3(0.2f, 0.5f, 0.8f), Vec3(0.6f)), {.max_edge = 0.3f});
  const Context context(2);
  const Tracer tracer(patches, context);
  const auto smooth = make_smooth_light(patches, even_light(patches, 1.0f));
  const PointGather gather(patches, smooth, tracer);
  double sum = 0.0, score2 = 0.0, stated2 = 0.0;
  int count = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto found =
        gather.at(surface_point(patches, p, false, {0.3f, 0.3f}), {.error = 0.01}, mix64(p + 1));
    EXPECT_TRUE(found.reached);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(found.irradiance[c], 1.0, 8.0 * found.standard_error[c]);
      sum += found.irradiance[c] - 1.0;
      score2 += (found.irradiance[c] - 1.0) * (found.irradiance[c] - 1.0);
      stated2 += found.standard_error[c] * found.standard_error[c];
      ++count;
    }
  }
  EXPECT_NEAR(sum / count, 0.0, 0.002);
  EXPECT_LT(score2, stated2);        // which is widened for few replicates
  EXPECT_GT(score2, 0.2 * stated2);  // and no more than that
}

// A black room under a square lamp: the light of a floor point has a closed form.
double under_square_lamp(double x, double y, double half, double height) {
  // Form factor to a rectangle from below its corner: (a / sqrt(1 + a²) atan(b / sqrt(1 + a²)) + ...) / 2 pi,
  // with a, b over the height.
  const auto corner = [&](double a, double b) {
    a /= height, b /= height;
    const auto p = std::sqrt(1.0 + a * a), q = std::sqrt(1.0 + b * b);
    return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2.0 * std::numbers::pi);
  };
  return corner(half - x, half - y) + corner(half + x, half - y) + corner(half - x, half + y) +
         corner(half + x, half + y);
}

TEST(Lightmap, gathered_texels_hold_the_closed_form_where_patches_are_far_too_large) {
  truth::SceneBuilder b;
  add_room(b, {-2, -2, 0}, {2, 2, 2.5f}, 0.0f);
  b.material("lamp", 0.0f, 100.0f);
  b.quad({-0.5f, 0.5f, 1}, {0.5f, 0.5f, 1}, {0.5f, -0.5f, 1}, {-0.5f, -0.5f, 1});
  const auto baked = bake(b.scene(), 1.5f);
  LightmapReport report;
  const auto map = lightmap_of(baked, {.texels_per_metre = 8.0, .texels = {.error = 0.01}}, &report);
  EXPECT_GT(report.texels.gathered, 1000u);
  EXPECT_EQ(report.texels.short_of_it, 0u);
  double square = 0.0, light = 0.0;
  for (std::size_t p = 0; p < baked.patches.size(); ++p) {
    if (baked.patches.material_of(p).name != "floor") continue;
    const auto corners = baked.patches.points(p);
    for_places([&](const Vec2& w) {
      const auto at = corners[0] + w.x * (corners[1] - corners[0]) + w.y * (corners[2] - corners[0]);
      const auto truth = 100.0 * under_square_lamp(at.x, at.y, 0.5, 1.0);
      const auto found = static_cast<double>(read(map, SideId(p, false), w).r);
      square += (found - truth) * (found - truth);
      light += truth * truth;
      EXPECT_NEAR(found, truth, 0.06 * truth + 0.1) << at.x << ' ' << at.y;
    });
  }
  EXPECT_LT(std::sqrt(square / light), 0.02);  // the error asked for, and what runs straight between texels
}

// A floor under an even sky: what a tilted surface there gets has a closed form, (1 + cosine) / 2 of the
// whole, and a directional lightmap has it exactly, for the light vector is pi times the radiance upwards.
TEST(Lightmap, a_directional_one_knows_what_a_tilted_surface_gets_from_the_sky) {
  truth::SceneBuilder b;
  b.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0});
  auto scene = b.scene();
  scene.sky = Vec3(2.0f);
  const auto baked = bake(scene, 0.5f);
  const auto map =
      lightmap_of(baked, {.texels_per_metre = 4.0, .texels = {.error = 0.01, .directional = true}});
  ASSERT_EQ(map.pages[0].light_vector.size(), 3u);
  Vec3d sum(0.0);
  int count = 0;
  const auto places = find_texel_places(map.atlas, {}, Context(1));
  for (std::size_t i = 0; i < places[0].size(); ++i) {
    if (places[0][i].kind != Texel::inside || places[0][i].side.is_back())
      continue;  // backs see the sky below
    const Vec3d vector(map.pages[0].light_vector[0].pixels[i].g, map.pages[0].light_vector[1].pixels[i].g,
                       map.pages[0].light_vector[2].pixels[i].g);
    // Error of 64 rays or more, part of whose light has a weight of at most four; five standard deviations.
    EXPECT_LT(glm::length(vector - Vec3d(0, 0, 2.0 * std::numbers::pi)), 5.0 * 2.0 * std::numbers::pi / 8.0);
    sum += vector;
    ++count;
  }
  ASSERT_GT(count, 40);
  EXPECT_LT(glm::length(sum / static_cast<double>(count) - Vec3d(0, 0, 2.0 * std::numbers::pi)), 0.05);
}

// Under a lamp, the light vector times a tilted normal is what a surface gets that faces so, as long as the
// whole of the lamp is before it: Lambert's closed form.
TEST(Lightmap, a_directional_one_holds_the_closed_form_of_tilted_surfaces_under_a_lamp) {
  truth::SceneBuilder b;
  add_room(b, {-2, -2, 0}, {2, 2, 2.5f}, 0.0f);
  b.material("lamp", 0.0f, 100.0f);
  const std::array<Vec3, 4> lamp = {Vec3(-0.5f, 0.5f, 1), Vec3(0.5f, 0.5f, 1), Vec3(0.5f, -0.5f, 1),
                                    Vec3(-0.5f, -0.5f, 1)};
  b.quad(lamp[0], lamp[1], lamp[2], lamp[3]);
  const auto baked = bake(b.scene(), 1.5f);
  const auto map =
      lightmap_of(baked, {.texels_per_metre = 4.0, .texels = {.error = 0.005, .directional = true}});
  double square = 0.0, light = 0.0;
  for (std::size_t p = 0; p < baked.patches.size(); ++p) {
    if (baked.patches.material_of(p).name != "floor") continue;
    const auto& t = map.atlas.corners[2 * p];
    const auto& page = map.pages[map.atlas.page_of(SideId(p, false))];
    const auto corners = baked.patches.points(p);
    for_places([&](const Vec2& w) {
      const auto at = corners[0] + w.x * (corners[1] - corners[0]) + w.y * (corners[2] - corners[0]);
      if (std::abs(at.x) > 0.75f || std::abs(at.y) > 0.75f) return;
      const auto uv = t[0] + w.x * (t[1] - t[0]) + w.y * (t[2] - t[0]);
      for (const auto& n : {Vec3d(0.3, 0.0, std::sqrt(0.91)), Vec3d(-0.2, 0.3, std::sqrt(0.87))}) {
        const auto truth = 100.0 * truth::point_factor(Vec3d(at), n, truth::convex_polygon(lamp), {});
        double found = 0.0;
        for (int axis = 0; axis < 3; ++axis)
          found +=
              n[axis] * static_cast<double>(look_up(page.light_vector[static_cast<std::size_t>(axis)], uv).r);
        square += (found - truth) * (found - truth);
        light += truth * truth;
      }
    });
  }
  ASSERT_GT(light, 0.0);
  EXPECT_LT(std::sqrt(square / light), 0.03);  // the error asked for, and what runs straight between texels
}

// Light behind a wall thinner than a texel, which has a door that is shut, and under a box. Dark surfaces
// read only darkness up to their edges; lit surfaces read no darkness. Below the box, which is invisible,
// darkness begins two texels from its edges.
TEST(Lightmap, no_light_leaks_through_walls_or_under_boxes_and_no_darkness_comes_out) {
  truth::SceneBuilder b;
  add_room(b, {0, 0, 0}, {4, 4, 2}, 0.5f);
  b.material("wall", 0.5f, 0.0f);
  test::add_box(b, {2.0f, 0.0f, 0.0f}, {2.04f, 4.0f, 2.0f});
  b.material("box", 0.5f, 0.0f);
  test::add_box(b, {0.53f, 0.61f, 0.0f}, {1.27f, 1.38f, 0.5f});
  b.material("lamp", 0.5f, 10.0f);
  b.quad({0.5f, 3.5f, 1.5f}, {1.5f, 3.5f, 1.5f}, {1.5f, 2.5f, 1.5f}, {0.5f, 2.5f, 1.5f});
  const auto baked = bake(b.scene(), 0.5f, 0.05);
  const auto& patches = baked.patches;
  for (const double error : {0.0, 0.05}) {
    const auto map = lightmap_of(baked, {.texels_per_metre = 10.0, .texels = {.error = error}});
    std::size_t dark = 0, lit = 0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto middle = patches.centroid(p);
      const auto& name = patches.material_of(p).name;
      const bool behind = middle.x > 2.001f || (name == "wall" && middle.x > 2.0f && middle.x < 2.04f);
      const bool under =
          middle.x > 0.53f && middle.x < 1.27f && middle.y > 0.61f && middle.y < 1.38f && middle.z < 0.001f;
      const bool is_bottom = under && name == "box";
      for_places([&](const Vec2& w) {
        const auto found = read(map, SideId(p, false), w).r;
        const auto points = patches.points(p);
        const auto at = points[0] + w.x * (points[1] - points[0]) + w.y * (points[2] - points[0]);
        const bool well_under = at.x > 0.73f && at.x < 1.07f && at.y > 0.81f && at.y < 1.18f;
        if (under && !is_bottom && !well_under) return;
        if (behind || under) {
          EXPECT_EQ(found, 0.0f) << name << ' ' << middle.x << ' ' << middle.y << ' ' << middle.z;
          ++dark;
        } else if (name == "floor") {
          EXPECT_GT(found, 0.05f) << middle.x << ' ' << middle.y;
          ++lit;
        }
      });
    }
    EXPECT_GT(dark, 1000u);
    EXPECT_GT(lit, 1000u);
  }
}

TEST(Lightmap, both_sides_of_the_seams_of_a_sphere_agree) {
  const auto baked = bake(truth::sphere(14, 0.5f), 1.0f, 0.03);
  const Context context(2);
  const auto charts = make_charts(baked.patches, baked.light, {.texel = 0.1f}, context);
  const auto smooth = make_smooth_light(baked.patches, baked.light);
  Lightmap map;
  map.atlas = pack_charts(baked.patches, charts, {.texel = 0.1f});
  gather_texels({baked.patches, baked.light}, smooth, {}, map, context);
  const auto unsolved = map;
  const auto report = solve_seams(charts, map);
  ASSERT_GT(report.places, 300u);
  EXPECT_LT(report.difference_after, 0.001);
  for (const auto& place : find_seam_places(charts, map.atlas)) {
    const auto &a = place.sides[0], &b = place.sides[1];
    const auto one = look_up(map.pages[a.page].irradiance, a.at).g;
    const auto other = look_up(map.pages[b.page].irradiance, b.at).g;
    EXPECT_NEAR(one, other, 0.01f * std::max(one, other));
  }
  // No texel has changed more than necessary.
  for (std::size_t i = 0; i < map.pages[0].texels.size(); ++i)
    EXPECT_NEAR(map.pages[0].irradiance.pixels[i].g, unsolved.pages[0].irradiance.pixels[i].g,
                0.05f * unsolved.pages[0].irradiance.pixels[i].g + 1e-6f);
}

// Agreement within the stated errors and the effect of a texel's width: paths from the same point, without a
// solver.
TEST(Lightmap, a_room_with_a_block_has_the_light_of_paths_from_the_points) {
  truth::SceneBuilder b;
  add_room(b, {0, 0, 0}, {2, 2, 2}, 0.5f);
  b.material("block", 0.5f, 0.0f);
  test::add_box(b, {0.4f, 0.5f, 0.0f}, {1.0f, 1.2f, 0.7f});
  b.material("lamp", 0.5f, 10.0f);
  b.quad({0.7f, 1.3f, 1.9f}, {1.3f, 1.3f, 1.9f}, {1.3f, 0.7f, 1.9f}, {0.7f, 0.7f, 1.9f});
  const auto baked = bake(b.scene(), 0.2f);
  const auto& patches = baked.patches;
  const auto map = lightmap_of(baked, {.texels_per_metre = 16.0, .texels = {.error = 0.03}});

  std::vector<SurfacePoint> points;
  std::vector<Vec3> found;
  for (std::size_t p = 0; p < patches.size(); p += 7) {
    const auto middle = patches.centroid(p);  // of neither the block's hidden bottom nor the floor below it
    if (middle.z < 0.001f && middle.x > 0.4f && middle.x < 1.0f && middle.y > 0.5f && middle.y < 1.2f)
      continue;
    const auto u = uniform4(7, p);
    const auto w = uniform_triangle(u[0], u[1]);
    points.push_back(surface_point(patches, p, false, w));
    found.push_back(read(map, SideId(p, false), w));
  }
  const Context context(2);
  const Tracer tracer(patches, context);
  const auto truth = irradiance_at(patches, tracer, points, 1024, 5, context);
  double square = 0.0, light = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto d = static_cast<double>(found[i].r) - truth[3 * i];
    square += d * d;
    light += truth[3 * i] * truth[3 * i];
  }
  EXPECT_GT(points.size(), 100u);
  EXPECT_LT(std::sqrt(square / light), 0.04);
}

TEST(Lightmap, the_same_bits_on_one_and_five_threads_and_on_pages_of_any_size_much_the_same_light) {
  const auto baked = bake(truth::cube_a(), 0.3f, 0.05);
  const Tracer tracer(baked.patches, Context(1));
  const LightmapOptions options{.texels_per_metre = 12.0, .page_size = 32, .texels = {.error = 0.05}};
  const auto one = make_lightmap({baked.patches, baked.light, &tracer}, options, nullptr, Context(1));
  const auto five = make_lightmap({baked.patches, baked.light, &tracer}, options, nullptr, Context(5));
  ASSERT_GT(one.pages.size(), 1u);
  ASSERT_EQ(one.pages.size(), five.pages.size());
  for (std::size_t p = 0; p < one.pages.size(); ++p) {
    EXPECT_EQ(one.pages[p].irradiance.pixels, five.pages[p].irradiance.pixels);
    EXPECT_EQ(one.pages[p].standard_error.pixels, five.pages[p].standard_error.pixels);
    EXPECT_EQ(one.pages[p].texels, five.pages[p].texels);
  }
}

TEST(Lightmap, a_stop_among_texels_leaves_the_interpolated_light) {
  const auto baked = bake(truth::cube_a(), 0.3f, 0.05);
  const Context context(2);
  const Tracer tracer(baked.patches, context);
  LightmapReport report;
  const auto stopped = make_lightmap({baked.patches, baked.light, &tracer}, {.texels = {.error = 0.01}},
                                     &report, context.with_monitor([](const Progress& progress) {
                                       return progress.stage == "texels" ? Next::stop : Next::go_on;
                                     }));
  EXPECT_TRUE(report.texels.stopped);
  const auto plain = make_lightmap({baked.patches, baked.light}, {}, nullptr, context);
  EXPECT_EQ(stopped.pages[0].irradiance.pixels, plain.pages[0].irradiance.pixels);
}

// A lightmap with a seam, so that all stages have work.
TEST(Lightmap, a_stop_in_any_other_stage_leaves_no_pages) {
  const auto patches = make_patches(truth::sphere(14, 0.5f), {.max_edge = 1.0f});
  const auto light = even_light(patches, 1.0f);
  const Context context(2);
  std::set<std::string> stages;
  const auto note_stage = [&](const Progress& progress) {
    stages.emplace(progress.stage);
    return Next::go_on;
  };
  make_lightmap({patches, light}, {}, nullptr, context.with_monitor(note_stage));
  EXPECT_EQ(stages, (std::set<std::string>{"charts", "places", "smooth light", "seams", "margins"}));
  for (const auto& stage : stages) {
    const auto stopped =
        make_lightmap({patches, light}, {}, nullptr, context.with_monitor([&](const Progress& progress) {
          return progress.stage == stage ? Next::stop : Next::go_on;
        }));
    EXPECT_TRUE(stopped.pages.empty()) << stage;
  }
}

TEST(Lightmap, senseless_options_and_light_of_other_patches_are_refused) {
  const auto patches = make_patches(truth::cube({}), {.max_edge = 0.5f});
  const auto light = even_light(patches, 1.0f);
  const Context context(1);
  EXPECT_THROW(make_lightmap({patches, light}, {.texels_per_metre = 0.0}, nullptr, context), InputError);
  EXPECT_THROW(make_lightmap({patches, light}, {.page_size = 3}, nullptr, context), InputError);
  EXPECT_THROW(make_lightmap({patches, light}, {.texels = {.error = 2.0}}, nullptr, context), InputError);
  EXPECT_THROW(make_lightmap({patches, {}}, {}, nullptr, context), MismatchError);
}

}  // namespace
}  // namespace luxel
