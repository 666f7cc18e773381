// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "luxel/session/session_snapshot.h"

namespace luxel {

// Light that arrives, or leaves, as a person reads it. Errors are standard errors, where the method states
// any: 1.96 of them hold the truth of this patch 95 times in 100.
struct LightValue {
  double watts = 0.0;  // W/m², all bands together
  double lux = 0.0;    // lm/m²
  std::optional<double> watts_error, lux_error;
};

// What arrives at a side of a patch: its mean, as it was solved. The same rays carry all bands, so their
// errors are added as if they went together, which they do or nearly.
LightValue irradiance_of(const SessionLight& light, std::size_t patch, bool back);
// Radiosity of the side: its emission and reflection.
LightValue radiosity_of(const SessionLight& light, std::size_t patch, bool back);
// What arrives at a point of it as it is drawn, (1 - u - v) a + u b + v c; without an error.
LightValue smooth_irradiance(const SessionLight& light, std::size_t patch, bool back, float u, float v);

}  // namespace luxel
