// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/lighting/daylight_factor.h"
#include "luxel/lighting/metrics.h"
#include "luxel/lighting/verdict.h"

namespace luxel {

// Fraction of the points with direct sun above which LEED v4.1 requires an explanation.
inline constexpr double leed_exposure = 0.10;
// Hours of a year that BREEAM needs of 300 lx in the mean and 90 lx at the darkest point.
inline constexpr double breeam_hours = 2000.0;

// Points of LEED v4.1, daylight option 1, by sDA300,50% with operated blinds: 1 from 40 %, 2 from 55 %, 3
// from 75 % on.
int leed_points(double autonomy_of_space);

// Judges by the whole interval; a figure without an extent by its value.
Compliance judged(const Figure& figure, double at_least);
// Verdict on two requirements together.
Compliance both(Compliance a, Compliance b);

Compliance compliance_of(FactorProvision::Verdict verdict);
Compliance compliance_by_points(const ClimateProvision& provision);
Compliance compliance_by_hours(const ClimateProvision& provision);
// Whether ASE1000,250 is at most that of LEED.
Compliance leed_exposure_compliance(const Figure& exposed);
Compliance breeam_compliance(const YearReport& year);

}  // namespace luxel
