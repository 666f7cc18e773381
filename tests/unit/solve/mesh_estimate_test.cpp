// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/mesh_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/patch/make_patches.h"
#include "luxel/trace/tracer.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr std::size_t noisy = 2000, quiet = 2000;  // patches, in this order
constexpr double much_noise = 1.0, little_noise = 0.1;
constexpr std::size_t edge_every = 20;  // of the quiet patches one has an edge of light, the others have none
constexpr double edge = 1.5;            // difference that the edge makes

bool has_edge(std::size_t patch) { return patch >= noisy && patch % edge_every == 0; }

// Two answers of each patch, as level_difference.h makes an estimate and its noise from them.
Contributions estimated() {
  Contributions result;
  for (std::size_t p = 0; p < noisy + quiet; ++p) {
    const auto u = uniform4(stream_key(5, 0, 0), p);
    const auto radius = std::sqrt(-2.0 * std::log(1.0 - static_cast<double>(u[0])));
    const auto angle = 2.0 * std::numbers::pi * static_cast<double>(u[1]);
    const auto sigma = p < noisy ? much_noise : little_noise;
    const auto truth = has_edge(p) ? edge : 0.0;
    const auto first = truth + sigma * radius * std::cos(angle);
    const auto second = truth + sigma * radius * std::sin(angle);
    result.squared.push_back(first * second);
    result.noise.push_back(0.25 * (first - second) * (first - second));
  }
  return result;
}

// Counts the patches with an edge of light among those of the hundred largest estimates: a hundred have one.
std::size_t edges_found(const std::vector<double>& estimate) {
  std::vector<std::size_t> order(estimate.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return estimate[a] > estimate[b]; });
  return static_cast<std::size_t>(std::count_if(order.begin(), order.begin() + quiet / edge_every, has_edge));
}

TEST(MeshEstimate, edges_of_light_come_before_noise_though_the_noise_is_larger) {
  const auto all = estimated();
  EXPECT_LT(edges_found(all.squared), 70u) << "by the estimates alone";
  EXPECT_GT(edges_found(beyond_noise(all.squared, all.noise)), 80u);
}

TEST(MeshEstimate, without_noise_nothing_is_taken_off) {
  const std::vector<double> squared{3.0, 1.0, 2.0}, none(3, 0.0);
  EXPECT_EQ(beyond_noise(squared, none), squared);
}

// Irradiance of 1 in a cube, and noise of this amplitude that has the opposite sign in the other half:
// products of the differences in both halves are below 0 everywhere.
double error_of_halves(double noise) {
  const Context context(2);
  const auto patches = make_patches(truth::cube_a(), {.max_edge = 0.15f});
  std::array<Solution, 2> halves;
  for (const double sign : {-1.0, 1.0}) {
    auto& half = halves[sign < 0.0 ? 0 : 1];
    half.bands = patches.bands;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto u = static_cast<double>(uniform4(stream_key(7, 0, 0), p)[0]);
      const auto light = static_cast<float>(1.0 + sign * noise * (2.0 * u - 1.0));
      half.irradiance.front.insert(half.irradiance.front.end(), patches.band_count(), light);
      half.radiosity.front.insert(half.radiosity.front.end(), patches.band_count(), 0.5f * light);
    }
    half.irradiance.back.assign(half.irradiance.front.size(), 0.0f);
    half.radiosity.back = half.irradiance.back;
  }
  return mesh_error_of(patches, Tracer(patches, context), std::move(halves), ErrorMeasure::seen, {}, context);
}

TEST(MeshEstimate, noise_that_hides_the_error_is_not_stated_as_none) {
  EXPECT_GT(error_of_halves(0.1), 0.001);
  EXPECT_LT(error_of_halves(0.1), 0.2);
  EXPECT_EQ(error_of_halves(0.0), 0.0) << "the light is even";
}

}  // namespace
}  // namespace luxel
