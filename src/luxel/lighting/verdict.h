// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "luxel/lighting/grid_figures.h"

namespace luxel {

// not_known: the data that the verdict needs are missing; no accuracy would decide it.
enum class Compliance { met, not_met, cannot_be_told, not_known };

// "met", "not met", "cannot be told yet", "not known".
const char* name(Compliance compliance);

// A required bound of a figure, judged by the figure's whole interval: met where all of it meets the bound,
// not met where none of it does. Each of these two verdicts is wrong with a probability of at most 2.5 %.
struct Verdict {
  std::string quantity;     // "Em", "U0", ...
  bool is_at_least = true;  // else at most
  double required = 0.0;
  Figure measured;
  Compliance compliance = Compliance::met;
  // For an open verdict: factor on the rays of this measurement that would decide it, if the value stays the
  // same (errors fall as the root of the number of rays). Absent where the error of the solution alone is too
  // large; then that error must fall to `solution_factor` of its size. A value on the bound itself has
  // neither: no accuracy would decide it.
  std::optional<double> more_rays = {}, solution_factor = {};
  std::string note = {};  // what the figure refers to, or what is missing; may be empty
};

Verdict judge(std::string quantity, const Figure& measured, double required, bool is_at_least = true);

// The remedy for a verdict that cannot be told yet, such as "9 times as many rays would tell if the value
// stays"; empty for the other ones.
std::string remedy_of(const Verdict& verdict);

// Returns the common verdict: not met if one is not, else an unclear one if any; nothing without verdicts.
std::optional<Compliance> compliance_of(const std::vector<Verdict>& verdicts);

}  // namespace luxel
