// SPDX-License-Identifier: Apache-2.0
// Light through panes of glass: closed forms by quadrature over the window, the path-traced reference, and
// the energy balance.
//
// Risk. Seeds are fixed. With other random numbers one of the some hundred comparisons would be six of its
// standard errors off with a chance below one in a million, or, where the errors come from 8 replicates
// (widened by Student's t), one in ten thousand.
#include "luxel/scene/glass.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/render/path_traced.h"
#include "luxel/solve/hit_store.h"
#include "luxel/solve/sampled.h"

#include "support/glass_panes.h"
#include "support/probe_rig.h"

namespace luxel {
namespace {

using test::ProbeRig;
using truth::glazed_room;
using truth::Glazing;
using truth::SceneBuilder;
using truth::with_portals;

constexpr double sigmas = 6.0;
constexpr double exact_pi = std::numbers::pi;
const Vec3 tint(0.5f, 0.7f, 0.9f);

struct Case {
  const char* name;
  Glazing glazing;
  bool portals;
};

class Window : public testing::TestWithParam<Case> {};

TEST_P(Window, gives_a_point_the_integral_of_its_transmittance_over_the_sky) {
  const auto& [name, case_glazing, portals] = GetParam();
  const auto glazing = case_glazing;
  const auto patches = with_portals(glazed_room(glazing, tint), portals);
  EXPECT_EQ(patches.portals.empty(), !portals);
  const ProbeRig rig(patches, 0.0f);
  for (const auto& [point, normal] :
       {std::pair(Vec3(1.0f, 0.8f, 0.1f), Vec3(0, 0, 1)), std::pair(Vec3(1.7f, 0.3f, 0.4f), Vec3(0, -1, 0)),
        std::pair(Vec3(1.0f, 1.5f, 0.75f), Vec3(0, -1, 0))}) {
    const auto light = rig.at(point, normal, {.error = 0.002, .max_rays = 1u << 20});
    for (std::size_t b = 0; b < 3; ++b) {
      const auto at_normal = static_cast<double>(tint[static_cast<int>(b)]);
      const auto truth = truth::irradiance_through(Vec3d(point), Vec3d(normal), truth::window_rectangle(),
                                                   [&](const Vec3d&, double cosine) {
                                                     const auto once = pane_transmittance(at_normal, cosine);
                                                     return glazing == Glazing::doubled ? once * once : once;
                                                   });
      const auto relative = light.sampling_error / light.illuminance;
      EXPECT_NEAR(light.irradiance[b], truth, (sigmas * relative + 5e-4) * truth) << name << ", band " << b;
    }
  }
}

TEST_P(Window, gives_the_floor_the_same_by_the_solver) {
  const auto& [name, case_glazing, portals] = GetParam();
  const auto glazing = case_glazing;
  const auto patches = with_portals(glazed_room(glazing, tint), portals, 0.25f);
  const Context context(2);
  const Tracer tracer(patches, context);
  Solution light;
  const auto report =
      solve_sampled(patches, tracer, light,
                    {.error = portals ? 0.01 : 0.002, .error_measure = ErrorMeasure::power}, context);
  for (const auto& mean : report.means.surfaces) {
    if (mean.name != "floor" || mean.is_back) continue;
    for (std::size_t b = 0; b < 3; ++b) {
      const auto at_normal = static_cast<double>(tint[static_cast<int>(b)]);
      double truth = 0.0;
      constexpr int n = 24;
      for (int i = 0; i < n * n; ++i) {
        const Vec3d point(2.0 * (i % n + 0.5) / n, 2.0 * (i / n + 0.5) / n, 0.0);
        truth += truth::irradiance_through(
                     point, {0, 0, 1}, truth::window_rectangle(),
                     [&](const Vec3d&, double cosine) {
                       const auto once = pane_transmittance(at_normal, cosine);
                       return glazing == Glazing::doubled ? once * once : once;
                     },
                     40) /
                 (n * n);
      }
      EXPECT_NEAR(mean.irradiance[b], truth, sigmas * mean.standard_error[b] + 2e-3 * truth)
          << name << ", band " << b;
      EXPECT_LT(mean.standard_error[b], 0.03 * truth);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    of, Window,
    testing::Values(Case{"sheet", Glazing::sheet, false}, Case{"sheet_portal", Glazing::sheet, true},
                    Case{"box", Glazing::box, false}, Case{"box_portal", Glazing::box, true},
                    Case{"doubled", Glazing::doubled, false}, Case{"doubled_portal", Glazing::doubled, true}),
    [](const auto& of) { return std::string(of.param.name); });

// A sky that differs by direction, through tinted glass.
TEST(Glass, lets_an_overcast_sky_in_band_by_band) {
  auto scene = glazed_room(Glazing::sheet, tint);
  for (const bool portals : {false, true}) {
    auto patches = with_portals(scene, portals);
    patches.sky_patches = SkyPatches(1, {0, 0, 1}, {0, 1, 0}, LowerHalf::mirrored);
    patches.sky.clear();
    for (std::size_t p = 0; p < patches.sky_patches.size(); ++p)
      for (int b = 0; b < 3; ++b) patches.sky.push_back(0.5f + 0.02f * static_cast<float>(p % 60));
    const ProbeRig rig(patches, 0.0f);
    const Vec3 point(1.0f, 0.8f, 0.1f);
    const auto light = rig.at(point, {0, 0, 1}, {.error = 0.002, .max_rays = 1u << 20});
    for (std::size_t b = 0; b < 3; ++b) {
      const auto truth = truth::irradiance_through(
          Vec3d(point), {0, 0, 1}, truth::window_rectangle(), [&](const Vec3d& direction, double cosine) {
            const auto p = patches.sky_patches.patch_of(direction);
            return static_cast<double>(patches.sky[3 * p]) *
                   pane_transmittance(static_cast<double>(tint[static_cast<int>(b)]), cosine);
          });
      const auto relative = light.sampling_error / light.illuminance;
      EXPECT_NEAR(light.irradiance[b], truth, (sigmas * relative + 2e-3) * truth) << portals << b;
    }
  }
}

// A floor under a roof of glass that reaches far beyond it.
SceneBuilder floor_under_glass() {
  SceneBuilder builder;
  builder.material("floor", 0.0f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  builder.material("glass", 0.1f, 0.0f).quad({-9, -9, 0.5f}, {9, -9, 0.5f}, {9, 9, 0.5f}, {-9, 9, 0.5f});
  return builder;
}

TEST(Glass, dims_the_sun_by_its_transmittance_at_that_angle_exactly) {
  auto scene = floor_under_glass().scene();
  truth::make_pane(scene, "glass", tint);
  const auto direction = glm::normalize(Vec3(0.6f, 0.2f, -0.7f));
  scene.point_lights = {{.name = "sun",
                         .kind = PointLightKind::directional,
                         .direction = direction,
                         .intensity = Vec3(2.0f, 3.0f, 4.0f)}};
  const auto patches = make_patches(scene, {.max_edge = 0.5f});
  const Context context(2);
  const Tracer tracer(patches, context);
  Solution light, reference;
  const auto energy = solve_sampled(patches, tracer, light, {.error = 0.01}, context).energy;
  trace_light(patches, tracer, reference, {.limits = {.samples = 16}}, context);
  const auto probed = ProbeRig(patches, 0.0f).at({0.3f, 0.4f, 0.1f}, {0, 0, 1});
  const auto cosine = -static_cast<double>(direction.z);
  for (std::size_t b = 0; b < 3; ++b) {
    const auto i = static_cast<int>(b);
    const auto truth = static_cast<double>(scene.point_lights[0].intensity[i]) * cosine *
                       pane_transmittance(static_cast<double>(tint[i]), cosine);
    for (std::size_t p = 0; p < patches.size(); ++p) {
      EXPECT_NEAR(static_cast<double>(light.irradiance.front[3 * p + b]), truth, 1e-4 * truth);
      EXPECT_NEAR(static_cast<double>(reference.irradiance.front[3 * p + b]), truth, 1e-4 * truth);
    }
    EXPECT_NEAR(probed.irradiance[b], truth, 1e-4 * truth);
    EXPECT_NEAR(energy.from_sky[b], truth, 1e-4 * truth);  // onto 1 m²
    EXPECT_NEAR(energy.absorbed[b], truth, 1e-4 * truth);
  }
}

// A lamp of an area behind glass, by shadow rays and their control variate.
TEST(Glass, dims_a_lamp_by_the_integral_over_it) {
  auto builder = floor_under_glass();
  builder.material("lamp", 0.0f, 1.0f).quad({0, 0, 1.5f}, {0, 1, 1.5f}, {1, 1, 1.5f}, {1, 0, 1.5f});
  auto scene = builder.scene();
  truth::make_pane(scene, "glass", tint);
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  const Vec3 point(0.3f, 0.6f, 0.1f);
  const auto probed = ProbeRig(patches, 0.0f).at(point, {0, 0, 1}, {.error = 0.001, .max_rays = 1u << 18});
  for (std::size_t b = 0; b < 3; ++b) {
    const auto truth = truth::irradiance_through(
        Vec3d(point), {0, 0, 1}, {Vec3d(0, 0, 1.5), Vec3d(1, 0, 0), Vec3d(0, 1, 0)},
        [&](const Vec3d&, double cosine) {
          return pane_transmittance(static_cast<double>(tint[static_cast<int>(b)]), cosine) / exact_pi;
        });
    const auto relative = probed.sampling_error / probed.illuminance;
    EXPECT_NEAR(probed.irradiance[b], truth, (sigmas * relative + 5e-4) * truth) << b;
    EXPECT_LT(relative, 0.003);
  }
}

}  // namespace
}  // namespace luxel
