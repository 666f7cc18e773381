// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "luxel/session/session_snapshot.h"

namespace luxel {

// Light that arrives or leaves, for display. Errors are standard errors, where the method states them: 1.96
// of them contain the true value of this patch 95 times in 100.
struct LightValue {
  double watts = 0.0;  // W/m², all bands together
  double lux = 0.0;    // lm/m²
  std::optional<double> watts_error, lux_error;
};

// Irradiance of a side of a patch: its mean, as solved. The same rays carry all bands, so their errors are
// added as if fully correlated, which they nearly are.
LightValue irradiance_of(const SessionLight& light, std::size_t patch, bool back);
// Radiosity of the side: its emission and reflection.
LightValue radiosity_of(const SessionLight& light, std::size_t patch, bool back);
// Irradiance at the point (1 - u - v) a + u b + v c of the side as it is drawn; without an error.
LightValue smooth_irradiance(const SessionLight& light, std::size_t patch, bool back, float u, float v);

}  // namespace luxel
