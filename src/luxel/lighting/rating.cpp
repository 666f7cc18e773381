// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/rating.h"

namespace luxel {

int leed_points(double autonomy_of_space) {
  const auto s = autonomy_of_space;
  return s >= 0.75 ? 3 : s >= 0.55 ? 2 : s >= 0.40 ? 1 : 0;
}

Compliance judged(const Figure& figure, double at_least) {
  if (figure.low >= at_least) return Compliance::met;
  return figure.high < at_least ? Compliance::not_met : Compliance::cannot_be_told;
}

Compliance both(Compliance a, Compliance b) {
  if (a == Compliance::not_met || b == Compliance::not_met) return Compliance::not_met;
  return a == Compliance::met && b == Compliance::met ? Compliance::met : Compliance::cannot_be_told;
}

Compliance compliance_of(FactorProvision::Verdict verdict) {
  using V = FactorProvision::Verdict;
  return verdict == V::met       ? Compliance::met
         : verdict == V::not_met ? Compliance::not_met
                                 : Compliance::cannot_be_told;
}

Compliance compliance_by_points(const ClimateProvision& provision) {
  return both(judged(provision.points_on_target, 0.5), judged(provision.points_on_minimum, 0.95));
}

Compliance compliance_by_hours(const ClimateProvision& provision) {
  return both(judged(provision.hours_on_target, 0.5), judged(provision.hours_on_minimum, 0.5));
}

Compliance leed_exposure_compliance(const Figure& exposed) {
  if (exposed.high <= leed_exposure) return Compliance::met;
  return exposed.low > leed_exposure ? Compliance::not_met : Compliance::cannot_be_told;
}

Compliance breeam_compliance(const YearReport& year) {
  return both(judged(year.hours_mean_300, breeam_hours), judged(year.hours_min_90, breeam_hours));
}

}  // namespace luxel
