// SPDX-License-Identifier: Apache-2.0
// The classical methods give the same bits on any number of threads, and a stop leaves the documented result.
#include "luxel/classical/classical.h"

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

enum class Method { direct, jacobi, gauss_seidel, hemicube, lines };
constexpr Method methods[] = {Method::direct, Method::jacobi, Method::gauss_seidel, Method::hemicube,
                              Method::lines};

struct Solved {
  Solution solution;
  SolveReport report;
};

Solved solve(const PatchSet& patches, Method method, int threads, const Monitor& monitor = {},
             const LightSink& on_light = {}) {
  const auto context = Context(threads).with_monitor(monitor);
  const Tracer tracer(patches, context);
  Solved s;
  if (method == Method::hemicube)
    s.report = solve_hemicube(patches, s.solution, {.hemicube = {.resolution = 32}}, context, on_light);
  else if (method == Method::lines)
    s.report = solve_lines(patches, tracer, s.solution, {.lines = {.lines = 200}}, context, on_light);
  else
    s.report = solve_dense(patches, tracer, s.solution,
                           {.solver = method == Method::direct   ? DenseSolver::direct
                                      : method == Method::jacobi ? DenseSolver::jacobi
                                                                 : DenseSolver::gauss_seidel},
                           context, on_light);
  return s;
}

PatchSet room() { return make_patches(truth::l_room(), {.max_edge = 1.1f}); }

TEST(Classical, gives_the_same_bits_on_any_number_of_threads) {
  const auto patches = room();
  for (const auto method : methods) {
    const auto one = solve(patches, method, 1), many = solve(patches, method, 5);
    EXPECT_EQ(one.solution.irradiance.front, many.solution.irradiance.front);
    EXPECT_EQ(one.solution.radiosity.back, many.solution.radiosity.back);
    EXPECT_EQ(one.solution.standard_error.front, many.solution.standard_error.front);
    EXPECT_EQ(one.report.energy.escaped, many.report.energy.escaped);
    EXPECT_EQ(one.report.stop, StopReason::converged);
  }
}

TEST(Classical, that_is_stopped_at_once_leaves_the_lamps_and_says_that_all_is_unshot) {
  const auto patches = room();
  for (const auto method : methods) {
    const auto s = solve(patches, method, 2, [](const Progress&) { return Next::stop; });
    EXPECT_EQ(s.report.stop, StopReason::stopped_by_user);
    EXPECT_EQ(s.solution.unshot_fraction, 1.0);
    EXPECT_EQ(s.report.energy.unshot, s.report.energy.emitted);
    EXPECT_EQ(s.solution.irradiance.front, std::vector<float>(3 * patches.size(), 0.0f));
    for (std::size_t p = 0; p < patches.size(); ++p)
      EXPECT_EQ(s.solution.radiosity.front[3 * p], patches.material_of(p).emittance[0]);
  }
}

TEST(Classical, that_is_stopped_while_it_solves_keeps_its_balance) {
  const auto patches = room();
  for (const auto method : methods) {
    // Stops once the factors are known: after the first picture; the direct method has none before its end.
    bool has_picture = false;
    const auto stop_when_enough = [&](const Progress& p) {
      const bool is_enough = has_picture || method == Method::direct;
      return p.stage == "light" && is_enough ? Next::stop : Next::go_on;
    };
    const auto s = solve(patches, method, 2, stop_when_enough,
                         [&](const Solution&, const Progress&) { has_picture = true; });
    if (method == Method::gauss_seidel) continue;  // it has no point at which it could stop
    EXPECT_EQ(s.report.stop, StopReason::stopped_by_user);
    EXPECT_GT(s.report.unshot_fraction, 0.1);
    const auto& e = s.report.energy;
    for (std::size_t b = 0; b < 3; ++b)
      EXPECT_NEAR((e.absorbed[b] + e.escaped[b] + e.lost_at_backs[b] + e.unshot[b]) / e.emitted[b], 1.0,
                  0.05);
  }
}

}  // namespace
}  // namespace luxel
