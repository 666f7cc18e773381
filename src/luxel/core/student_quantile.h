// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// Returns t such that a variable with Student's t distribution exceeds it with the probability `tail`, in
// (0, 0.5]: 2.365 for 2.5 % and 7 degrees of freedom. degrees_of_freedom: at least 1; 0 or more than a
// thousand: the normal distribution. Relative error below 1e-5 for tails above 1e-12. Costs about 1 ms.
double student_quantile(double tail, double degrees_of_freedom);

}  // namespace luxel
