// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/verdict.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace luxel {
namespace {

constexpr double max_more_rays = 1e4;  // beyond it, rays are no practical answer

// distance: from the value to the bound; reach: to the end of the interval beyond it; sampling: part of the
// variance that more rays reduce.
void estimate_effort(double distance, double reach, double sampling, Verdict& verdict) {
  const auto needed = distance / reach;  // ratio of the deciding error to the present one
  const auto left = needed * needed - (1.0 - sampling);
  if (left > 0.0 && sampling / left <= max_more_rays)
    verdict.more_rays = sampling / left;
  else if (needed * needed * max_more_rays > 1.0 && sampling < 1.0)
    verdict.solution_factor = needed;
}

}  // namespace

const char* name(Compliance compliance) {
  switch (compliance) {
    case Compliance::met:
      return "met";
    case Compliance::not_met:
      return "not met";
    case Compliance::cannot_be_told:
      return "cannot be told yet";
    case Compliance::not_known:
      return "not known";
  }
  return "";
}

Verdict judge(std::string quantity, const Figure& measured, double required, bool is_at_least) {
  Verdict verdict{std::move(quantity), is_at_least, required, measured};
  const bool all = is_at_least ? measured.low >= required : measured.high <= required;
  const bool no_part = is_at_least ? measured.high < required : measured.low > required;
  verdict.compliance = all ? Compliance::met : no_part ? Compliance::not_met : Compliance::cannot_be_told;
  if (verdict.compliance != Compliance::cannot_be_told) return verdict;
  if (measured.value > required)
    estimate_effort(measured.value - required, measured.value - measured.low, measured.low_sampling, verdict);
  else
    estimate_effort(required - measured.value, measured.high - measured.value, measured.high_sampling,
                    verdict);
  return verdict;
}

std::string remedy_of(const Verdict& verdict) {
  if (verdict.compliance != Compliance::cannot_be_told) return "";
  constexpr double min_more_rays = 1.1;  // printed; fewer are no practical advice
  if (verdict.more_rays)
    return fmt::format("{:.3g} times as many rays would tell if the value stays",
                       std::max(min_more_rays, *verdict.more_rays));
  if (verdict.solution_factor)
    return fmt::format("the error of the solution is too large: it must fall to {:.2g} of what it is",
                       *verdict.solution_factor);
  return "the value lies on the bound, and no practical number of rays tells";
}

std::optional<Compliance> compliance_of(const std::vector<Verdict>& verdicts) {
  if (verdicts.empty()) return std::nullopt;
  for (const auto one : {Compliance::not_met, Compliance::cannot_be_told, Compliance::not_known})
    if (std::any_of(verdicts.begin(), verdicts.end(), [&](const Verdict& v) { return v.compliance == one; }))
      return one;
  return Compliance::met;
}

}  // namespace luxel
