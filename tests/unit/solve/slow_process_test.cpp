// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/slow_process.h"

#include <vector>

#include <gtest/gtest.h>

namespace luxel {
namespace {

TEST(SlowProcess, is_the_one_that_all_others_waited_for) {
  const auto slow = slow_process(std::vector{9.0, 1.5, 8.0, 7.5}, 60.0);
  ASSERT_TRUE(slow);
  EXPECT_EQ(slow->process, 1u);
  EXPECT_DOUBLE_EQ(slow->seconds, 6.0);
}

TEST(SlowProcess, is_none_where_waits_are_short_or_common) {
  EXPECT_FALSE(slow_process(std::vector<double>{}, 60.0));
  EXPECT_FALSE(slow_process(std::vector{0.0}, 60.0));
  EXPECT_FALSE(slow_process(std::vector{0.9, 0.0}, 10.0)) << "below a second";
  EXPECT_FALSE(slow_process(std::vector{40.0, 10.0}, 1000.0)) << "below a twentieth of the work";
  EXPECT_FALSE(slow_process(std::vector{20.0, 1.0, 1.1}, 60.0)) << "two are equally late";
}

}  // namespace
}  // namespace luxel
