// SPDX-License-Identifier: Apache-2.0
// Windows in groups: the light lost when one is dark, against a scene in which it is a wall.
//
// Risk. Seeds are fixed. Numbers with noise are compared within six of their standard errors; with other
// random numbers one of the some twenty would fail with a chance below one in a thousand.
#include "luxel/lighting/window_groups.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/lighting/daylight_factor.h"
#include "luxel/lighting/daylight_scene.h"
#include "luxel/patch/make_patches.h"
#include "luxel/photometry/sky_integrals.h"
#include "luxel/solve/sampled.h"

#include "support/axes.h"
#include "support/glass_panes.h"
#include "support/stored_run.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

using test::up;

constexpr double sigmas = 6.0, albedo = 0.2;
const std::vector<ProbePoint> points = {
    {{1.0f, 0.6f, 0.4f}, up}, {{0.4f, 1.5f, 0.3f}, up}, {{1.7f, 1.7f, 0.2f}, up}};
const std::vector<WindowGroup> groups = {{"west", 0.1}, {"east", 0.2}};
const SkyPatches sky(1, {0, 0, 1}, {0, 1, 0});

// window_room() with two panes in its hole. A dark one is a black wall.
Scene two_windows(bool west_is_dark, bool east_is_dark) {
  auto builder = truth::window_room();
  builder.material("west", 0.0f, 0.0f)
      .quad({0.75f, 0, 0.5f}, {0.9f, 0, 0.5f}, {0.9f, 0, 1.0f}, {0.75f, 0, 1.0f})
      .material("east", 0.0f, 0.0f)
      .quad({0.9f, 0, 0.5f}, {1.25f, 0, 0.5f}, {1.25f, 0, 1.0f}, {0.9f, 0, 1.0f});
  auto scene = builder.scene();
  if (!west_is_dark) truth::make_pane(scene, "west", Vec3(0.8f));
  if (!east_is_dark) truth::make_pane(scene, "east", Vec3(0.6f));
  set_only_sky(sky, sky_patch_luminances(SkyModel::cie(16), sky, 10'000.0, albedo), scene);
  return scene;
}

// A finished run, and its coefficients.
struct WindowedRoom {
  Scene scene;
  Context context{2};
  PatchSet patches;
  Tracer tracer;
  std::shared_ptr<const SampleState> state;
  SampledOptions options;
  DaylightCoefficients open;

  explicit WindowedRoom(Scene of)
      : scene(std::move(of)), patches(made(scene, context)), tracer(patches, context) {
    options.error = 0.02;
    options.ray_budget = 4'000'000;
    options.error_measure = ErrorMeasure::power;
    state = truth::stored_run(patches, tracer, options, context).state;
    open = find_coefficients(run(), tracer, points, how, context);
  }

  DaylightRun run() const { return {patches, *state, options}; }
  WindowLight windows() const {
    return find_window_light({run(), open, points}, tracer, groups, panes_of_groups(scene, patches, groups),
                             how, context);
  }

  const CoefficientOptions how{.rays = 16384, .seed = 1};

 private:
  static PatchSet made(const Scene& scene, const Context& context) {
    auto patches = make_patches(scene, {.max_edge = 0.5f});
    set_portals(scene, patches, context);
    return patches;
  }
};

void expect_same_factors(const DaylightCoefficients& a, const DaylightCoefficients& b,
                         const std::string& what) {
  const auto x = daylight_factors(a, 16, albedo), y = daylight_factors(b, 16, albedo);
  for (std::size_t m = 0; m < points.size(); ++m)
    EXPECT_NEAR(double{x.value[m]}, double{y.value[m]},
                sigmas * std::hypot(double{x.standard_error[m]}, double{y.standard_error[m]}) +
                    1e-3 * double{y.value[m]})
        << what << ", point " << m;
}

TEST(WindowGroups, a_dark_window_is_a_black_wall) {
  const WindowedRoom room(two_windows(false, false));
  const auto light = room.windows();
  ASSERT_EQ(light.without.size(), 2u);
  expect_same_factors(light.without[0], WindowedRoom(two_windows(true, false)).open, "west is dark");
  expect_same_factors(light.without[1], WindowedRoom(two_windows(false, true)).open, "east is dark");
}

// Light that comes in through one window and, reflected by nothing outside, cannot return through another
// one.
TEST(WindowGroups, divide_the_light_where_nothing_outside_returns_it) {
  const WindowedRoom room(two_windows(false, false));
  const auto light = room.windows();
  const auto whole = daylight_factors(room.open, 16, albedo);
  const auto without_west = daylight_factors(light.without[0], 16, albedo);
  const auto without_east = daylight_factors(light.without[1], 16, albedo);
  for (std::size_t m = 0; m < points.size(); ++m) {
    const auto west = double{whole.value[m]} - double{without_west.value[m]};
    const auto east = double{whole.value[m]} - double{without_east.value[m]};
    EXPECT_GT(west, 0.0);
    EXPECT_GT(east, west) << "it is larger";
    EXPECT_NEAR(west + east, double{whole.value[m]}, 0.02 * double{whole.value[m]});
  }
  // Panes absorb what they do not transmit, from inside too: closing one changes nothing for the other one.
  EXPECT_NEAR(light.twice, 0.0, 5e-3);
}

TEST(WindowGroups, are_found_by_names_and_refused_without_glass) {
  auto scene = two_windows(false, false);
  const auto patches = make_patches(scene, {.max_edge = 0.5f});
  const auto panes = panes_of_groups(scene, patches, groups);
  ASSERT_EQ(panes.size(), 2u);
  EXPECT_EQ(panes[0].size(), 2u);
  EXPECT_EQ(panes[1].size(), 2u);
  const std::vector<WindowGroup> all = {{"*st", 0.1}}, twice = {{"west", 0.1}, {"w*", 0.1}},
                                 none = {{"n", 0.1}};
  EXPECT_EQ(panes_of_groups(scene, patches, all)[0].size(), 4u);
  EXPECT_THROW(panes_of_groups(scene, patches, twice), InputError);
  EXPECT_THROW(make_panes_of_groups(none, scene), InputError);
  auto walled = two_windows(true, true);
  EXPECT_THROW(make_panes_of_groups(groups, walled), InputError);
}

// Glass that lets all light pass becomes a pane, and so can have blinds.
TEST(WindowGroups, clear_glass_can_have_blinds) {
  auto scene = two_windows(false, false);
  for (auto& material : scene.materials)
    if (!material.opaque) material.transmittance = Vec3(1.0f);
  EXPECT_TRUE(make_patches(scene, {.max_edge = 0.5f}).panes.empty());
  make_panes_of_groups(groups, scene);
  const auto patches = make_patches(scene, {.max_edge = 0.5f});
  EXPECT_EQ(patches.panes.size(), 4u);
  EXPECT_NEAR(double{patches.materials[static_cast<std::size_t>(patches.panes[0].material)].transmittance[0]},
              1.0, 2e-5);
}

}  // namespace
}  // namespace luxel
