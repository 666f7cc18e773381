// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "luxel/classical/operator.h"
#include "luxel/core/progress.h"
#include "luxel/core/workers.h"

namespace luxel {

struct JacobiOptions {
  double tolerance = 1e-4;  // share of the power of lamps and sky that may stay unshot: the bias
  int steps = 0;            // bounces at most; 0: no bound
};

// What there is after a step.
struct JacobiStep {
  int step = 0;                       // from 1: after the first there is direct light alone
  std::span<const float> before;      // B of the step before, [row][band], W/m²
  std::span<const float> irradiance;  // H = D + F before
  std::span<const float> radiosity;   // B = E + rho H
  double unshot_fraction = 1.0;       // what stands in B but not in `before`, over the power of E and D
};
using EachStep = std::function<void(const JacobiStep& step)>;

enum class JacobiEnd { converged, step_limit, stopped };

struct JacobiReport {
  std::vector<double> unshot_fraction;  // after each step
  JacobiEnd end = JacobiEnd::converged;
};

// The plain Jacobi iteration for B = E + rho (D + F B) (Cohen and Wallace 1993, section 5.3.1): B starts as
// E, and
//
//     H = D + F B,    B = E + rho H
//
// is done over and over. D comes from outside: the sky. One step is one bounce of light, all surfaces at
// once: the first step brings direct light, each further one light that was reflected once more. It ends when
// the power that was reflected last and not yet sent on falls below the tolerance. Converges where rows of F
// sum to at most 1 and rho < 1; the unshot power falls by about the mean reflectance a step.
//
// area: [row], m². emittance (E), outside (D), reflectance (rho): [row][band]; outside may be empty: none.
// radiosity, irradiance, before: [row][band], filled with the last whole step, or with E, 0 and 0 where there
// is none. The same bits on any number of threads. The monitor hears of the stage "light" within each step,
// and its stop drops the step that was begun. Cost: one apply() a step; memory: one more copy of the rows.
JacobiReport jacobi(const TransportOperator& transport, std::span<const float> area,
                    std::span<const float> emittance, std::span<const float> outside,
                    std::span<const float> reflectance, std::span<float> before, std::span<float> irradiance,
                    std::span<float> radiosity, const JacobiOptions& options, const Workers& workers,
                    const Monitor& monitor = {}, const EachStep& each_step = {});

}  // namespace luxel
