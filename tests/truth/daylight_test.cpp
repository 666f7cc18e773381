// SPDX-License-Identifier: Apache-2.0
// Skies that differ by direction, and the sun: closed forms, and agreement of the solver with path tracing.
//
// Risk. Seeds are fixed. Numbers with noise are compared within six of their standard errors; with other
// random numbers one of the some hundred would fail with a chance below one in a thousand.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/import/set_daylight.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/photometry/sky_integrals.h"
#include "luxel/render/compare.h"
#include "luxel/render/path_traced.h"
#include "luxel/render/probe_light.h"
#include "luxel/scene/luminous_efficacy.h"
#include "luxel/solve/sampled.h"

#include "support/axes.h"
#include "support/probe_rig.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

using test::east;
using test::north;
using test::ProbeRig;
using test::south;
using test::up;
using test::west;
using truth::SceneBuilder;

constexpr double sigmas = 6.0, sky_lux = 10'000.0;

Daylight cie(int type, double elevation = 30.0, double azimuth = 180.0) {
  Daylight d;
  d.sky = Daylight::Sky::cie;
  d.cie_type = type;
  d.sun = Daylight::Sun{elevation, azimuth};
  d.sun_illuminance = 0.0;
  d.albedo = 0.0;
  return d;
}

Scene under(const SceneBuilder& builder, const Daylight& daylight) {
  auto scene = builder.scene();
  set_daylight(daylight, up, scene);
  return scene;
}

double lux_of(const std::vector<float>& irradiance, std::size_t patch) {
  return luminous_efficacy * static_cast<double>(irradiance[3 * patch + 1]);
}

class EveryCieType : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(all, EveryCieType, testing::Range(1, 17));

// An open plate has the requested illuminance, and walls have those of the model's integrals.
TEST_P(EveryCieType, lights_open_planes_as_its_integrals_say) {
  SceneBuilder b;
  b.material("far", 0.0f, 0.0f).quad({-1, -1, -9}, {1, -1, -9}, {1, 1, -9}, {-1, 1, -9});
  const auto daylight = cie(GetParam());
  const ProbeRig rig(under(b, daylight), no_max_edge, 0.0f);
  const auto model = SkyModel::cie(GetParam(), {0.0, -std::cos(std::numbers::pi / 6), 0.5});
  const auto relative = relative_illuminances(model);
  const auto scale = sky_lux / relative.horizontal;
  const auto expect = [&](const Vec3& normal, double truth) {
    const auto light = rig.at({0, 0, 0}, normal, {.error = 0.004, .max_rays = 1u << 20});
    EXPECT_NEAR(light.illuminance, truth, sigmas * light.sampling_error + 2e-4 * truth);
  };
  expect(up, sky_lux);
  expect(north, scale * relative.north);
  expect(east, scale * relative.east);
  expect(south, scale * relative.south);
  expect(west, scale * relative.west);
}

// A black box with a window or a skylight: sky components in closed form (Hopkinson, Petherbridge and
// Longmore 1966; see docs/daylight.md), at a point opposite the lower left corner of the window.
struct Opening {
  double width, height;  // over the distance of the point
  double even, overcast;
};

SceneBuilder black_box(const Vec3& low, const Vec3& high) {
  SceneBuilder b;
  b.material("black", 0.0f, 0.0f)
      .quad({low.x, low.y, low.z}, {high.x, low.y, low.z}, {high.x, high.y, low.z}, {low.x, high.y, low.z})
      .quad({low.x, high.y, low.z}, {high.x, high.y, low.z}, {high.x, high.y, high.z},
            {low.x, high.y, high.z})
      .quad({low.x, low.y, low.z}, {low.x, high.y, low.z}, {low.x, high.y, high.z}, {low.x, low.y, high.z})
      .quad({high.x, low.y, low.z}, {high.x, low.y, high.z}, {high.x, high.y, high.z},
            {high.x, high.y, low.z});
  return b;
}

// A frame of black quads around the hole [0, w] x [0, h] of a rectangle; at(u, v) are its points.
template <typename At>
void add_frame(SceneBuilder& b, float w, float h, float low, float high, const At& at) {
  b.quad(at(low, low), at(high, low), at(high, 0.0f), at(low, 0.0f));
  b.quad(at(low, h), at(high, h), at(high, high), at(low, high));
  b.quad(at(low, 0.0f), at(0.0f, 0.0f), at(0.0f, h), at(low, h));
  b.quad(at(w, 0.0f), at(high, 0.0f), at(high, h), at(w, h));
}

void expect_sky_component(const SceneBuilder& builder, const Vec3& at, const Daylight& sky, double truth) {
  auto scene = under(builder, sky);
  auto patches = make_patches(scene, {.max_edge = no_max_edge});
  set_portals(scene, patches, {});
  const Tracer tracer(patches);
  Solution dark;
  dark.bands = patches.bands;
  for (auto* array :
       {&dark.irradiance.front, &dark.irradiance.back, &dark.radiosity.front, &dark.radiosity.back})
    array->assign(patches.size() * 3, 0.0f);
  const SolutionProbe probe(patches, dark, tracer);
  const std::vector<ProbePoint> points = {{at, up}};
  const auto light = probe_light(probe, points, {.error = 0.001, .max_rays = 1u << 21}, {});
  EXPECT_NEAR(light[0].illuminance / sky_lux, truth,
              sigmas * light[0].sampling_error / sky_lux + 5e-4 * truth);
}

