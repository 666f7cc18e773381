// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/solve/polynomial_fit.h"

namespace luxel {

// Some of the replicates, as columns of fits: values [replicate][slot * bands + band], places [slot]. Keeps
// both; slots apart from each other may be read and replaced at once.
class ReplicateHalf {
 public:
  ReplicateHalf(std::span<std::vector<float>> values, std::size_t bands, std::span<const FitPlace> places)
      : values_(values), places_(places), columns_{values.size(), bands} {}

  Columns columns() const { return columns_; }

  // Adds slots to moments, and to `raw`, where there is one, the energy of their own numbers.
  void add(std::uint32_t first, std::uint32_t end, Moments& m, Energy* raw) const;

  double area(std::uint32_t slot) const { return static_cast<double>(places_[slot].area); }

  // Appends the means over replicates, [slot - first][band]: of the slots' own numbers, or of a fit.
  void append_means(std::uint32_t first, std::uint32_t end, std::vector<float>& means) const;
  void append_means(std::uint32_t first, std::uint32_t end, const Moments& m, const PolynomialFit& fit,
                    std::vector<float>& means) const;

  // Puts a fit's values in the slots' place.
  void replace(std::uint32_t first, std::uint32_t end, const Moments& m, const PolynomialFit& fit) const;

 private:
  std::span<std::vector<float>> values_;
  std::span<const FitPlace> places_;
  Columns columns_;
};

}  // namespace luxel
