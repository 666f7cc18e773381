// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/jacobi.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/classical/direct_solve.h"

#include "support/random_matrix.h"

namespace luxel {
namespace {

struct Light {
  std::vector<float> before, irradiance, radiosity;
  JacobiReport report;
};

Light iterate(const test::RandomMatrix& matrix, const JacobiOptions& options, int threads = 0,
              const Monitor& monitor = {}, const EachStep& each_step = {}) {
  Light light;
  for (auto* array : {&light.before, &light.irradiance, &light.radiosity})
    array->assign(matrix.emittance.size(), -1.0f);
  const auto context = Context(threads).with_monitor(monitor);
  light.report = jacobi(matrix,
                        {matrix.area,
                         matrix.emittance,
                         {},
                         matrix.reflectance,
                         light.before,
                         light.irradiance,
                         light.radiosity},
                        options, context, each_step);
  return light;
}

TEST(Jacobi, converges_to_the_solution) {
  const test::RandomMatrix matrix(60);
  const auto light = iterate(matrix, {.tolerance = 1e-9});
  EXPECT_EQ(light.report.end, JacobiEnd::converged);
  std::vector<float> exact(light.radiosity.size());
  const Context context;
  ASSERT_TRUE(solve_directly(matrix.factors, matrix.emittance, matrix.reflectance, exact, context));
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(light.radiosity[i] / exact[i], 1.0, 1e-6) << i;
}

// Light from outside belongs to the first step, as does that of lamps.
TEST(Jacobi, light_from_outside_is_as_good_as_lamps_that_send_it) {
  const test::RandomMatrix matrix(60);
  const Context context;
  const std::vector<float> dark(matrix.emittance.size(), 0.0f);
  std::vector<float> outside(dark.size()), before(dark.size()), irradiance(dark.size()),
      radiosity(dark.size());
  matrix.apply(matrix.emittance, outside, 0, matrix.size(), context);
  const auto lit = iterate(matrix, {.tolerance = 1e-9});
  const auto report =
      jacobi(matrix, {matrix.area, dark, outside, matrix.reflectance, before, irradiance, radiosity},
             {.tolerance = 1e-9}, context);
  EXPECT_EQ(report.end, JacobiEnd::converged);
  for (std::size_t i = 0; i < dark.size(); ++i)
    EXPECT_NEAR(irradiance[i] / lit.irradiance[i], 1.0, 1e-6) << i;
}

TEST(Jacobi, a_step_is_a_bounce) {
  const test::RandomMatrix matrix(60);
  std::vector<float> expected = matrix.emittance, gathered(expected.size());
  const Context context;
  int steps = 0;
  const auto light = iterate(matrix, {.steps = 3}, 0, {}, [&](const JacobiStep& step) {
    EXPECT_EQ(step.step, ++steps);
    EXPECT_EQ(std::vector<float>(step.before.begin(), step.before.end()), expected);
    matrix.apply(expected, gathered, 0, matrix.size(), context);
    EXPECT_EQ(std::vector<float>(step.irradiance.begin(), step.irradiance.end()), gathered);
    for (std::size_t i = 0; i < expected.size(); ++i)
      expected[i] = matrix.emittance[i] + matrix.reflectance[i] * gathered[i];
    EXPECT_EQ(std::vector<float>(step.radiosity.begin(), step.radiosity.end()), expected);
  });
  EXPECT_EQ(steps, 3);
  EXPECT_EQ(light.report.end, JacobiEnd::step_limit);
  EXPECT_EQ(light.report.unshot_fraction.size(), 3u);
  EXPECT_EQ(light.radiosity, expected);
}

TEST(Jacobi, the_unshot_fraction_is_what_the_next_step_sends_first) {
  const test::RandomMatrix matrix(60);
  double emitted = 0.0;
  for (std::size_t i = 0; i < matrix.emittance.size(); ++i)
    emitted += static_cast<double>(matrix.area[i / 2]) * static_cast<double>(matrix.emittance[i]);
  iterate(matrix, {.tolerance = 1e-3}, 0, {}, [&](const JacobiStep& step) {
    double unshot = 0.0;
    for (std::size_t i = 0; i < step.before.size(); ++i)
      unshot += static_cast<double>(matrix.area[i / 2]) *
                (static_cast<double>(step.radiosity[i]) - static_cast<double>(step.before[i]));
    EXPECT_NEAR(step.unshot_fraction / (unshot / emitted), 1.0, 1e-6);
  });
}

TEST(Jacobi, is_the_same_on_any_number_of_threads) {
  const test::RandomMatrix matrix(60);
  EXPECT_EQ(iterate(matrix, {}, 1).radiosity, iterate(matrix, {}, 5).radiosity);
}

TEST(Jacobi, that_is_stopped_keeps_the_last_whole_step) {
  const test::RandomMatrix matrix(60);
  int asked = 0;
  const auto stopped = iterate(matrix, {}, 1, [&](const Progress&) {
    return ++asked == 6 ? Next::stop : Next::go_on;  // four polls per step: in the middle of the second
  });
  EXPECT_EQ(stopped.report.end, JacobiEnd::stopped);
  EXPECT_EQ(stopped.report.unshot_fraction.size(), 1u);
  EXPECT_EQ(stopped.radiosity, iterate(matrix, {.steps = 1}).radiosity);
  EXPECT_EQ(stopped.irradiance, iterate(matrix, {.steps = 1}).irradiance);
}

TEST(Jacobi, before_the_first_step_only_lamps_shine) {
  const test::RandomMatrix matrix(60);
  const auto light = iterate(matrix, {}, 1, [](const Progress&) { return Next::stop; });
  EXPECT_EQ(light.radiosity, matrix.emittance);
  EXPECT_EQ(light.irradiance, std::vector<float>(matrix.emittance.size(), 0.0f));
  EXPECT_EQ(light.before, light.irradiance);
}

TEST(Jacobi, tells_how_far_the_whole_has_come) {
  const test::RandomMatrix matrix(60);
  double last = 0.0;
  iterate(matrix, {.tolerance = 1e-6}, 1, [&](const Progress& p) {
    EXPECT_GE(p.done, 0.0);
    EXPECT_LE(p.done, 1.0);
    last = p.done;
    return Next::go_on;
  });
  EXPECT_GT(last, 0.8);
}

}  // namespace
}  // namespace luxel
