// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "luxel/classical/scattering.h"
#include "luxel/core/context.h"

namespace luxel {

// Solves B = E + rho F B by elimination: (I - rho F) B = E (with diffusers, rho F plus tau times the row of
// the other side), as L U with partial pivoting, in blocks (Golub and Van Loan 2013, section 3.4), in
// doubles.
//
// factors: F, [row][row]. emittance (E), scattering (rho, tau), radiosity (B, the result): [row][band]. Cost:
// 2/3 n³ operations for each set of reflectances that bands do not share (about 3 s on two cores for n =
// 4,000; rows that do not see one another, like the two sides of a closed box, are solved apart), and
// direct_solve_bytes(n). The same bits on any number of threads. Returns false where the monitor stops the
// work; radiosity is then E. Throws InputError where the matrix is singular, which cannot occur for F with
// rows of sum 1 at most and rho < 1.
bool solve_directly(std::span<const float> factors, std::span<const float> emittance,
                    const Scattering& scattering, std::span<float> radiosity, const Context& context = {});

// The most it holds beside its arguments.
constexpr std::uint64_t direct_solve_bytes(std::uint64_t rows) { return 8 * rows * rows; }

}  // namespace luxel
