// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/seen_measure.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// Walls of a cube from `low` to `high` in all three coordinates, seen from inside.
void add_walls(truth::SceneBuilder& builder, float low, float high) {
  const auto a = low, b = high;
  builder.quad({a, a, a}, {b, a, a}, {b, b, a}, {a, b, a})
      .quad({a, b, b}, {b, b, b}, {b, a, b}, {a, a, b})
      .quad({a, a, a}, {a, b, a}, {a, b, b}, {a, a, b})
      .quad({b, a, b}, {b, b, b}, {b, b, a}, {b, a, a})
      .quad({a, a, b}, {b, a, b}, {b, a, a}, {a, a, a})
      .quad({a, b, a}, {b, b, a}, {b, b, b}, {a, b, b});
}

// A closed box stands in a room; the box inside is dark, and no view meets it. All sides are one unit here,
// so that what the views look at is believed of them all.
TEST(SeenMeasure, a_dark_side_that_is_hidden_counts_no_more_than_bright_ones_that_are_seen) {
  truth::SceneBuilder builder;
  builder.material("room", 0.5f, 0.0f);
  add_walls(builder, 0.0f, 3.0f);
  builder.material("box", 0.5f, 0.0f);
  add_walls(builder, 1.2f, 1.8f);
  builder.material("lamp", 0.0f, 10.0f).quad({1, 2, 2.9f}, {2, 2, 2.9f}, {2, 1, 2.9f}, {1, 1, 2.9f});
  const auto patches = make_patches(builder.scene(), {.max_edge = 0.5f});
  const Context context{2};
  const Tracer tracer(patches, context);
  const auto sides = all_gather_sides(patches, make_patch_tree(patches, context));
  const std::vector<std::uint32_t> one_unit{0, static_cast<std::uint32_t>(sides.size())};
  SeenMeasure measure(patches, sides, one_unit, tracer, context, SeenMeasure::Pooling::unit);
  ASSERT_TRUE(measure.has_views());

  const auto is_hidden = [&](SideId side) {
    return !side.is_back() && patches.material_of(side.patch()).name == "box";
  };
  const auto bands = patches.band_count();
  Spread answer;
  for (const auto side : sides.side)
    for (std::size_t b = 0; b < bands; ++b) {
      answer.mean.push_back(is_hidden(side) ? 0.001f : 10.0f);
      answer.standard_error.push_back(0.1f);
      answer.squared_error.push_back(0.01f);
    }
  measure.take(answer, context);

  double hidden = 0.0, shown = 0.0;  // the largest importance per area
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto patch = sides.side[s].patch();
    const auto density = measure.importance()[s] / static_cast<double>(patches.area[patch]);
    auto& largest = is_hidden(sides.side[s]) ? hidden : shown;
    largest = std::max(largest, density);
  }
  EXPECT_GT(hidden, 0.0);
  EXPECT_LE(hidden, 1.001 * shown) << "at their own brightness alone they would count 400 times as much";
}

// A camera looks straight at one wall of a cube in even light; that wall alone is known well. There
// s / (L + 0.05 a) is the standard error over 1.05 of the light.
TEST(SeenMeasure, the_error_in_a_picture_is_of_what_the_camera_sees) {
  truth::SceneBuilder builder;
  builder.material("room", 0.5f, 0.0f);
  add_walls(builder, 0.0f, 3.0f);
  const auto patches = make_patches(builder.scene(), {.max_edge = 0.5f});
  const Tracer tracer(patches, Context{2});
  Solution solution;
  const auto bands = patches.band_count();
  const std::vector<float> light(patches.size() * bands, 8.0f);
  solution.irradiance = {light, light};
  solution.standard_error = {light, light};
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t b = 0; b < bands; ++b)
      if (patches.normal[p].x > 0.5f) solution.standard_error.front[p * bands + b] = 0.8f;
  const Camera at_wall{
      .eye = {2.9f, 1.5f, 1.5f}, .target = {0, 1.5f, 1.5f}, .up = {0, 1, 0}, .vertical_fov = 30};
  EXPECT_NEAR(picture_error_of(patches, tracer, solution, at_wall), 0.1 / 1.05, 1e-6);
  const Camera away{
      .eye = {0.1f, 1.5f, 1.5f}, .target = {3, 1.5f, 1.5f}, .up = {0, 1, 0}, .vertical_fov = 30};
  EXPECT_NEAR(picture_error_of(patches, tracer, solution, away), 1.0 / 1.05, 1e-6);
  solution.standard_error = {};
  EXPECT_EQ(picture_error_of(patches, tracer, solution, away), 0.0) << "not known";
}

}  // namespace
}  // namespace luxel
