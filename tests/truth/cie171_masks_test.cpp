// SPDX-License-Identifier: Apache-2.0
// CIE 171:2006, daylight behind outdoor obstructions: test cases 5.13, a continuous overhang, and 5.14, a
// continuous screen; and the components of the daylight factor. Geometry, truth, tolerances and risk as in
// cie171_daylight_test.cpp.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/student.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/lighting/coefficients.h"
#include "luxel/lighting/daylight_scene.h"
#include "luxel/patch/make_patches.h"
#include "luxel/photometry/sky_integrals.h"
#include "luxel/render/probe_light.h"
#include "luxel/solve/relight.h"
#include "luxel/solve/sampled.h"

#include "support/axes.h"
#include "support/daylight_rooms.h"
#include "support/three_errors.h"

namespace luxel {
namespace {

using test::cie171_sky;
using test::expect_truth;
using test::facade_2x1;
using test::facade_room;
using test::far_away;
using test::up;
using test::WithError;
using truth::SceneBuilder;

constexpr double sky_lux = 10'000.0, albedo = 0.3, patch_size = 5e-4, max_error = 3e-3;
constexpr float mask_reflectance = 0.3f;

// Percentages of the illuminance of open ground at the points A to H on the floor, from the wall y = 4 to the
// façade.
using Floor = std::array<double, 8>;

Vec3 floor_point(std::size_t i) { return {2, 3.75f - 0.5f * static_cast<float>(i), 0}; }

// A strip of the plane at(x, v) between two v, in parts: patches in the middle have the light of a strip
// without ends, and are not slender there. Smoothing of the light over slender ones has errors that are not
// stated.
template <typename At>
void add_strip(SceneBuilder& b, float v0, float v1, const At& at) {
  constexpr std::array x = {-far_away, -10.0f, -4.0f, -2.0f, -1.0f, 0.0f,  1.0f,           2.0f,
                            3.0f,      4.0f,   5.0f,  6.0f,  8.0f,  14.0f, 4.0f + far_away};
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    b.quad(at(x[i], v0), at(x[i + 1], v0), at(x[i + 1], v1), at(x[i], v1));
}

// The underside of the overhang reflects 0.3 of the ground's light, its top lies on the black plane.
SceneBuilder overhung_room(float depth) {
  auto b = facade_room(facade_2x1, far_away);
  b.material("overhang", mask_reflectance, 0.0f);
  for (float y = 0.0f; y < depth - 1e-4f; y += 0.1f)
    add_strip(b, -y - 0.1f, -y, [](float x, float v) { return Vec3(x, v, 3); });
  return b;
}

// A screen of reflectance 0.3, 6 m before a façade under a black roof.
SceneBuilder screened_room(float height) {
  auto b = facade_room(facade_2x1, far_away);
  b.quad({-far_away, 0, 3.0001f}, {4 + far_away, 0, 3.0001f}, {4 + far_away, far_away, 3.0001f},
         {-far_away, far_away, 3.0001f});
  b.material("screen", mask_reflectance, 0.0f);
  for (float z = 0.0f; z < height - 1e-4f; z += 0.25f)
    add_strip(b, z, z + 0.25f, [](float x, float v) { return Vec3(x, -6, v); });
  return b;
}

void hold_mask(const SceneBuilder& builder, int type, const Floor& percent) {
  auto scene = builder.scene();
  set_daylight(cie171_sky(type, 180.0), up, scene);
  const Context context(2);
  auto patches = make_patches(scene, {.max_edge = no_max_edge});
  set_portals(scene, patches, context);
  const Tracer tracer(patches, context);
  Solution solution;
  std::shared_ptr<const SampleState>
      state;  // with it, errors of the light reflected by the masks are not overestimated
  const SolveHooks hooks{.from = {},
                         .keep = [&](std::shared_ptr<const SampleState> s) { state = std::move(s); },
                         .on_light = {}};
  const SampledOptions options{.error = 2e-3, .error_measure = ErrorMeasure::power};
  solve_sampled(patches, tracer, solution, options, hooks, context);
  state = with_group_light(patches, tracer, state, options, context);
  const SolutionProbe probe(patches, solution, tracer, state.get(), context);
  for (std::size_t i = 0; i < percent.size(); ++i) {
    const auto measure = [&](std::uint64_t seed) {
      const auto found = probe.at({floor_point(i), up}, {.error = 1e-3, .max_rays = 1u << 19}, seed);
      const auto error = 100.0 * found.standard_error() / sky_lux;
      EXPECT_LT(error, max_error * percent[i]) << i;
      return WithError{100.0 * found.illuminance / sky_lux, error};
    };
    expect_truth(measure, percent[i], patch_size * percent[i],
                 fmt::format("{}, type {}", "ABCDEFGH"[i], type));
  }
}

TEST(Cie171Case5_13, overhangs) {
  hold_mask(overhung_room(0.5f), 16,
            {0.94491074, 1.3758135, 2.0662555, 3.1875835, 4.9660296, 7.4213587, 8.0696117, 0.20555073});
  hold_mask(overhung_room(1.0f), 12,
            {1.9966869, 2.7954624, 4.0585102, 6.1257386, 8.7287021, 10.461227, 7.2813682, 0.20555073});
  hold_mask(overhung_room(2.0f), 16,
            {0.89859471, 1.1640156, 1.5105311, 1.9223409, 2.2432883, 1.7464328, 0.46409921, 0.20555073});
}

TEST(Cie171Case5_14, screens) {
  hold_mask(screened_room(3.0f), 12,
            {1.7599248, 2.6802007, 4.0585102, 6.1257386, 9.5358288, 14.556572, 16.367948, 5.0264413});
  hold_mask(screened_room(6.0f), 16,
            {0.17599531, 0.24185736, 0.56315829, 1.5160898, 3.4179274, 7.1497115, 9.1115324, 5.0372251});
  hold_mask(screened_room(9.0f), 12,
            {0.15646057, 0.21540562, 0.30144656, 0.42751414, 0.60330744, 6.3509387, 16.367948, 5.0264413});
}

// Percentages by each path of the light.
struct Components {
  const char* label;
  Vec3 position, normal;
  double sky, external;
};

// Daylight coefficients of a room whose patches of the sky are 2,305, up to 0.16 % off at a point.
class Coefficients {
 public:
  Coefficients(const SceneBuilder& builder, const std::vector<Components>& points) {
    for (const auto& point : points) points_.push_back({point.position, point.normal});
    auto scene = builder.scene();
    const SkyPatches sky(4, Vec3d(0, 0, 1), Vec3d(0, 1, 0));
    set_only_sky(sky, luminances(sky, 16), scene);
    patches_ = make_patches(scene, {.max_edge = no_max_edge});
    set_portals(scene, patches_, context_);
    tracer_ = std::make_unique<Tracer>(patches_, context_);
    Solution solution;
    const SolveHooks hooks{.from = {},
                           .keep = [&](std::shared_ptr<const SampleState> s) { state_ = std::move(s); },
                           .on_light = {}};
    solve_sampled(patches_, *tracer_, solution, options_, hooks, context_);
  }
  DaylightCoefficients found(std::uint64_t seed) const {
    return find_coefficients({patches_, *state_, options_}, *tracer_, points_, {.rays = 16384, .seed = seed},
                             context_);
  }
  static std::vector<double> luminances(const SkyPatches& sky, int type) {
    const auto elevation = std::numbers::pi / 3.0;
    const auto model = SkyModel::cie(type, {0.0, -std::cos(elevation), std::sin(elevation)});
    return sky_patch_luminances(model, sky, sky_lux, albedo);
  }

