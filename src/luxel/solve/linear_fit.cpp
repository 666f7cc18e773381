// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/linear_fit.h"

#include <algorithm>

namespace luxel {
namespace {

constexpr double least_pivot = 1e-7;  // of the Gram matrix: below it the places lie on a line

}  // namespace

void Moments::clear() {
  gram.fill(0.0);
  std::fill(right.begin(), right.end(), 0.0);
  places = 0;
}

void Moments::add(const Moments& other) {
  for (std::size_t i = 0; i < gram.size(); ++i) gram[i] += other.gram[i];
  for (std::size_t i = 0; i < right.size(); ++i) right[i] += other.right[i];
  places += other.places;
}

void Energy::clear() {
  std::fill(signal.begin(), signal.end(), 0.0);
  noise = 0.0;
}

void Energy::add(const Energy& other) {
  for (std::size_t b = 0; b < signal.size(); ++b) signal[b] += other.signal[b];
  noise += other.noise;
}

LinearFit::LinearFit(const Moments& m) {
  const auto& g = m.gram;
  inverse_[0] = g[0] > 0.0 ? 1.0 / g[0] : 0.0;
  if (m.places < linear_places) return;
  const auto l1 = g[1] * inverse_[0];
  const auto l2 = g[2] * inverse_[0];
  const auto d1 = g[3] - l1 * g[1];
  const auto cross = g[4] - l1 * g[2];
  const auto d2_whole = g[5] - l2 * g[2];
  if (!(d1 > 0.0 && d2_whole > 0.0)) return;
  const auto inverse1 = 1.0 / d1;
  const auto d2 = d2_whole - cross * inverse1 * cross;
  if (!(d2 > least_pivot * d2_whole)) return;
  lower_ = {l1, l2, cross * inverse1};
  inverse_[1] = inverse1;
  inverse_[2] = 1.0 / d2;
}

void LinearFit::add_energy(const Moments& m, Columns columns, Energy& energy) const {
  const auto n = columns.size();
  const auto* right = m.right.data();
  const auto replicates = static_cast<double>(columns.replicates);
  for (std::size_t b = 0; b < columns.bands; ++b) {
    // The right side on orthogonal axes: their squares over the axes' own add up to the fit's energy.
    std::array<double, 3> sum{};
    std::array<double, 3> squares{};
    for (auto j = b; j < n; j += columns.bands) {
      const auto y0 = right[j];
      const auto y1 = right[n + j] - lower_[0] * y0;
      const auto y2 = right[2 * n + j] - lower_[1] * y0 - lower_[2] * y1;
      sum[0] += y0;
      sum[1] += y1;
      sum[2] += y2;
      squares[0] += y0 * y0;
      squares[1] += y1 * y1;
      squares[2] += y2 * y2;
    }
    double of_sum = 0.0;
    double of_squares = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      of_sum += sum[i] * sum[i] * inverse_[i];
      of_squares += squares[i] * inverse_[i];
    }
    energy.add_sums(b, of_sum, of_squares, replicates);
  }
}

std::array<double, 3> LinearFit::coefficients(const Moments& m, std::size_t column) const {
  const auto n = m.right.size() / 3;
  const auto y0 = m.right[column];
  const auto y1 = m.right[n + column] - lower_[0] * y0;
  const auto y2 = m.right[2 * n + column] - lower_[1] * y0 - lower_[2] * y1;
  const auto c2 = y2 * inverse_[2];
  const auto c1 = y1 * inverse_[1] - lower_[2] * c2;
  return {y0 * inverse_[0] - lower_[0] * c1 - lower_[1] * c2, c1, c2};
}

}  // namespace luxel
