// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/classical/energy.h"
#include "luxel/solve/sampled_operator.h"

namespace luxel {

// Where the light of a sampled solution goes: what receivers take up, and what their rays bring to the sinks.
// It adds up to within the error of the light; nothing is unshot. irradiance: [receiver * bands + band],
// W/m². Cost: one look-up per ray. The same bits on any number of threads.
EnergyAccount energy_of(const PatchSet& patches, const SampledOperator& transport,
                        const std::vector<float>& irradiance, const Workers& workers);

}  // namespace luxel
