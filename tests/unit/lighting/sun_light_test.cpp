// SPDX-License-Identifier: Apache-2.0
// The sun's disc behind a straight edge: its visible part is a segment of a circle.
//
// Risk. The seed is fixed. Plain random rays would have a root mean square error of 0.126 of the disc over
// these points, and stratified ones have less; with other seeds the sum over 400 points would reach a limit
// of six standard errors with a chance below one in a million.
#include "luxel/lighting/sun_light.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/photometry/weather.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr double away = 10.0, half_disc = 0.5 * sun_diameter * std::numbers::pi / 180.0;  // m, radians
constexpr std::size_t count = 400;

// Part of a disc of radius 1 beyond a line at this distance from its centre.
double part_beyond(double line) {
  if (line >= 1.0) return 0.0;
  if (line <= -1.0) return 1.0;
  return (std::acos(line) - line * std::sqrt(1.0 - line * line)) / std::numbers::pi;
}

// A wall faces the sun of an hour, and points stand where its edge crosses the disc, and beside.
struct Edge {
  Weather weather = read_weather(
      "place Nowhere\nlatitude 42\nlongitude 88\ntime_zone 90\nsite_elevation 100\n"
      "weather_data_file_units 1\n6 20 12.5 600 120\n",
      "ours.wea");
  YearSkies skies = skies_of_year(weather, SkyPatches(1, {0, 0, 1}, {0, 1, 0}), 0.2);
  Vec3d sun = skies.patches.in_scene_axes(skies.hours[0].sun.direction);
  Vec3d along = glm::normalize(glm::cross(sun, Vec3d(0, 0, 1))), up = glm::cross(along, sun);
  PatchSet patches = make_patches(wall(), {});
  Context context;
  Tracer tracer{patches, context};
  std::vector<ProbePoint> points;
  std::vector<double> seen;  // part of the disc

  Edge() {
    for (std::size_t i = 0; i < count; ++i) {
      const auto line = 1.25 * (2.0 * (static_cast<double>(i) + 0.5) / count - 1.0);
      const auto at = -line * away * std::tan(half_disc) * along - Vec3d(patches.origin);
      points.push_back({Vec3(at), Vec3(0, 0, 1)});
      seen.push_back(part_beyond(line));
    }
  }
  double whole() const { return skies.hours[0].sun_illuminance * sun.z; }  // lx

 private:
  Scene wall() const {
    const auto at = [&](double a, double b) { return Vec3(away * sun + a * along + b * up); };
    truth::SceneBuilder builder;
    builder.material("wall", 0.0f, 0.0f).quad(at(-5, -5), at(0, -5), at(0, 5), at(-5, 5));
    return builder.scene();
  }
};

TEST(SunLight, is_the_part_of_the_disc_that_is_seen) {
  const Edge edge;
  const SunLight light(edge.skies, edge.points, {edge.patches, edge.tracer}, {}, edge.context);
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto error = double{light.all()[i]} / edge.whole() - edge.seen[i];
    sum += error / count;
    squares += error * error / count;
    if (edge.seen[i] == 0.0) {
      EXPECT_EQ(light.all()[i], 0.0f) << i;
    }
    if (edge.seen[i] == 1.0) {
      EXPECT_NEAR(error, 0.0, 0.01) << i;
    }
  }
  EXPECT_LT(std::sqrt(squares), 0.126);
  EXPECT_NEAR(sum, 0.0, 6.0 * 0.126 / std::sqrt(double{count}));
}

// Each replicate has one of the eight rays: without it, the mean is that of the seven others.
TEST(SunLight, is_known_without_a_replicate) {
  const Edge edge;
  const SunLight light(edge.skies, edge.points, {edge.patches, edge.tracer}, {}, edge.context);
  std::vector<std::vector<float>> without;
  for (std::uint32_t r = 0; r < 8; ++r) without.push_back(light.without(light.all(), 8, r));
  std::size_t spread = 0;
  for (std::size_t i = 0; i < count; ++i) {
    double mean = 0.0;
    for (const auto& light_without : without) mean += double{light_without[i]} / 8.0;
    EXPECT_NEAR(mean, double{light.all()[i]}, 1e-4 * edge.whole()) << i;
    const bool is_whole = edge.seen[i] == 0.0 || edge.seen[i] == 1.0;
    if (is_whole) {
      EXPECT_EQ(without[3][i], light.all()[i]) << i;
    }
    if (!is_whole && without[3][i] != light.all()[i]) ++spread;
  }
  EXPECT_GT(spread, count / 2);
}

TEST(SunLight, has_other_errors_with_another_seed) {
  const Edge edge;
  const SunLight a(edge.skies, edge.points, {edge.patches, edge.tracer, 1}, {}, edge.context),
      b(edge.skies, edge.points, {edge.patches, edge.tracer, 2}, {}, edge.context);
  EXPECT_NE(a.all(), b.all());
}

}  // namespace
}  // namespace luxel
