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

// The patches that emit, to be chosen by their power: area times the sum of emittance over bands. Nothing
// cleverer, on purpose: this is what cleverer ways are held against.
class LampTable {
 public:
  // Empty where there is no lamp.
  explicit LampTable(const PatchSet& patches);

  std::size_t size() const { return patch_.size(); }

  // A point of a lamp's front; not of an empty table. u: uniform in [0, 1), which lamp and where on it. Keeps
  // to `density`.
  SurfacePoint sample(const PatchSet& patches, const std::array<float, 3>& u) const;
  // With which `sample` gives a point of this patch's front, per m²; 0 where it is no lamp.
  double density(const PatchSet& patches, std::size_t patch) const {
    return density_[static_cast<std::size_t>(patches.material[patch])];
  }

 private:
  std::vector<std::uint32_t> patch_;
  DiscreteDistribution by_power_;
  std::vector<double> density_;  // [material], per m²
};

}  // namespace luxel
