// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "luxel/form_factors/view_factors.h"

namespace luxel {

// Sums over rays, for every pair (element, number met) that occurred and every replicate. Memory: about 100
// bytes per pair and 8 replicates.
class GroupSums {
 public:
  explicit GroupSums(std::uint32_t replicates) : replicates_(replicates) {}

  void add(std::uint32_t from, std::uint32_t met, std::uint32_t replicate, double amount) {
    sums_[place_of(from, met) * replicates_ + replicate] += amount;
  }
  // Adds pairs in the order in which `other` met them.
  void add(const GroupSums& other);

  std::size_t pairs() const { return keys_.size(); }
  std::uint64_t bytes() const { return pairs() * (replicates_ * sizeof(double) + 40); }

  // The sums over `whole`, [element], as factors. Elements with 0 have no row.
  void write(std::span<const double> whole, double min_factor, ViewFactors& factors) const;

 private:
  std::size_t place_of(std::uint32_t from, std::uint32_t met);

  std::uint32_t replicates_;
  std::unordered_map<std::uint64_t, std::size_t> places_;  // never walked
  std::vector<std::uint64_t> keys_;                        // from << 32 | met, as they came
  std::vector<double> sums_;                               // [place][replicate]
  std::uint64_t last_key_ = ~std::uint64_t{0};
  std::size_t last_place_ = 0;
};

// Root mean square standard error of the listed factors.
double rms_standard_error(const ViewFactors& factors);

}  // namespace luxel
