// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/lighting/grid_figures.h"
#include "luxel/lighting/verdict.h"
#include "luxel/render/surface_measure.h"

namespace luxel {

// Numbers as a report prints them: three or more digits that a reader can use, no exponents.
// more: further decimal places.
std::string lux_text(double lux, int more = 0);      // "512", "48.3", "0.42"
std::string ratio_text(double ratio, int more = 0);  // "0.62"
std::string ugr_text(double ugr, int more = 0);      // "17.4"; an en dash where there is none

inline Figure figure_of(const MeasuredNumber& number) { return {number.value, number.low, number.high}; }

// "498 to 526", with one more decimal place where the ends would read alike; empty where there is no
// interval.
std::string interval_text(const Figure& number, std::string (*text)(double, int));
// With the interval: "512 (498 to 526)"; without it where there is none.
std::string lux_text(const Figure& number);
std::string ratio_text(const Figure& number);
std::string ugr_text(const Figure& number);

// "U0 ≥ 0.6", "Em ≥ 500 lx", "Emax : Emin ≤ 40".
std::string requirement_text(const Verdict& verdict);
// The number of a verdict, and its interval, as interval_text().
std::string measured_text(const Verdict& verdict);
std::string interval_text(const Verdict& verdict);
// The sentence of a report on a verdict without its last words, the verdict itself: "U0 0.43 (0.40 to 0.46),
// at least 0.6: ".
std::string beginning_of(const Verdict& verdict);

}  // namespace luxel
