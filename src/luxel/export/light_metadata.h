// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/json.h"
#include "luxel/export/target_application.h"
#include "luxel/image/tone.h"
#include "luxel/solution/solution.h"

namespace luxel {

// Returns what glTF files with light have as asset.extras.luxel: the application, the form ("vertex",
// "lightmap", "emissive"), what the stored numbers are, and how the light was made. docs/baking.md lists the
// members.
Json light_metadata(const char* form, TargetApplication program, Json light, const Solution& solution);

// Returns the member `light` of each form.
Json vertex_light(const ToneCurve& curve, const ExportProfile& profile);
Json lightmap_light(float white, float scale);  // white: irradiance of a texel of 1, W/m²
Json emissive_light(const ToneCurve& curve);

}  // namespace luxel
