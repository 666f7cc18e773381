// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/classical/lines_operator.h"
#include "luxel/classical/row_light.h"
#include "luxel/core/context.h"

namespace luxel {

// Estimates the standard error of the irradiance by local lines, [receiver][band], W/m².
//
// N lines of receiver i are N draws from the radiosities around it, so its gathered irradiance has the
// variance
//
//     s_i² = (sum_j F_ij B_j² - H_i²) / N + (max B / N)² / 2
//
// (multinomial; the sky is one of the j; the second term is half a line that met the brightest element, for
// lines may have missed a small lamp altogether). Errors propagate from receiver to receiver as light does, e
// = s + F rho e. The propagated part is estimated from a few sets of errors of random signs sent through the
// operator. Cost: some eighty apply().
std::vector<float> line_errors(const LinesOperator& transport, const RowLight& light, std::uint64_t seed,
                               const Context& context);

}  // namespace luxel
