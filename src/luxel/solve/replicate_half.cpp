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
    const double a = places[s].area;
    const double u = places[s].u;
    const double v = places[s].v;
    const std::array<double, 6> terms = {a, a * u, a * v, a * u * u, a * u * v, a * v * v};
    for (std::size_t i = 0; i < 6; ++i) m.gram[i] += terms[i];
    for (std::size_t r = 0; r < replicates; ++r) {
      const auto* value = values[r].data() + s * bands;
      auto* right = m.right.data() + r * bands;
      for (std::size_t b = 0; b < bands; ++b) {
        const double y = value[b];
        right[b] += y * terms[0];
        right[n + b] += y * terms[1];
        right[2 * n + b] += y * terms[2];
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
                                 const LinearFit& fit, std::vector<float>& means) const {
  const auto at = means.size();
  means.resize(at + (end - first) * columns_.bands);
  for (std::size_t b = 0; b < columns_.bands; ++b) {
    std::array<double, 3> mean{};
    for (std::size_t r = 0; r < columns_.replicates; ++r) {
      const auto c = fit.coefficients(m, r * columns_.bands + b);
      for (std::size_t i = 0; i < 3; ++i) mean[i] += c[i] / static_cast<double>(columns_.replicates);
    }
    for (auto s = first; s < end; ++s)
      means[at + (s - first) * columns_.bands + b] =
          static_cast<float>(mean[0] + mean[1] * static_cast<double>(places_[s].u) +
                             mean[2] * static_cast<double>(places_[s].v));
  }
}

void ReplicateHalf::replace(std::uint32_t first, std::uint32_t end, const Moments& m,
                            const LinearFit& fit) const {
  for (std::size_t r = 0; r < columns_.replicates; ++r)
    for (std::size_t b = 0; b < columns_.bands; ++b) {
      const auto c = fit.coefficients(m, r * columns_.bands + b);
      auto* value = values_[r].data() + b;
      for (auto s = first; s < end; ++s)
        value[s * columns_.bands] = static_cast<float>(c[0] + c[1] * static_cast<double>(places_[s].u) +
                                                       c[2] * static_cast<double>(places_[s].v));
    }
}

}  // namespace luxel