class SkyComponent : public testing::TestWithParam<Opening> {};

TEST_P(SkyComponent, through_a_window_is_the_closed_form) {
  const auto [w, h, even, overcast] = GetParam();
  auto b = black_box({-2, 0, -2}, {4, 3, 4});
  b.quad({-2, 0, 4}, {-2, 3, 4}, {4, 3, 4}, {4, 0, 4});
  add_frame(b, static_cast<float>(w), static_cast<float>(h), -2.0f, 4.0f,
            [](float u, float v) { return Vec3(u, 0.0f, v); });
  auto uniform = cie(16);
  uniform.sky = Daylight::Sky::uniform;
  expect_sky_component(b, {0, 1, 0}, uniform, even);
  expect_sky_component(b, {0, 1, 0}, cie(16), overcast);
}

INSTANTIATE_TEST_SUITE_P(of, SkyComponent,
                         testing::Values(Opening{1.0, 1.0, 0.05573420, 0.04525138},
                                         Opening{0.5, 0.75, 0.02534423, 0.01935519},
                                         Opening{2.0, 0.3, 0.01009251, 0.00577524}));

class Skylight : public testing::TestWithParam<Opening> {};

TEST_P(Skylight, gives_the_closed_form) {
  const auto [w, h, even, overcast] = GetParam();
  auto b = black_box({-2, -2, -1}, {4, 4, 1});
  b.quad({-2, -2, -1}, {-2, -2, 1}, {4, -2, 1}, {4, -2, -1});
  add_frame(b, static_cast<float>(w), static_cast<float>(h), -2.0f, 4.0f,
            [](float u, float v) { return Vec3(u, v, 1.0f); });
  auto uniform = cie(16);
  uniform.sky = Daylight::Sky::uniform;
  expect_sky_component(b, {0, 0, 0}, uniform, even);
  expect_sky_component(b, {0, 0, 0}, cie(16), overcast);
}

INSTANTIATE_TEST_SUITE_P(of, Skylight,
                         testing::Values(Opening{1.0, 1.0, 0.13853161, 0.15949725},
                                         Opening{0.5, 0.75, 0.07839179, 0.09478101},
                                         Opening{2.0, 0.3, 0.06881993, 0.08016050}));

Daylight clear_with_sun(double azimuth) {
  auto d = cie(12, 35.0, azimuth);
  d.sun_illuminance.reset();
  d.albedo = 0.2;
  return d;
}

PatchSet room_patches(const SceneBuilder& builder, const Daylight& daylight) {
  return make_patches(under(builder, daylight), {.max_edge = 0.5f});
}

Solution solved(const PatchSet& patches, EnergyBalance* energy = nullptr, double error = 0.02) {
  const Context context;
  const Tracer tracer(patches, context);
  Solution s;
  const auto report =
      solve_sampled(patches, tracer, s, {.error = error, .error_measure = ErrorMeasure::power}, context);
  if (energy) *energy = report.energy;
  return s;
}

class SunnyRoom : public testing::TestWithParam<bool> {};  // whether the window is a portal

// The window faces south in the scene where north is +Y: it is in the wall y = 0.
TEST_P(SunnyRoom, has_the_light_of_path_tracing) {
  auto patches = room_patches(truth::window_room(), clear_with_sun(200.0));
  ASSERT_EQ(patches.point_lights.size(), 1u);
  if (GetParam()) patches.portals = truth::window_portals();
  const Context context;
  const Tracer tracer(patches, context);
  Baked traced{patches, {}}, sampled{patches, {}};
  trace_light(patches, tracer, traced.solution,
              {.limits = {.samples = 8192}, .bounces_from = BouncesFrom::patches}, context);
  EnergyBalance energy;
  sampled.solution = solved(patches, &energy);
  const auto c = compare_solutions(traced, sampled);
  EXPECT_TRUE(c.agrees().value()) << "mean z² " << c.mean_z2 << ", within " << c.within;
  EXPECT_LT(std::abs(c.mean_bias), 0.01);
  EXPECT_NEAR(energy.absorbed[1] + energy.escaped[1], energy.from_sky[1], 0.02 * energy.from_sky[1]);
}

INSTANTIATE_TEST_SUITE_P(with, SunnyRoom, testing::Values(false, true));

// North turned by 90 degrees, and with it the sun: the same room a quarter turn on.
TEST(DaylightNorth, turns_the_light_with_it) {
  const auto light = [](double north, double azimuth) {
    auto d = clear_with_sun(azimuth);
    d.north = north;
    const auto patches = room_patches(truth::window_room(), d);
    const auto s = solved(patches);
    double sum = 0.0;
    for (std::size_t p = 0; p < patches.size(); ++p)
      sum += double{patches.area[p]} * lux_of(s.irradiance.front, p);
    return sum;
  };
  const auto as_it_was = light(0.0, 200.0);
  EXPECT_NEAR(light(90.0, 110.0), as_it_was, 0.02 * as_it_was);
  EXPECT_NEAR(light(-120.0, 320.0), as_it_was, 0.02 * as_it_was);
  EXPECT_LT(light(0.0, 20.0), 0.7 * as_it_was);  // the sun stands behind the room
}

