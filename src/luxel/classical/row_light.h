// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/classical/energy.h"
#include "luxel/classical/row_operator.h"
#include "luxel/classical/scattering.h"
#include "luxel/solution/solution.h"

namespace luxel {

// The light of the receivers of a row operator while it is solved. [receiver][band], W/m².
struct RowLight {
  std::vector<float> area;        // [receiver], m²
  ScatteringTable scattering;     // of the receivers' patches
  std::vector<float> emittance;   // E: fronts only
  std::vector<float> before;      // the radiosity that the irradiance comes from
  std::vector<float> from_sky;    // D: irradiance straight from the sky
  std::vector<float> irradiance;  // H = D + F before; 0 where nothing was sent on yet
  std::vector<float> radiosity;   // B = E + rho H + tau H of the other side

  // Starts without reflected light: B is E.
  explicit RowLight(const RowOperator& transport);
};

// Writes irradiance and radiosity of both sides of every patch, and the standard errors where there are such
// ([receiver][band]).
void write_light(const RowOperator& transport, const RowLight& light,
                 const std::vector<float>& standard_error, Solution& solution);

// Energy balance, each part from its own quantity: absorbed from the irradiance, escaped and lost at backs
// from the losses of the rows, unshot from what the last step reflected. The sum equals the power of lamps
// and sky as far as the factors are reciprocal and their rows sum to one: to rounding for dense, within the
// noise for lines, within the aliasing for hemicubes.
EnergyAccount energy_of(const RowOperator& transport, const RowLight& light);

// Area-weighted relative RMS: sqrt(sum of A error² / sum of A H²).
double whole_error(const RowLight& light, const std::vector<float>& standard_error);

}  // namespace luxel
