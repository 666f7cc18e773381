// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/enforce.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/form_factors/check_view_factors.h"

namespace luxel {
namespace {

// Full rows of the elements; diagonal entries of 0 are left out.
ViewFactors table(const std::vector<double>& area, const std::vector<std::vector<double>>& rows,
                  double rays = 1000.0) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < area.size(); ++i) names.push_back(std::string(1, static_cast<char>('a' + i)));
  auto factors = ViewFactors::between(names, area);
  for (std::size_t i = 0; i < area.size(); ++i) {
    for (std::uint32_t j = 0; j < area.size(); ++j)
      if (rows[i][j] > 0.0) {
        factors.column.push_back(j);
        factors.factor.push_back(rows[i][j]);
        factors.standard_error.push_back(0.02f);
      }
    factors.row_begin[i + 1] = factors.count();
    factors.rays[i] = rays;
    factors.is_known[i] = 1;
  }
  return factors;
}

TEST(Enforce, three_long_strips_can_only_be_what_crossed_strings_say) {
  // Sides of 3, 4 and 5: A F from a to b is (3 + 4 - 5) / 2, and so on (Hottel), whatever was measured.
  auto factors = table({3, 4, 5}, {{0, 0.30, 0.72}, {0.27, 0, 0.70}, {0.41, 0.62, 0}});
  const auto done = enforce_laws(factors, Context(1));
  EXPECT_GT(done.worst_row_sum_before, 0.01);
  EXPECT_LT(done.worst_row_sum, 1e-12);
  const std::vector<double> expected = {1.0 / 3, 2.0 / 3, 1.0 / 4, 3.0 / 4, 2.0 / 5, 3.0 / 5};
  ASSERT_EQ(factors.count(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(factors.factor[i], expected[i], 1e-12);
}

TEST(Enforce, what_keeps_the_laws_already_stays) {
  auto factors = table({1, 2}, {{0, 1.0}, {0.5, 0.5}});
  const auto before = factors.factor;
  const auto done = enforce_laws(factors, Context(1));
  EXPECT_EQ(factors.factor, before);
  EXPECT_LT(done.max_change, 1e-15);
}

TEST(Enforce, no_factor_falls_below_zero) {
  // Rows far above 1, with a tiny factor that plain least squares would push below 0.
  auto factors = table(
      {1, 1, 1, 1}, {{0, 0.5, 0.7, 0.001}, {0.5, 0, 0.4, 0.3}, {0.7, 0.4, 0, 0.2}, {0.001, 0.3, 0.2, 0.6}});
  const auto done = enforce_laws(factors, Context(1));
  EXPECT_LT(done.worst_row_sum, 1e-12);
  const auto check = check_view_factors(factors, Context(1));
  EXPECT_LT(check.worst_row_sum, 1e-12);
  EXPECT_EQ(check.worst_reciprocity, 0.0);
  EXPECT_GT(check.smallest, 0.0);
}

TEST(Enforce, where_no_factors_fill_a_row_the_rest_goes_to_the_environment) {
  // A large element that sees a small one alone: it cannot give its all.
  auto factors = table({4, 1}, {{0, 1.0}, {1.0, 0}});
  const auto done = enforce_laws(factors, Context(1));
  EXPECT_LT(done.worst_row_sum, 1e-12);
  EXPECT_NEAR(factors.factor[0], 0.25, 0.01);
  EXPECT_NEAR(factors.sink[ViewFactors::environment].factor[0], 0.75, 0.01);
}

TEST(Enforce, needs_every_row) {
  auto factors = table({1, 1}, {{0, 1.0}, {1.0, 0}});
  factors.is_known[1] = 0;
  EXPECT_THROW(enforce_laws(factors, Context(1)), InputError);
}

TEST(Enforce, stopped_before_directions_were_joined_changes_nothing) {
  auto factors = table({3, 4, 5}, {{0, 0.30, 0.72}, {0.27, 0, 0.70}, {0.41, 0.62, 0}});
  const auto before = factors.factor;
  const auto done =
      enforce_laws(factors, Context(1).with_monitor([](const Progress&) { return Next::stop; }));
  EXPECT_TRUE(done.is_stopped);
  EXPECT_EQ(factors.factor, before);
}

TEST(Enforce, stopped_later_leaves_exact_reciprocity) {
  auto factors = table({3, 4, 5}, {{0, 0.30, 0.72}, {0.27, 0, 0.70}, {0.41, 0.62, 0}});
  const auto done = enforce_laws(factors, Context(1).with_monitor([](const Progress& progress) {
    return progress.stage == "enforce" ? Next::stop : Next::go_on;
  }));
  EXPECT_TRUE(done.is_stopped);
  const auto check = check_view_factors(factors, Context(1));
  EXPECT_LT(check.worst_reciprocity, 1e-15);
  EXPECT_NEAR(check.worst_row_sum, done.worst_row_sum, 1e-15);
}

TEST(CheckViewFactors, knows_pairs_that_one_side_alone_found) {
  const auto check =
      check_view_factors(table({1, 2, 1}, {{0.5, 0, 0.5}, {0.3, 0.7, 0}, {0.5, 0, 0.5}}), Context(1));
  EXPECT_NEAR(check.worst_reciprocity, 0.3, 1e-15);
  EXPECT_EQ(check.worst_pair, (std::array<std::uint32_t, 2>{0, 1}));
  EXPECT_NEAR(check.reciprocity, 0.3 / std::sqrt(2.0), 1e-15) << "two pairs are listed";
}

TEST(CheckViewFactors, stopped_says_so) {
  const auto check = check_view_factors(table({1, 2}, {{0, 0.8}, {0.5, 0.45}}),
                                        Context(1).with_monitor([](const Progress&) { return Next::stop; }));
  EXPECT_FALSE(check.is_whole);
  EXPECT_EQ(check.rows, 0u);
}

TEST(CheckViewFactors, finds_what_breaks_the_laws) {
  auto factors = table({1, 2}, {{0, 0.8}, {0.5, 0.45}});
  factors.sink[ViewFactors::environment].factor[1] = 0.05;
  const auto check = check_view_factors(factors, Context(1));
  EXPECT_EQ(check.rows, 2u);
  EXPECT_NEAR(check.worst_row_sum, 0.2, 1e-15);
  EXPECT_EQ(check.worst_row, 0u);
  EXPECT_NEAR(check.reciprocity, 0.1, 1e-15) << "0.8 against 2 * 0.5, as a factor from the larger";
  EXPECT_NEAR(check.expected_reciprocity, 0.02236, 1e-4);
  EXPECT_NEAR(check.environment, 0.1 / 3.0, 1e-15);
  EXPECT_EQ(check.smallest, 0.45);
  EXPECT_EQ(check.largest, 0.8);
}

}  // namespace
}  // namespace luxel