// [quad]: mean illuminance of its front. Quads are two triangles each, whose patches a mirror cuts otherwise.
std::vector<double> means_of_quads(const Scene& scene) {
  const auto patches = make_patches(scene, {.max_edge = 0.25f});
  const auto s = solved(patches, nullptr, 0.001);  // then the illuminance of each quad is good to 1 %
  std::vector<double> sum(scene.triangles.size() / 2, 0.0), area(sum.size(), 0.0);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    sum[patches.triangle[p] / 2] += double{patches.area[p]} * lux_of(s.irradiance.front, p);
    area[patches.triangle[p] / 2] += double{patches.area[p]};
  }
  for (std::size_t q = 0; q < sum.size(); ++q) sum[q] /= area[q];
  return sum;
}

// The mirror image of a room, under a sun in the mirrored place, has the mirror image of its light.
TEST(DaylightMirror, a_mirrored_building_has_mirrored_light) {
  auto builder = truth::window_room();
  builder.material("box", 0.6f, 0.0f);
  truth::add_box(builder, {0.2f, 0.6f, 0.0f}, {0.7f, 1.2f, 0.6f});
  const auto mirrored = [&](double azimuth) {
    auto scene = under(builder, clear_with_sun(azimuth));
    for (auto& p : scene.positions) p.x = 2.0f - p.x;
    for (auto& t : scene.triangles) std::swap(t[1], t[2]);
    return means_of_quads(scene);
  };
  const auto light = means_of_quads(under(builder, clear_with_sun(220.0)));
  const auto image = mirrored(140.0), other = mirrored(220.0);
  const auto brightest = *std::max_element(light.begin(), light.end());
  double largest = 0.0;
  for (std::size_t q = 0; q < light.size(); ++q) {
    EXPECT_NEAR(image[q], light[q], 0.03 * light[q] + 0.002 * brightest) << "quad " << q;
    largest = std::max(largest, std::abs(other[q] - light[q]));
  }
  EXPECT_GT(largest, 0.3 * brightest) << "with the sun where it was";
}

// Under a sky of patches with equal radiance the light is that of an even sky.
TEST(DaylightPatches, all_alike_are_an_even_sky) {
  auto even = truth::under_sky(truth::window_room(), 10.0f);
  auto alike = truth::window_room().scene();
  alike.sky_patches = SkyPatches(2, Vec3d(0, 0, 1), Vec3d(0, 1, 0));
  alike.sky_radiance.assign(alike.sky_patches.size(), Vec3(10.0f));
  for (const bool with_portals : {false, true}) {
    auto one = make_patches(even, {.max_edge = 0.5f}), many = make_patches(alike, {.max_edge = 0.5f});
    if (with_portals) one.portals = many.portals = truth::window_portals();
    const auto a = solved(one), b = solved(many);
    for (std::size_t i = 0; i < a.irradiance.front.size(); ++i)
      ASSERT_NEAR(a.irradiance.front[i], b.irradiance.front[i], 2e-5f * (1.0f + a.irradiance.front[i]));
  }
}

// The disc of the sun: a screen's edge has a penumbra as wide as the disc is, and the light over it is whole.
TEST(SunDisc, has_a_penumbra_of_its_width) {
  SceneBuilder b;
  b.material("floor", 0.0f, 0.0f).quad({-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0});
  b.material("screen", 0.0f, 0.0f).quad({0, -3, 2}, {0, 3, 2}, {9, 3, 2}, {9, -3, 2});
  auto d = cie(12, 90.0, 0.0);
  d.illuminance = 0.0;
  d.sun_illuminance = 50'000.0;
  const ProbeRig rig(under(b, d), no_max_edge, 0.0f);
  const auto half_width = 2.0 * std::tan(0.5 * 0.533 * std::numbers::pi / 180.0);
  const auto at = [&](double x) {
    return rig.at({static_cast<float>(x), 0, 0.001f}, up, {.error = 0.002, .max_rays = 1u << 18});
  };
  EXPECT_NEAR(at(-1.1 * half_width).illuminance, 50'000.0, 5.0);
  EXPECT_NEAR(at(1.1 * half_width).illuminance, 0.0, 1e-6);
  // A disc covered by a line up to x of its radius is visible by 1/2 - (x sqrt(1 - x²) + asin x) / pi.
  for (const auto x : {-0.5, 0.0, 0.4}) {
    const auto light = at(x * half_width);
    const auto seen = 0.5 - (x * std::sqrt(1.0 - x * x) + std::asin(x)) / std::numbers::pi;
    EXPECT_NEAR(light.illuminance, 50'000.0 * seen, sigmas * light.sampling_error + 100.0) << x;
  }
}

}  // namespace
}  // namespace luxel
