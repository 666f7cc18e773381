// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/discrete_distribution.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/surface_point.h"

namespace luxel {

// The patches that emit, to be chosen by their power: area times the sum of emittance over bands.
// Deliberately simple: the reference for better choices.
class LampTable {
 public:
  // Empty where there is no lamp.
  explicit LampTable(const PatchSet& patches);

  std::size_t size() const { return patch_.size(); }

  // Samples a point of a lamp's front by `density`; the table is not empty. u: uniform in [0, 1):
  // lamp and place on it.
  SurfacePoint sample(const PatchSet& patches, const std::array<float, 3>& u) const;
  // Probability density of `sample` on this patch's front, per m²; 0 where it is no lamp.
  double density(const PatchSet& patches, std::size_t patch) const {
    return density_[static_cast<std::size_t>(patches.material[patch])];
  }

 private:
  std::vector<std::uint32_t> patch_;
  DiscreteDistribution by_power_;
  std::vector<double> density_;  // [material], per m²
};

}  // namespace luxel
