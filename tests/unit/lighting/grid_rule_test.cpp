// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/grid_rule.h"

#include <gtest/gtest.h>

namespace luxel {
namespace {

// Values of the formula at powers of ten, and for a side of 6 m: p = 0.700 m, 9 points.
TEST(GridRule, has_the_spacing_of_the_formula) {
  EXPECT_NEAR(en12464_grid(1.0, 1.0).spacing, 0.2, 1e-12);
  EXPECT_NEAR(en12464_grid(10.0, 10.0).spacing, 1.0, 1e-12);
  EXPECT_NEAR(en12464_grid(100.0, 100.0).spacing, 5.0, 1e-12);
  const auto room = en12464_grid(6.0, 4.0);
  EXPECT_NEAR(room.spacing, 0.700, 5e-4);
  EXPECT_EQ(room.columns, 9u);
  EXPECT_EQ(room.rows, 6u);
}

TEST(GridRule, takes_the_shorter_side_of_long_areas_and_at_most_10_m) {
  EXPECT_NEAR(en12464_grid(30.0, 1.0).spacing, 0.2, 1e-12);
  EXPECT_NEAR(en12464_grid(1000.0, 900.0).spacing, 10.0, 1e-12);
  EXPECT_EQ(en12464_grid(0.05, 0.05).columns, 2u);
}

}  // namespace
}  // namespace luxel
