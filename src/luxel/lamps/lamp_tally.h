// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/lamps/lamp_choices.h"
#include "luxel/lamps/lamps.h"

namespace luxel {

// Sums of unshadowed and of visible samples of a lamp, at unit radiance.
struct LampTally {
  double all = 0.0;
  double seen = 0.0;

  LampTally& operator+=(const LampTally& other) {
    all += other.all;
    seen += other.seen;
    return *this;
  }
  LampTally operator-(const LampTally& other) const { return {all - other.all, seen - other.seen}; }
};

// Adds value times the lamp's radiance to the sums of one replicate, [group][band].
void add_radiance(double* sum, double value, const Lamps& lamps, std::uint32_t lamp);

// The samples of one receiver.
struct TalliedLamps {
  const LampChoices& choices;
  const Lamps& lamps;
  std::span<const double> irradiance;  // [lamp chosen individually]: W/m² at unit radiance, nothing between
  std::span<const LampTally> tally;    // [replicate][lamp chosen individually]
  std::uint32_t replicates = 1;
  double per_sample = 1.0;  // 1 / samples per replicate
};

// Adds the estimates of the lamps chosen individually to sum, [replicate][group][band]. control_variate: each
// replicate is corrected by the closed form of the irradiance, with the visibility that the other replicates
// found; see DirectLight. Reuses its memory.
class LampEstimates {
 public:
  void add(const TalliedLamps& samples, bool control_variate, std::span<double> sum);

 private:
  void correct(const TalliedLamps& samples, std::span<const LampTally> own);

  std::vector<LampTally> whole_, others_;  // [lamp chosen individually]
  std::vector<double> value_;
};

}  // namespace luxel
