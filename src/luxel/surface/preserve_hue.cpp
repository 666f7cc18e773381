// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/preserve_hue.h"

#include <algorithm>
#include <vector>

namespace luxel {
namespace {

// Smallest fraction of the unit's colour that a band retains. Chosen by eye: less is visible as a tint.
constexpr double min_of_hue = 0.25;

// One unit: receivers [first, end).
class Unit {
 public:
  Unit(std::span<float> mean, std::size_t bands, std::span<const float> area, std::size_t first,
       std::size_t end)
      : mean_(mean), bands_(bands), area_(area), first_(first), end_(end) {}

  void preserve_hue() {
    if (!has_negative()) return;
    const auto before = power();
    double whole = 0.0;
    for (const auto p : before) whole += std::max(0.0, p);
    for (auto s = first_; s < end_; ++s) move(s, before, whole);
    const auto after = power();
    for (auto s = first_; s < end_; ++s)
      for (std::size_t b = 0; b < bands_; ++b)
        if (after[b] > 0.0) value(s, b) *= static_cast<float>(std::max(0.0, before[b]) / after[b]);
  }

 private:
  float& value(std::size_t receiver, std::size_t band) { return mean_[receiver * bands_ + band]; }

  bool has_negative() {
    for (auto i = first_ * bands_; i < end_ * bands_; ++i)
      if (mean_[i] < 0.0f) return true;
    return false;
  }
  std::vector<double> power() {
    std::vector<double> sum(bands_, 0.0);
    for (auto s = first_; s < end_; ++s)
      for (std::size_t b = 0; b < bands_; ++b) sum[b] += static_cast<double>(area_[s] * value(s, b));
    return sum;
  }
  // colour: of the unit; whole: the sum of its bands above 0.
  void move(std::size_t receiver, const std::vector<double>& colour, double whole) {
    double light = 0.0;
    bool is_negative = false;
    for (std::size_t b = 0; b < bands_; ++b) {
      light += static_cast<double>(value(receiver, b));
      is_negative |= value(receiver, b) < 0.0f;
    }
    if (!is_negative) return;
    if (!(whole > 0.0)) light = 0.0;
    light = std::max(0.0, light);
    const auto in_hue = [&](std::size_t b) {
      return whole > 0.0 ? light * std::max(0.0, colour[b]) / whole : 0.0;
    };
    double fraction = 0.0;  // of the way to the unit's colour
    for (std::size_t b = 0; b < bands_; ++b) {
      const auto own = static_cast<double>(value(receiver, b));
      const auto wanted = in_hue(b);
      if (own < min_of_hue * wanted)
        fraction = std::max(fraction, (min_of_hue * wanted - own) / (wanted - own));
    }
    for (std::size_t b = 0; b < bands_; ++b) {
      auto& own = value(receiver, b);
      own = std::max(0.0f,
                     static_cast<float>((1.0 - fraction) * static_cast<double>(own) + fraction * in_hue(b)));
    }
  }

  std::span<float> mean_;
  std::size_t bands_;
  std::span<const float> area_;
  std::size_t first_, end_;
};

}  // namespace

void preserve_hue(std::span<float> mean, std::size_t bands, std::span<const float> area,
                  std::span<const std::uint32_t> begins) {
  for (std::size_t u = 0; u + 1 < begins.size(); ++u)
    Unit(mean, bands, area, begins[u], begins[u + 1]).preserve_hue();
}

}  // namespace luxel
