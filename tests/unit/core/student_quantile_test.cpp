// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/student_quantile.h"

#include <gtest/gtest.h>

namespace luxel {
namespace {

// Tables of Student's t and of the normal distribution.
TEST(StudentQuantile, agrees_with_the_tables) {
  struct Row {
    double tail, freedom, t;
  };
  for (const auto& [tail, freedom, t] :
       {Row{0.025, 7, 2.364624}, Row{0.025, 1, 12.70620}, Row{0.05, 2, 2.919986}, Row{0.005, 10, 3.169273},
        Row{0.0005, 7, 5.407883}, Row{0.025, 120, 1.979930}, Row{0.1, 5, 1.475884}, Row{0.025, 0, 1.959964},
        Row{0.025, 1e6, 1.959964}, Row{1e-6, 0, 4.753424}, Row{0.5, 7, 0.0}})
    EXPECT_NEAR(student_quantile(tail, freedom), t, 2e-5 * t + 1e-9) << tail << " " << freedom;
}

}  // namespace
}  // namespace luxel
