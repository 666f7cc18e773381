// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <nlohmann/json.hpp>

#include "luxel/lighting/verdict.h"

namespace luxel {

// Null where the number is infinite.
inline nlohmann::ordered_json number_json(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

inline nlohmann::ordered_json figure_json(const Figure& f) {
  return {{"value", number_json(f.value)}, {"low", number_json(f.low)}, {"high", number_json(f.high)}};
}

// A verdict as all commands report it.
inline nlohmann::ordered_json verdict_json(const Verdict& v) {
  nlohmann::ordered_json json = {
      {"quantity", v.quantity},
      {"relation", v.is_at_least ? "at_least" : "at_most"},
      {"required", v.required},
      {"measured",
       v.compliance == Compliance::not_known ? nlohmann::ordered_json(nullptr) : figure_json(v.measured)},
      {"verdict", name(v.compliance)}};
  if (!v.note.empty()) json["note"] = v.note;
  if (v.more_rays) json["more_rays"] = *v.more_rays;
  if (v.solution_factor) json["solution_error_factor"] = *v.solution_factor;
  return json;
}

}  // namespace luxel
