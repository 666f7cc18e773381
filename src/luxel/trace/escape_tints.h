// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/trace/panes.h"

namespace luxel {

// Tints of escapes through tinted panes of glass. A ray that escapes has no weight, so it is dealt to one of
// a few tints, at random, such that the mean of each band is right: to the tint of one material of glass,
// with the largest probability that leaves nothing negative, and what is left to single bands. Tint b < bands
// is that of band b alone; the others are those of materials, at an angle of incidence of 45 degrees.
class EscapeTints {
 public:
  EscapeTints(const PatchSet& patches, const Panes& panes);

  // Number of tints; 0 where no pane is tinted.
  std::size_t size() const { return tints_.size(); }
  // Transmittance of a tint in a band, over the mean transmittance of panes over all bands; 0 or more.
  double of(std::size_t tint, std::size_t band) const { return tints_[tint][band]; }

  // The tint of a ray: through, [band], by panes; transmitted: its mean over the bands, above 0; u: uniform
  // in [0, 1). None: all bands alike.
  std::optional<std::size_t> choose(std::span<const double> through, double transmitted, double u) const;

 private:
  std::vector<double> weights_;             // [band], of Panes
  std::vector<std::vector<double>> tints_;  // [tint][band]
};

}  // namespace luxel
