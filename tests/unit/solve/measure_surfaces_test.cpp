// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/student.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solve/sampled.h"
#include "luxel/solve/sampled_light.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr std::size_t replicates = 4;

// Light of replicate r, at receiver s in band b: exact means are easy to form.
float light(std::size_t r, std::size_t s, std::size_t b) {
  return 1.0f + 0.5f * static_cast<float>(b) + 0.01f * static_cast<float>(s % 7) +
         0.1f * static_cast<float>((r * r + s) % 3);
}

TEST(MeasureSurfaces, means_and_errors_are_those_of_the_replicates_means) {
  const Context context(2);
  const auto patches = make_patches(truth::l_room(), {.max_edge = 0.3f});
  const auto bands = patches.band_count();
  const auto sides = all_gather_sides(patches, make_patch_tree(patches, context));
  std::vector<std::vector<float>> direct(replicates, std::vector<float>(sides.size() * bands, 0.25f));
  auto gathered = direct;
  for (std::size_t r = 0; r < replicates; ++r)
    for (std::size_t s = 0; s < sides.size(); ++s)
      for (std::size_t b = 0; b < bands; ++b) gathered[r][s * bands + b] = light(r, s, b);
  const auto means = measure_surfaces(patches, sides, direct, gathered, context);

  ASSERT_EQ(means.received.power.size(), bands);
  for (std::size_t b = 0; b < bands; ++b) {
    std::vector<double> power(replicates, 0.0);
    double area = 0.0;
    for (std::size_t s = 0; s < sides.size(); ++s) {
      const auto of_side = static_cast<double>(patches.area[sides.side[s].patch()]);
      area += of_side;
      for (std::size_t r = 0; r < replicates; ++r)
        power[r] += of_side * (0.25 + static_cast<double>(light(r, s, b)));
    }
    double mean = 0.0;
    for (const auto p : power) mean += p / replicates;
    double sum = 0.0;
    for (const auto p : power) sum += (p - mean) * (p - mean);
    EXPECT_NEAR(means.received.power[b], mean, 1e-6 * mean);
    EXPECT_NEAR(means.received.standard_error[b],
                student_widening(replicates - 1.0) * std::sqrt(sum / (replicates * (replicates - 1.0))),
                1e-6 * mean);
    double area_of_surfaces = 0.0;
    double power_of_surfaces = 0.0;
    for (const auto& s : means.surfaces) {
      area_of_surfaces += s.area;
      power_of_surfaces += s.area * s.irradiance[b];
    }
    EXPECT_NEAR(area_of_surfaces, area, 1e-6 * area);
    EXPECT_NEAR(power_of_surfaces, mean, 1e-6 * mean);
  }
}

TEST(MeasureSurfaces, of_a_solve_are_the_area_means_of_its_solution) {
  const Context context(2);
  const auto patches = make_patches(truth::l_room(), {.max_edge = 0.3f});
  const Tracer tracer(patches, context);
  Solution solution;
  const auto report = solve_sampled(patches, tracer, solution, {.error = 0.05, .smoothing = false}, context);
  const auto bands = patches.band_count();
  ASSERT_FALSE(report.means.surfaces.empty());
  for (const auto& s : report.means.surfaces) {
    const auto& light_of_side = solution.irradiance.of(s.is_back);
    for (std::size_t b = 0; b < bands; ++b) {
      double power = 0.0;
      for (std::size_t p = 0; p < patches.size(); ++p)
        if (static_cast<std::size_t>(patches.material[p]) == s.material)
          power += static_cast<double>(patches.area[p]) * static_cast<double>(light_of_side[p * bands + b]);
      EXPECT_NEAR(power / s.area, s.irradiance[b], 1e-3 * s.irradiance[b] + s.standard_error[b]) << s.name;
      EXPECT_GT(s.standard_error[b], 0.0) << s.name;
    }
  }
}

}  // namespace
}  // namespace luxel
