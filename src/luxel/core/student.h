// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// The 97.5 % point of Student's t over that of the normal distribution (Cornish and Fisher 1938): what makes
// 1.96 standard errors with so many degrees of freedom hold the truth 95 times in 100. Within 1 %
// from 3 on.
constexpr double student_widening(double degrees_of_freedom) {
  return 1.0 + (2.37 / degrees_of_freedom + 2.82 / (degrees_of_freedom * degrees_of_freedom) +
                2.6 / (degrees_of_freedom * degrees_of_freedom * degrees_of_freedom)) /
                   1.96;
}

}  // namespace luxel