 private:
  Context context_{2};
  std::vector<ProbePoint> points_;
  PatchSet patches_;
  std::unique_ptr<Tracer> tracer_;
  SampledOptions options_{.error = 0.01, .error_measure = ErrorMeasure::power};
  std::shared_ptr<const SampleState> state_;
};

// The mean of a path over the replicates, per cent, and its error.
WithError of_path(const DaylightCoefficients& found, DaylightPath path, std::size_t point,
                  const std::vector<double>& luminance) {
  const auto n = found.replicates;
  std::vector<double> values(n, 0.0);
  double mean = 0.0, spread = 0.0;
  for (std::uint32_t r = 0; r < n; ++r) {
    const auto row = found.row(path, point, r);
    for (std::size_t p = 0; p < row.size(); ++p) values[r] += double{row[p]} * luminance[p];
    mean += 100.0 * values[r] / sky_lux / n;
  }
  for (const auto value : values) spread += std::pow(100.0 * value / sky_lux - mean, 2.0);
  return {mean, student_widening(n - 1.0) * std::sqrt(spread / (n * (n - 1.0)))};
}

void hold_components(const Coefficients& room, int type, const std::vector<Components>& points) {
  std::array<DaylightCoefficients, 2> found = {room.found(1), room.found(2)};
  EXPECT_TRUE(found[0].knows_openings);
  const auto luminance = Coefficients::luminances(found[0].sky, type);
  for (std::size_t m = 0; m < points.size(); ++m)
    for (const auto& [path, truth] : {std::pair(DaylightPath::sky, points[m].sky),
                                      {DaylightPath::external, points[m].external},
                                      {DaylightPath::internal, 0.0}})
      expect_truth(
          [&, path = path](std::uint64_t seed) { return of_path(found[seed - 1], path, m, luminance); },
          truth, 1.6e-3 * truth,
          fmt::format("{}, type {}, path {}", points[m].label, type, static_cast<int>(path)));
}

TEST(Cie171Case5_11, components_of_the_daylight_factor) {
  const Vec3 south(0, -1, 0), down(0, 0, -1);
  std::vector<Components> points = {
      {"A", {2, 4, 2.75f}, south, 0.0, 0.9506822},       {"C", {2, 4, 1.75f}, south, 0.4336672, 0.8407565},
      {"D", {2, 4, 1.25f}, south, 1.4197087, 0.2859123}, {"E", {2, 4, 0.75f}, south, 2.0587488, 0.0},
      {"K", {2, 1.75f, 0}, up, 4.9660296, 0.0},          {"K'", {2, 1.75f, 3}, down, 0.0, 1.555363}};
  const Coefficients room(facade_room(facade_2x1), points);
  hold_components(room, 16, points);
  const std::array<double, 6> clear = {0.0, 1.5432838, 4.6446317, 5.8050878, 9.5358288, 0.0};
  for (std::size_t i = 0; i < clear.size(); ++i) points[i].sky = clear[i];
  hold_components(room, 12, points);
}

TEST(Cie171Case5_13, components_of_the_daylight_factor) {
  const std::vector<Components> points = {{"D", floor_point(3), up, 3.1875835, 0.0},
                                          {"E", floor_point(4), up, 4.5635118, 0.0223182},
                                          {"F", floor_point(5), up, 5.4346809, 0.1010357},
                                          {"G", floor_point(6), up, 3.7401188, 0.2527086},
                                          {"H", floor_point(7), up, 0.0, 0.2055507}};
  hold_components(Coefficients(overhung_room(1.0f), points), 16, points);
}

}  // namespace
}  // namespace luxel
