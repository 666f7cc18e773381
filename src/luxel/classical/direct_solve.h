// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "luxel/core/progress.h"
#include "luxel/core/workers.h"

namespace luxel {

// Solves B = E + rho F B by elimination: (I - rho F) B = E, as L U with partial pivoting, in blocks (Golub
// and Van Loan 2013, section 3.4), in doubles.
//
// factors: F, [row][row]. emittance (E), reflectance (rho), radiosity (B, the result): [row][band]. Cost: 2/3
// n³ operations for each set of reflectances that bands do not share (about 10 s on two cores for n = 4,000),
// and direct_solve_bytes(n). The same bits on any number of threads. False where the monitor said stop; then
// radiosity is E. Throws InputError where the matrix is singular, which no F with rows of sum 1 at most and
// rho < 1 gives.
bool solve_directly(std::span<const float> factors, std::span<const float> emittance,
                    std::span<const float> reflectance, std::span<float> radiosity, const Workers& workers,
                    const Monitor& monitor = {});

// The most it holds beside its arguments.
constexpr std::uint64_t direct_solve_bytes(std::uint64_t rows) { return 8 * rows * rows; }

}  // namespace luxel
