// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/pool_units.h"

#include <cstddef>

#include "luxel/solve/tuning.h"

namespace luxel {
namespace {

class Pool {
 public:
  explicit Pool(std::span<const SeenUnit> units) : before_(units.size() + 1), density_(units.size()) {
    for (std::size_t u = 0; u < units.size(); ++u)
      before_[u + 1] = {before_[u].hits + units[u].hits, before_[u].sum + units[u].sum,
                        before_[u].area + units[u].area};
    const auto whole = over(0, units.size());
    if (!units.empty()) halve(0, units.size(), whole.sum / whole.area);
  }

  std::vector<double> take() { return std::move(density_); }

 private:
  SeenUnit over(std::size_t begin, std::size_t end) const {
    const auto& a = before_[begin];
    const auto& b = before_[end];
    return {b.hits - a.hits, b.sum - a.sum, b.area - a.area};
  }

  void halve(std::size_t begin, std::size_t end, double density) {
    if (end - begin == 1) {
      density_[begin] = density;
      return;
    }
    const auto middle = begin + (end - begin) / 2;
    const auto whole = over(begin, end);
    const auto of_half = [&](const SeenUnit& half) {
      if (!(whole.sum > 0.0)) return density;
      const auto found = half.sum / whole.sum * whole.hits;
      const auto expected = half.area / whole.area * whole.hits;
      return density * (tuning::seen::prior_hits + found) / (tuning::seen::prior_hits + expected);
    };
    const auto low = over(begin, middle), high = over(middle, end);
    const auto of_low = of_half(low), of_high = of_half(high);
    const auto sum = of_low * low.area + of_high * high.area;
    const auto scale = sum > 0.0 ? density * whole.area / sum : 1.0;
    halve(begin, middle, scale * of_low);
    halve(middle, end, scale * of_high);
  }

  std::vector<SeenUnit> before_;  // [unit]: sums over the units before it
  std::vector<double> density_;
};

}  // namespace

std::vector<double> pooled_densities(std::span<const SeenUnit> units) { return Pool(units).take(); }

}  // namespace luxel
