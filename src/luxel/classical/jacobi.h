// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "luxel/classical/method_options.h"
#include "luxel/classical/operator.h"
#include "luxel/classical/scattering.h"
#include "luxel/core/context.h"

namespace luxel {

// The state after a step.
struct JacobiStep {
  int step = 0;                       // from 1: after the first there is direct light alone
  std::span<const float> before;      // B of the step before, [row][band], W/m²
  std::span<const float> irradiance;  // H = D + F before
  std::span<const float> radiosity;   // B = E + rho H
  double unshot_fraction = 1.0;       // what stands in B but not in `before`, over the power of E and D
};
// Input and output of the iteration.
struct JacobiRows {
  std::span<const float> area;  // [row], m²
  // The others: [row][band].
  std::span<const float> emittance;  // E
  std::span<const float> outside;    // D; empty: none
  Scattering scattering;             // rho and tau
  // Filled with the last whole step, or with 0, 0 and E where there is none.
  std::span<float> before;  // the radiosity that this step sent on
  std::span<float> irradiance;
  std::span<float> radiosity;
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
// is repeated. D comes from outside: the sky. One step is one bounce of light, all surfaces at once: the
// first step brings direct light, each further one light that was reflected once more. It ends when the power
// that was reflected last and not yet sent on falls below the tolerance. Converges where rows of F sum to at
// most 1 and rho < 1; the unshot power falls by about the mean reflectance per step.
//
// The same bits on any number of threads. The monitor receives the stage "light" within each step, and its
// stop drops the unfinished step. Cost: one apply() per step; memory: one more copy of the rows.
JacobiReport jacobi(const TransportOperator& transport, const JacobiRows& rows, const JacobiOptions& options,
                    const Context& context = {}, const EachStep& each_step = {});

}  // namespace luxel
