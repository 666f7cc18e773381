// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "luxel/lighting/requirements.h"
#include "luxel/lighting/verdict.h"

namespace luxel {

// The figures of the illuminance of a grid that requirements bound: lx, and ratios.
struct GridIlluminance {
  const Figure &mean, &min, &min_over_mean, &min_over_max, &max_over_min;
};

// The verdicts on their requirements, in the order of a report.
inline std::vector<Verdict> judge_figures(const GridIlluminance& of, const Requirement& required) {
  std::vector<Verdict> verdicts;
  const auto add = [&](const char* name, const Figure& figure, const std::optional<double>& limit,
                       bool is_at_least = true) {
    if (limit) verdicts.push_back(judge(name, figure, *limit, is_at_least));
  };
  add("Em", of.mean, required.Em);
  add("Emin", of.min, required.Emin);
  add("U0", of.min_over_mean, required.U0);
  add("Ud", of.min_over_max, required.Ud);
  add("max_over_min", of.max_over_min, required.max_over_min, false);
  return verdicts;
}

}  // namespace luxel
