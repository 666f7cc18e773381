// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "luxel/parallel/workers.h"
#include "luxel/transport/operator.h"

namespace luxel {

struct GaussSeidelOptions {
  double tolerance = 1e-6;  // of the whole radiosity: estimated distance to the fixed point
  std::size_t parts = 8;    // rows are taken in this many parts; 1 is the Jacobi iteration
  int max_sweeps = 10'000;
};

struct GaussSeidelReport {
  std::vector<double> change;  // of each sweep: sum of |new - old| over sum of |new|
  double distance = 0.0;       // estimated, to the fixed point, over the whole radiosity
  bool converged = false;
};

// Solves B = rho (D + F B) by block Gauss-Seidel (Cohen and Wallace 1993, section 5.3): the rows of one part
// are computed side by side from the newest radiosities of the others. Parts are fixed, so the bits do not
// depend on the number of threads. Converges for any F whose rows sum to at most 1 and rho < 1, each sweep
// about as well as one and a half of Jacobi's.
//
// direct (D), reflectance (rho), irradiance (out: D + F B): [row][band]. radiosity: the start and the result,
// [element][band], at least the rows; what stands behind them (sinks) is left alone. Cost: one apply() a
// sweep.
GaussSeidelReport gauss_seidel(const TransportOperator& transport, std::span<const float> direct,
                               std::span<const float> reflectance, std::span<float> radiosity,
                               std::span<float> irradiance, const GaussSeidelOptions& options,
                               const Workers& workers);

}  // namespace luxel
