// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/classical/lines_operator.h"
#include "luxel/classical/row_light.h"
#include "luxel/core/workers.h"

namespace luxel {

// The standard error of the irradiance by local lines, [receiver][band], W/m².
//
// N lines of receiver i are N draws from the radiosities around it, so what it gathers has the variance
//
//     s_i² = (sum_j F_ij B_j² - H_i²) / N + (max B / N)² / 2
//
// (multinomial; the sky is one of the j; the second term is half a line that met the brightest there is, for
// lines may have missed a small lamp altogether). Errors go on from receiver to receiver as light does, e = s
// + F rho e. What that adds is estimated from a few sets of errors of random signs sent through the operator.
// Cost: some eighty apply().
std::vector<float> line_errors(const LinesOperator& transport, const RowLight& light, std::uint64_t seed,
                               const Workers& workers);

}  // namespace luxel
