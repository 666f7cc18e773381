// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/light_metadata.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/utf8.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

constexpr const char* radiance_from_irradiance = "reflectance * irradiance / pi";

Json after_tone_curve(const ToneCurve& curve, const char* encoding) {
  return {{"quantity", "radiance after the tone curve"},
          {"unit", "1: the display's white"},
          {"encoding", encoding},
          {"tone", name(curve.options.op)},
          {"scale", curve.scale}};
}

}  // namespace

Json light_metadata(const char* form, TargetApplication program, Json light, const Solution& solution) {
  const auto& from = solution.provenance;
  return {{"made_for", name(program)},
          {"as", form},
          {"light", std::move(light)},
          {"method", valid_utf8(from.method)},
          {"rays", from.rays},
          {"seed", fmt::format("{}", from.seed)},  // text: many programs read JSON's numbers with 53 bits
          {"unshot_fraction", solution.unshot_fraction},
          {"seen_error", solution.seen_error},
          {"predicted_error", solution.predicted_error},
          {"scene_fingerprint", fmt::format("{:016x}", from.scene_fingerprint)}};
}

Json vertex_light(const ToneCurve& curve, const ExportProfile& profile) {
  Json light = {
      {"COLOR_0", after_tone_curve(curve, profile.colours_are_srgb ? "sRGB codes" : "linear sRGB")}};
  if (profile.keeps_irradiance)
    light["_IRRADIANCE"] = {{"quantity", "irradiance"},
                            {"unit", "W/m2 by linear sRGB"},
                            {"radiance", radiance_from_irradiance},
                            {"lumens_per_watt", luminous_efficacy}};
  return light;
}

Json lightmap_light(float white, float scale) {
  return {{"quantity", "irradiance / white"},     {"encoding", "sRGB codes"},     {"white_W_per_m2", white},
          {"radiance", radiance_from_irradiance}, {"intensity", "white * scale"}, {"scale", scale},
          {"lumens_per_watt", luminous_efficacy}};
}

Json emissive_light(const ToneCurve& curve) { return after_tone_curve(curve, "sRGB codes"); }

}  // namespace luxel
