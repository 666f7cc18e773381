// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/replicate_half.h"

#include <array>

namespace luxel {
namespace {

// The numbers of replicates and bands where they are known beforehand, else 0.
template <std::size_t known_replicates, std::size_t known_bands>
void add_slots(std::span<const std::vector<float>> values, std::span<const FitPlace> places, Columns columns,
               std::uint32_t first, std::uint32_t end, Moments& m, Energy* raw) {
  const auto replicates = known_replicates ? known_replicates : columns.replicates;
  const auto bands = known_bands ? known_bands : columns.bands;
  const auto n = replicates * bands;
  m.places += end - first;
  for (auto s = first; s < end; ++s) {
    const auto power = powers<2 * most_degree>(places[s], places[s].area);
    for (std::size_t i = 0; i < power.size(); ++i) m.gram[i] += power[i];
    for (std::size_t r = 0; r < replicates; ++r) {
      const auto* value = values[r].data() + s * bands;
      auto* right = m.right.data() + r * bands;
      for (std::size_t b = 0; b < bands; ++b) {
        const double y = value[b];
        for (std::size_t i = 0; i < most_terms; ++i) right[i * n + b] += y * power[i];
      }
    }
  }
  if (!raw) return;
  for (std::size_t b = 0; b < bands; ++b) {
    double of_sum = 0.0;
    double of_squares = 0.0;
    for (auto s = first; s < end; ++s) {
      double sum = 0.0;
      double squares = 0.0;
      for (std::size_t r = 0; r < replicates; ++r) {
        const double y = values[r][s * bands + b];
        sum += y;
        squares += y * y;
      }
      of_sum += static_cast<double>(places[s].area) * sum * sum;
      of_squares += static_cast<double>(places[s].area) * squares;
    }
    raw->add_sums(b, of_sum, of_squares, static_cast<double>(replicates));
  }
}

double value_at(const FitPlace& place, const Terms& c) {
  const auto power = powers<most_degree>(place, 1.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < most_terms; ++i) sum += c[i] * power[i];
  return sum;
}

}  // namespace

void ReplicateHalf::add(std::uint32_t first, std::uint32_t end, Moments& m, Energy* raw) const {
  if (columns_.bands == 3 && columns_.replicates == 4)
    return add_slots<4, 3>(values_, places_, columns_, first, end, m, raw);
  add_slots<0, 0>(values_, places_, columns_, first, end, m, raw);
}

void ReplicateHalf::append_means(std::uint32_t first, std::uint32_t end, std::vector<float>& means) const {
  const auto share = 1.0f / static_cast<float>(columns_.replicates);
  for (auto i = first * columns_.bands; i < end * columns_.bands; ++i) {
    float sum = 0.0f;
    for (const auto& v : values_) sum += v[i];
    means.push_back(share * sum);
  }
}

void ReplicateHalf::append_means(std::uint32_t first, std::uint32_t end, const Moments& m,
                                 const PolynomialFit& fit, std::vector<float>& means) const {
  const auto at = means.size();
  means.resize(at + (end - first) * columns_.bands);
  for (std::size_t b = 0; b < columns_.bands; ++b) {
    Terms mean{};
    for (std::size_t r = 0; r < columns_.replicates; ++r) {
      const auto c = fit.coefficients(m, r * columns_.bands + b);
      for (std::size_t i = 0; i < most_terms; ++i) mean[i] += c[i] / static_cast<double>(columns_.replicates);
    }
    for (auto s = first; s < end; ++s)
      means[at + (s - first) * columns_.bands + b] = static_cast<float>(value_at(places_[s], mean));
  }
}

void ReplicateHalf::replace(std::uint32_t first, std::uint32_t end, const Moments& m,
                            const PolynomialFit& fit) const {
  for (std::size_t r = 0; r < columns_.replicates; ++r)
    for (std::size_t b = 0; b < columns_.bands; ++b) {
      const auto c = fit.coefficients(m, r * columns_.bands + b);
      auto* value = values_[r].data() + b;
      for (auto s = first; s < end; ++s)
        value[s * columns_.bands] = static_cast<float>(value_at(places_[s], c));
    }
}

}  // namespace luxel
