// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/escape_tints.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "luxel/scene/glass.h"

namespace luxel {
namespace {

constexpr std::size_t max_materials = 8;
constexpr double typical_cosine = 0.7071;

}  // namespace

EscapeTints::EscapeTints(const PatchSet& patches, const Panes& panes)
    : weights_(panes.weights().begin(), panes.weights().end()) {
  if (!panes.is_tinted()) return;
  const auto bands = weights_.size();
  for (std::size_t b = 0; b < bands; ++b) {
    tints_.emplace_back(bands, 0.0);
    tints_[b][b] = 1.0 / weights_[b];
  }
  for (const auto& material : patches.materials) {
    if (material.transmittance.empty() || tints_.size() == bands + max_materials) continue;
    std::vector<double> tint;
    for (const auto t : material.transmittance)
      tint.push_back(pane_transmittance(static_cast<double>(t), typical_cosine));
    const auto mean = std::inner_product(tint.begin(), tint.end(), weights_.begin(), 0.0);
    if (!(mean > 0.0)) continue;  // closed
    for (auto& t : tint) t /= mean;
    if (*std::max_element(tint.begin(), tint.end()) > 1.0 + 1e-6) tints_.push_back(std::move(tint));
  }
}

std::optional<std::size_t> EscapeTints::choose(std::span<const double> through, double transmitted,
                                               double u) const {
  const auto bands = weights_.size();
  const auto fraction_of = [&](auto tint) {
    auto least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < bands; ++b)
      if (tint(b) > 0.0) least = std::min(least, through[b] / (transmitted * tint(b)));
    return least;
  };
  std::optional<std::size_t> best;
  auto most = fraction_of([](std::size_t) { return 1.0; });
  for (auto t = bands; t < tints_.size(); ++t) {
    const auto fraction = fraction_of([&](std::size_t b) { return tints_[t][b]; });
    if (!(fraction > most)) continue;
    most = fraction;
    best = t;
  }
  auto left = u - most;
  if (left < 0.0) return best;
  for (std::size_t b = 0; b < bands; ++b) {
    left -= weights_[b] * (through[b] / transmitted - most * (best ? tints_[*best][b] : 1.0));
    if (left < 0.0) return b;
  }
  return best;  // by rounding
}

}  // namespace luxel
