// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

struct Solved {
  PatchSet patches;
  Solution solution;
  SolveReport report;
};

Solved solve(const Scene& scene, float max_edge, std::uint64_t rays, double tolerance = 1e-6) {
  Solved s;
  const Context context;
  s.patches = make_patches(scene, {.max_edge = max_edge});
  const Tracer tracer(s.patches, context);
  s.report =
      solve_stochastic_jacobi(s.patches, tracer, s.solution, {.rays = rays, .tolerance = tolerance}, context);
  return s;
}

// Means over parts against their exact values (tolerances as the exact solutions state them, plus four
// standard errors of the mean: sqrt(quantum / arrived power)).
void expect_means(const Solved& s, const std::map<std::string, double>& exact, double tolerance) {
  double emitted = 0.0;
  for (const auto e : s.report.energy.emitted) emitted += e;
  const auto quantum = emitted / static_cast<double>(s.report.steps[0].rays);
  for (const auto& [name, value] : exact) {
    double area = 0.0;
    for (std::size_t p = 0; p < s.patches.size(); ++p)
      if (s.patches.material_of(p).name == name) area += s.patches.area[p];
    const auto bands = static_cast<double>(s.patches.band_count());
    const auto standard_error = std::sqrt(quantum / (bands * value * area));
    const auto mean = truth::mean_irradiance(s.patches, s.solution.irradiance.front, name);
    EXPECT_NEAR(mean / value, 1.0, tolerance + 4.0 * standard_error)
        << name << ": expected " << value << ", found " << mean;
  }
}

TEST(Enclosures, a_cube_with_a_luminous_ceiling_has_the_exact_mean_irradiances) {
  const auto s = solve(truth::cube_a(), 0.05f, 8'000'000);
  expect_means(s,
               {{"wall_x0", 0.36221119},
                {"wall_x1", 0.36221119},
                {"wall_y0", 0.36221119},
                {"wall_y1", 0.36221119},
                {"floor", 0.34243212},
                {"ceiling", 0.20872313}},
               0.002);
}

TEST(Enclosures, an_l_shaped_room_is_lit_round_the_corner) {
  const auto s = solve(truth::l_room(), 0.05f, 10'000'000);
  expect_means(s,
               {{"ceiling", 0.1391531},
                {"wall_y0", 0.2038067},
                {"end_x2", 0.1689368},
                {"inner_y1", 0.3212263},
                {"wall_x0", 0.0836591},
                {"floor_corner", 0.0966175},
                {"floor_lit", 0.3307676}},
               0.003);
  expect_means(s, {{"inner_x1", 0.0214627}, {"end_y2", 0.0208882}, {"floor_dark", 0.0312427}}, 0.005);
}

TEST(Enclosures, open_plates_lose_the_light_that_passes_between_them) {
  const auto s = solve(truth::plates(), 0.05f, 8'000'000);
  expect_means(s, {{"lower", 0.02043611012}, {"upper", 0.20189437848}}, 0.002);
}

// In a sphere every point sees every other alike: H = E_mean / (1 - rho), with the cap's share of the area as
// tessellated.
TEST(Enclosures, a_sphere_is_lit_alike_everywhere) {
  const auto s = solve(truth::sphere(32, 0.5f), no_max_edge, 6'000'000);
  double area = 0.0;
  double cap = 0.0;
  for (std::size_t p = 0; p < s.patches.size(); ++p) {
    area += s.patches.area[p];
    if (s.patches.material_of(p).name == "cap") cap += s.patches.area[p];
  }
  expect_means(s, {{"shell", cap / area / 0.5}, {"cap", cap / area / 0.5}}, 0.003);
}

// Every surface emits 1 - rho, so B = H = 1 on every patch, whatever the shape. Only noise may remain, of the
// size that theory predicts: chi-square of H over patches.
TEST(Enclosures, a_furnace_is_exact) {
  const auto s = solve(truth::furnace({0.8f, 0.5f, 0.2f}, {0.14f, 0.45f, 0.091f}), 0.1f, 10'000'000);
  const auto quantum =
      (s.report.energy.emitted[0] + s.report.energy.emitted[1] + s.report.energy.emitted[2]) /
      static_cast<double>(s.report.steps[0].rays);
  double chi2 = 0.0;
  double worst = 0.0;
  for (std::size_t p = 0; p < s.patches.size(); ++p) {
    double H = 0.0;  // all three bands travel on the same rays: their sum is the Poisson count
    for (std::size_t b = 0; b < 3; ++b) H += s.solution.irradiance.front[3 * p + b];
    const auto z = (H - 3.0) / std::sqrt(quantum * 3.0 / s.patches.area[p]);
    chi2 += z * z;
    worst = std::max(worst, std::abs(z));
  }
  const auto n = static_cast<double>(s.patches.size());
  EXPECT_LT(chi2 / n, 1.0 + 5.0 * std::sqrt(2.0 / n)) << "noise above theory: the furnace is not in balance";
  EXPECT_GT(chi2 / n, 0.5) << "noise far below theory: the error bar is wrong";
  EXPECT_LT(worst, 5.5) << "one patch is far off";
}

TEST(Enclosures, a_furnace_of_one_grey_has_its_exact_mean_to_the_tolerance) {
  const auto s = solve(truth::furnace(Vec3(0.6f), Vec3(0.6f)), 0.25f, 1'000'000, 1e-9);
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t p = 0; p < s.patches.size(); ++p) {
    sum += static_cast<double>(s.patches.area[p]) * s.solution.irradiance.front[3 * p];
    area += s.patches.area[p];
  }
  EXPECT_NEAR(sum / area, 1.0, 1e-6);  // nothing leaks: all shot power arrives
  EXPECT_EQ(s.report.energy.escaped, std::vector<double>(3, 0.0));
}

}  // namespace
}  // namespace luxel
