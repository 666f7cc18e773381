// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/window_fit.h"

#include <algorithm>

namespace luxel {
namespace {

constexpr std::size_t terms_max = WindowFit::max_terms;
constexpr std::size_t usual_columns = 32;  // 8 replicates of 3 bands

// Smallest pivot that counts, relative to the diagonal: below it a term is a combination of those before it.
constexpr std::array<double, terms_max> min_pivot = {0.0, 1e-3, 1e-3, 1e-2, 1e-2, 1e-2};

using Gram = std::array<std::array<double, terms_max>, terms_max>;

// The Gram matrix as L D L'.
struct Factors {
  Gram lower{};
  std::array<double, terms_max> inverse{};  // of D; 0 for a term that is left out

  Factors(const Gram& gram, std::size_t terms) {
    Gram scaled{};  // L D
    for (std::size_t i = 0; i < terms; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        scaled[i][j] = gram[i][j];
        for (std::size_t k = 0; k < j; ++k) scaled[i][j] -= scaled[i][k] * lower[j][k];
        lower[i][j] = scaled[i][j] * inverse[j];
      }
      auto pivot = gram[i][i];
      for (std::size_t k = 0; k < i; ++k) pivot -= scaled[i][k] * lower[i][k];
      inverse[i] = pivot > min_pivot[i] * gram[i][i] ? 1.0 / pivot : 0.0;
    }
  }
};

// known: the number of columns where it is known beforehand, else 0.
template <std::size_t known>
void fit_columns(const std::vector<WindowMember>& members, std::size_t terms, const float* values,
                 std::size_t columns, float* coefficients) {
  const auto n = known ? known : columns;
  Gram gram{};
  std::fill_n(coefficients, terms * n, 0.0f);
  for (const auto& m : members) {
    const auto power = WindowFit::powers(m);
    const auto* value = values + m.index * n;
    for (std::size_t i = 0; i < terms; ++i) {
      const auto factor = m.area * power[i];
      for (std::size_t j = 0; j <= i; ++j) gram[i][j] += static_cast<double>(factor * power[j]);
      auto* right = coefficients + i * n;
      for (std::size_t c = 0; c < n; ++c) right[c] += factor * value[c];
    }
  }
  const Factors factors(gram, terms);
  const auto subtract = [&](std::size_t from, std::size_t what, double times) {
    const auto factor = static_cast<float>(times);
    for (std::size_t c = 0; c < n; ++c) coefficients[from * n + c] -= factor * coefficients[what * n + c];
  };
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t j = 0; j < i; ++j) subtract(i, j, factors.lower[i][j]);
  for (auto i = terms; i-- > 0;) {
    const auto inverse = static_cast<float>(factors.inverse[i]);
    for (std::size_t c = 0; c < n; ++c) coefficients[i * n + c] *= inverse;
    if (factors.inverse[i] == 0.0) continue;
    for (auto j = i + 1; j < terms; ++j) subtract(i, j, factors.lower[j][i]);
  }
}

template <std::size_t known>
void subtract_from_fit(const WindowFit::Powers& powers, std::size_t terms, const float* coefficients,
                       const float* value, std::size_t columns, float* difference) {
  const auto n = known ? known : columns;
  for (std::size_t c = 0; c < n; ++c) difference[c] = coefficients[c] - value[c];
  for (std::size_t i = 1; i < terms; ++i)
    for (std::size_t c = 0; c < n; ++c) difference[c] += powers[i] * coefficients[i * n + c];
}

// Four bands at a time.
using Group = std::array<float, 4>;

struct HalfSums {
  Group bias{}, variance{}, covariance{};

  // Adds what `replicates` replicates say of one member in four bands.
  void add(const float* value, const float* difference, std::size_t stride, std::size_t replicates,
           float weight) {
    Group sum_d{}, sum_dd{}, sum_v{}, sum_vd{};
    for (std::size_t r = 0; r < replicates; ++r) {
      const auto* d = difference + r * stride;
      const auto* v = value + r * stride;
      for (std::size_t b = 0; b < 4; ++b) {
        sum_d[b] += d[b];
        sum_dd[b] += d[b] * d[b];
        sum_v[b] += v[b];
        sum_vd[b] += v[b] * d[b];
      }
    }
    const auto count = static_cast<float>(replicates);
    const auto share = 1.0f / count;
    weight /= count * (count - 1.0f);
    for (std::size_t b = 0; b < 4; ++b) {
      bias[b] += weight * (sum_d[b] * sum_d[b] - sum_dd[b]);
      variance[b] += weight * (sum_dd[b] - share * sum_d[b] * sum_d[b]);
      covariance[b] += weight * (sum_vd[b] - share * sum_v[b] * sum_d[b]);
    }
  }
  WindowRisk risk() const {
    const auto sum = [](const Group& g) {
      return static_cast<double>(g[0]) + static_cast<double>(g[1]) + static_cast<double>(g[2]) +
             static_cast<double>(g[3]);
    };
    return {sum(bias), sum(variance), sum(covariance)};
  }
};

}  // namespace

std::array<WindowRisk, 2> window_risk(const std::vector<WindowMember>& members, std::size_t terms,
                                      const float* values, WindowColumns columns, const float* coefficients,
                                      const float* risk_weight) {
  const auto n = columns.size();
  const auto stride = columns.stride();
  const auto half = columns.replicates / 2;
  std::array<HalfSums, 2> sums;
  std::vector<float> difference(n);
  for (const auto& m : members) {
    const auto* value = values + m.index * n;
    fit_minus_value(WindowFit::powers(m), terms, coefficients, value, n, difference.data());
    const auto weight = m.area * risk_weight[m.index];
    for (std::size_t group = 0; group < stride; group += 4) {
      sums[0].add(value + group, difference.data() + group, stride, half, weight);
      sums[1].add(value + half * stride + group, difference.data() + half * stride + group, stride,
                  columns.replicates - half, weight);
    }
  }
  return {sums[0].risk(), sums[1].risk()};
}

void fit_minus_value(const WindowFit::Powers& powers, std::size_t terms, const float* coefficients,
                     const float* value, std::size_t columns, float* difference) {
  if (columns == usual_columns)
    return subtract_from_fit<usual_columns>(powers, terms, coefficients, value, columns, difference);
  subtract_from_fit<0>(powers, terms, coefficients, value, columns, difference);
}

void WindowFit::fit(const std::vector<WindowMember>& members, std::size_t terms, const float* values,
                    std::size_t columns, float* coefficients) {
  if (columns == usual_columns)
    return fit_columns<usual_columns>(members, terms, values, columns, coefficients);
  fit_columns<0>(members, terms, values, columns, coefficients);
}

}  // namespace luxel
