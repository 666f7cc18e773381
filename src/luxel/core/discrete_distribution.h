// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace luxel {

// Elements 0, 1, ... with weights, drawn with probability in proportion to the weight. Adding is linear,
// drawing logarithmic. The running sum is added in order, so that the same weights and number always give the
// same element.
class DiscreteDistribution {
 public:
  void clear() { up_to_.clear(); }
  // weight: not negative. Elements of weight 0 are never drawn, unless all weights are 0.
  void add(double weight) {
    assert(weight >= 0.0);
    up_to_.push_back(total() + weight);
  }

  std::size_t size() const { return up_to_.size(); }
  double total() const { return up_to_.empty() ? 0.0 : up_to_.back(); }
  double before(std::size_t element) const {
    assert(element <= size());
    return element == 0 ? 0.0 : up_to_[element - 1];
  }
  double weight(std::size_t element) const { return up_to_[element] - before(element); }

  // The element at u, uniform in [0, 1). There must be one.
  std::size_t choose(double u) const {
    assert(u >= 0.0 && u < 1.0);
    return at(u * total());
  }
  // The element at a place on the line of all weights, in [0, total()); the last one beyond.
  std::size_t at(double place) const {
    assert(size() > 0);
    return static_cast<std::size_t>(std::upper_bound(up_to_.begin(), up_to_.end() - 1, place) -
                                    up_to_.begin());
  }

  // Normalises the weights to probabilities of total 1. The fraction `even` is spread evenly over all
  // elements; all of it where the total was 0.
  void normalise(double even = 0.0) {
    assert(even >= 0.0 && even <= 1.0);
    const auto sum = total();
    const auto count = static_cast<double>(size());
    for (std::size_t i = 0; i < size(); ++i) {
      const auto of_even = static_cast<double>(i + 1) / count;
      up_to_[i] = sum > 0.0 ? (1.0 - even) * up_to_[i] / sum + even * of_even : of_even;
    }
    if (!up_to_.empty()) up_to_.back() = 1.0;
  }

 private:
  std::vector<double> up_to_;  // [element]: the weight of it and all before it
};

}  // namespace luxel
