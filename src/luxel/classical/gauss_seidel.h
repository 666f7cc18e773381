// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "luxel/classical/operator.h"
#include "luxel/classical/scattering.h"
#include "luxel/core/context.h"

namespace luxel {

struct GaussSeidelOptions {
  double tolerance = 1e-6;  // of the whole radiosity: estimated distance to the fixed point
  std::size_t parts = 8;    // rows are taken in this many parts; 1 is the Jacobi iteration
  std::size_t memory = 3;   // earlier sweeps used by Anderson's acceleration; 0 disables it
  // Tolerance of the sums over all rows, one per band; 0 disables the test. Where the radiosity is noise, the
  // component common to all rows is a small part of the whole and converges last.
  double sum_tolerance = 0.0;
  int max_sweeps = 10'000;
};

struct GaussSeidelReport {
  std::vector<double> change;  // of each sweep: sum of |new - old| over sum of |new|
  double distance = 0.0;       // estimated, to the fixed point, over the whole radiosity
  double sum_distance = 0.0;   // estimated, of the sums over all rows; 0 where these are not tested
  bool converged = false;
  bool is_stopped = false;  // the monitor stopped it amid a sweep
};

// Input and output of the iteration. Rows: [row][band].
struct GaussSeidelRows {
  std::span<const float> direct;  // D
  Scattering scattering;          // rho and tau
  // The start and the result, [element][band], at least the rows; elements behind them (sinks) stay.
  std::span<float> radiosity;
  std::span<float> irradiance;  // out: D + F B
};

// Solves B = S (D + F B), with S the scattering of arriving light (rho, and tau from the other side), by
// block Gauss-Seidel (Cohen and Wallace 1993, section 5.3): the rows of one part are computed in parallel
// from the newest radiosities of the others. Between sweeps the radiosity is replaced by the combination of
// the last ones whose changes cancel best (Anderson 1965; Walker and Ni 2011). Where the sides of diffusers
// are in different parts there is one part. Parts are fixed and sums are ordered, so the bits do not depend
// on the number of threads. Converges for any F whose rows sum to at most 1 and rho + tau < 1.
//
// Cost: one apply() per sweep; memory: 2 * memory + 2 copies of the rows. The monitor is polled after each
// part.
GaussSeidelReport gauss_seidel(const TransportOperator& transport, const GaussSeidelRows& rows,
                               const GaussSeidelOptions& options, const Context& context = {});

}  // namespace luxel
