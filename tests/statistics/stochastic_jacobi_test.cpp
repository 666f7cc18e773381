// SPDX-License-Identifier: Apache-2.0
// The noise of the solver is that of theory. Risk of a false alarm: about one in a million per test.
#include "luxel/classical/stochastic_jacobi.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/chi_square.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

struct Spread {
  double error =
      0.0;  // area-weighted relative RMS of the irradiance over patches and seeds, about the mean of seeds
  double predicted = 0.0;  // the solver's own prediction
};

Spread spread(const PatchSet& patches, const Tracer& tracer, const Context& context, std::uint64_t rays,
              int seeds) {
  std::vector<std::vector<float>> runs;
  Spread result;
  for (int seed = 1; seed <= seeds; ++seed) {
    Solution solution;
    solve_stochastic_jacobi(patches, tracer, solution,
                            {.rays = rays, .tolerance = 1e-5, .seed = static_cast<std::uint64_t>(seed)},
                            context);
    runs.push_back(solution.irradiance.front);
    result.predicted += solution.predicted_error / seeds;
  }
  double variance = 0.0;
  double square = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    double mean = 0.0;
    for (const auto& run : runs) mean += static_cast<double>(run[3 * p]) / seeds;
    for (const auto& run : runs)
      variance += patches.area[p] * (run[3 * p] - mean) * (run[3 * p] - mean) / (seeds - 1);
    square += patches.area[p] * mean * mean;
  }
  result.error = std::sqrt(variance / square);
  return result;
}

class CubeNoise : public testing::Test {
 protected:
  PatchSet patches_ = make_patches(truth::cube_a(), {.max_edge = 0.2f});
  Context context_;
  Tracer tracer_{patches_, context_};
};

TEST_F(CubeNoise, falls_as_one_over_the_root_of_the_rays) {
  const auto coarse = spread(patches_, tracer_, context_, 20'000, 32);
  const auto fine = spread(patches_, tracer_, context_, 320'000, 32);
  // The relative error of each is sqrt(1 / (2 * 31 * patches)), about 0.5 %; five of them on the ratio.
  EXPECT_NEAR(coarse.error / fine.error, 4.0, 4.0 * 5.0 * std::sqrt(2.0) * 0.005);
}

TEST_F(CubeNoise, is_what_the_solver_predicts_of_itself) {
  const auto measured = spread(patches_, tracer_, context_, 100'000, 32);
  // The prediction takes arrivals for a Poisson count; stratification may make the truth a little smaller,
  // propagated noise a little larger: both are below three per cent here.
  EXPECT_NEAR(measured.error / measured.predicted, 1.0, 0.03 + 5.0 * 0.005);
}

// sqrt(rho P_T / (N P_i)) for the radiosity of a surface that does not emit: here for the floor, patch by
// patch.
TEST_F(CubeNoise, of_a_patch_follows_the_formula) {
  constexpr int seeds = 64;
  std::vector<double> sum(patches_.size(), 0.0);
  std::vector<double> sum2(patches_.size(), 0.0);
  double shot_power = 0.0;
  double rays = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    Solution solution;
    const auto report = solve_stochastic_jacobi(
        patches_, tracer_, solution,
        {.rays = 100'000, .tolerance = 1e-5, .seed = static_cast<std::uint64_t>(seed)}, context_);
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      sum[p] += solution.radiosity.front[3 * p];
      sum2[p] += static_cast<double>(solution.radiosity.front[3 * p]) * solution.radiosity.front[3 * p];
    }
    rays = static_cast<double>(report.rays);
    shot_power = report.energy.emitted[0] * rays / static_cast<double>(report.steps[0].rays);  // P_T
  }
  double chi2 = 0.0;
  double degrees_of_freedom = 0.0;
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    if (patches_.material_of(p).name != "floor") continue;
    const auto mean = sum[p] / seeds;
    const auto variance = (sum2[p] - seeds * mean * mean) / (seeds - 1);
    const auto radiated = mean * patches_.area[p];  // P_i
    const auto relative = std::sqrt(0.5 * shot_power / (rays * radiated));
    chi2 += (seeds - 1) * variance / (relative * mean * relative * mean);
    degrees_of_freedom += seeds - 1;
  }
  EXPECT_LT(chi2, 1.03 * statistics::chi_square_limit(degrees_of_freedom));
  EXPECT_GT(chi2, 0.97 * statistics::chi_square_lower_limit(degrees_of_freedom));
}

}  // namespace
}  // namespace luxel
