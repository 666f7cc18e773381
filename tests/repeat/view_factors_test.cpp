// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "luxel/form_factors/enforce.h"

#include "support/factor_scenes.h"

namespace luxel::truth {
namespace {

TEST(ViewFactors, are_the_same_bits_on_any_number_of_threads) {
  const auto scene = l_room();
  for (const auto kind : {Between::materials, Between::patches}) {
    std::vector<ViewFactors> results;
    for (const int threads : {1, 2, 5}) {
      const Context context(threads);
      const auto patches = make_patches(scene, {.max_edge = 0.3f});
      const Tracer tracer(patches, context);
      const auto elements = make_view_elements(scene, patches, kind, ElementSides::both);
      SampleFactorsReport report;
      auto factors = *sample_view_factors(patches, tracer, elements, {.error = 0.004}, report, context);
      enforce_laws(factors, context);
      results.push_back(std::move(factors));
    }
    for (std::size_t i = 1; i < results.size(); ++i) {
      EXPECT_EQ(results[0].row_begin, results[i].row_begin);
      EXPECT_EQ(results[0].column, results[i].column);
      EXPECT_EQ(results[0].factor, results[i].factor);
      EXPECT_EQ(results[0].standard_error, results[i].standard_error);
      for (std::size_t k = 0; k < ViewFactors::sinks; ++k)
        EXPECT_EQ(results[0].sink[k].factor, results[i].sink[k].factor);
    }
  }
}

TEST(ViewFactors, of_some_rows_are_those_of_all_rows) {
  const FactorScene room(l_room(), Between::patches, ElementSides::front, 0.5f);
  const auto all = room.counted({.rays = 256, .error = 0.0});
  SampleFactorsOptions some{.rays = 256, .error = 0.0};
  some.rows.assign(all.size(), 0);
  some.rows[7] = 1;
  const auto one = room.counted(some);
  EXPECT_EQ(one.count(), all.row_begin[8] - all.row_begin[7]);
  for (std::uint64_t at = 0; at < one.count(); ++at) {
    EXPECT_EQ(one.column[at], all.column[all.row_begin[7] + at]);
    EXPECT_EQ(one.factor[at], all.factor[all.row_begin[7] + at]);
  }
  EXPECT_EQ(one.is_known[7], 1);
  EXPECT_EQ(one.is_known[8], 0);
}

}  // namespace
}  // namespace luxel::truth
