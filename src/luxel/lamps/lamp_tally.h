// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/lamps/lamp_choices.h"
#include "luxel/lamps/lamp_rays.h"
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

// Adds a sample to its place in the tally, and to that of each band; seen_of_band may be empty.
void add_to_tally(const LampTerm& term, std::size_t place, std::span<LampTally> tally,
                  std::span<double> seen_of_band);

// Adds value times the lamp's radiance to the sums of one replicate, [group][band].
void add_radiance(double* sum, double value, const Lamps& lamps, std::uint32_t lamp);
// Adds the value of one sample, including the transmittance of panes in each band.
void add_sample(double* sum, const LampTerm& term, double per_sample, const Lamps& lamps);
// Adds the difference between the sky patch behind a portal and the mean of the sky, which the lamp has.
// Nothing where the lamp is no portal or the sky is even.
void add_sky_difference(double* sum, const LampTerm& term, double per_sample, const Lamps& lamps);

// The samples of one receiver.
struct TalliedLamps {
  const LampChoices& choices;
  const Lamps& lamps;
  std::span<const double> irradiance;  // [lamp chosen individually]: W/m² at unit radiance, nothing between
  std::span<const LampTally> tally;    // [replicate][lamp chosen individually]
  // With tinted panes, LampTally::seen of each band: [replicate][lamp chosen individually][band].
  std::span<const double> seen_of_band = {};
  std::uint32_t replicates = 1;
  double per_sample = 1.0;  // 1 / samples per replicate
};

// Adds the estimates of the lamps chosen individually to sum, [replicate][group][band]. control_variate: each
// replicate is corrected by the closed form of the irradiance, with the visibility that the other replicates
// found; see DirectLight. Behind tinted panes the estimate for all bands together is in turn the control
// variate of each band, with the tint that the other replicates found. Reuses its memory.
class LampEstimates {
 public:
  void add(const TalliedLamps& samples, bool control_variate, std::span<double> sum);

 private:
  void correct(const TalliedLamps& samples, std::span<const LampTally> own);
  void add_tinted(const TalliedLamps& samples, std::uint32_t replicate, std::size_t lamp, double* sum) const;

  std::vector<LampTally> whole_, others_;  // [lamp chosen individually]
  std::vector<double> whole_of_band_;      // [lamp chosen individually][band]
  std::vector<double> value_;
};

}  // namespace luxel
