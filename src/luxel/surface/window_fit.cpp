// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/window_fit.h"

#include <algorithm>
#include <vector>

#include "luxel/core/wide.h"

namespace luxel {
namespace {

constexpr std::size_t terms_max = WindowFit::max_terms;
constexpr std::size_t usual_columns = 32;  // 8 replicates of 3 bands

// Smallest accepted pivot, relative to the diagonal: below it a term is a combination of the previous ones.
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

// The kernels. known: the number of columns where it is known at compile time, otherwise 0.

template <std::size_t known>
LUXEL_INLINE void add_members(std::span<const WindowMember> members, std::size_t terms,
                              const float* __restrict values, std::size_t columns, float* __restrict right) {
  const auto n = known ? known : columns;
  for (const auto& m : members) {
    const auto power = WindowFit::powers(m);
    const auto* __restrict value = values + m.index * n;
    for (std::size_t i = 0; i < terms; ++i) {
      const auto factor = m.area * power[i];
      for (std::size_t c = 0; c < n; ++c) right[i * n + c] += factor * value[c];
    }
  }
}

template <std::size_t known>
LUXEL_INLINE void subtract_from_fit(const WindowFit::Powers& powers, std::size_t terms,
                                    const float* __restrict coefficients, const float* __restrict value,
                                    std::size_t columns, float* __restrict difference) {
  const auto n = known ? known : columns;
  for (std::size_t c = 0; c < n; ++c) difference[c] = coefficients[c] - value[c];
  for (std::size_t i = 1; i < terms; ++i)
    for (std::size_t c = 0; c < n; ++c) difference[c] += powers[i] * coefficients[i * n + c];
}

// Four bands at once.
using Group = std::array<float, 4>;

struct HalfSums {
  Group bias{}, variance{}, covariance{};

  // Adds the values of `replicates` replicates of one member in four bands.
  LUXEL_INLINE void add(const float* __restrict value, const float* __restrict difference, std::size_t stride,
                        std::size_t replicates, float weight) {
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
    const auto inverse = 1.0f / count;
    weight /= count * (count - 1.0f);
    for (std::size_t b = 0; b < 4; ++b) {
      bias[b] += weight * (sum_d[b] * sum_d[b] - sum_dd[b]);
      variance[b] += weight * (sum_dd[b] - inverse * sum_d[b] * sum_d[b]);
      covariance[b] += weight * (sum_vd[b] - inverse * sum_v[b] * sum_d[b]);
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

template <std::size_t known>
LUXEL_INLINE void add_risks(std::span<const WindowMember> members, std::size_t terms,
                            const float* __restrict values, WindowColumns columns,
                            const float* __restrict coefficients, const float* __restrict risk_weight,
                            float* __restrict difference, std::array<HalfSums, 2>& sums) {
  const auto n = known ? known : columns.size();
  const auto stride = known ? 4 : columns.stride();
  const auto replicates = known ? known / 4 : columns.replicates;
  const auto half = replicates / 2;
  for (const auto& m : members) {
    const auto* __restrict value = values + m.index * n;
    subtract_from_fit<known>(WindowFit::powers(m), terms, coefficients, value, n, difference);
    const auto weight = m.area * risk_weight[m.index];
    for (std::size_t group = 0; group < stride; group += 4) {
      sums[0].add(value + group, difference + group, stride, half, weight);
      sums[1].add(value + half * stride + group, difference + half * stride + group, stride,
                  replicates - half, weight);
    }
  }
}

LUXEL_WIDE void add_usual_members(std::span<const WindowMember> members, std::size_t terms,
                                  const float* values, float* right) {
  add_members<usual_columns>(members, terms, values, usual_columns, right);
}
LUXEL_WIDE void subtract_from_usual_fit(const WindowFit::Powers& powers, std::size_t terms,
                                        const float* coefficients, const float* value, float* difference) {
  subtract_from_fit<usual_columns>(powers, terms, coefficients, value, usual_columns, difference);
}
LUXEL_WIDE void add_usual_risks(std::span<const WindowMember> members, std::size_t terms, const float* values,
                                const float* coefficients, const float* risk_weight,
                                std::array<HalfSums, 2>& sums) {
  std::array<float, usual_columns> difference;
  add_risks<usual_columns>(members, terms, values, {}, coefficients, risk_weight, difference.data(), sums);
}

bool is_usual(const WindowColumns& columns) {
  return columns.size() == usual_columns && columns.stride() == 4;
}

}  // namespace

void WindowFit::fit(std::span<const WindowMember> members, std::size_t terms, const float* values,
                    WindowColumns columns, float* coefficients) {
  const auto n = columns.size();
  Gram gram{};
  for (const auto& m : members) {
    const auto power = powers(m);
    for (std::size_t i = 0; i < terms; ++i)
      for (std::size_t j = 0; j <= i; ++j) gram[i][j] += static_cast<double>(m.area * power[i] * power[j]);
  }
  std::fill_n(coefficients, terms * n, 0.0f);
  if (is_usual(columns)) {
    add_usual_members(members, terms, values, coefficients);
  } else {
    add_members<0>(members, terms, values, n, coefficients);
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

void WindowFit::subtract(const Powers& powers, std::size_t terms, const float* coefficients,
                         const float* value, WindowColumns columns, float* difference) {
  if (is_usual(columns)) return subtract_from_usual_fit(powers, terms, coefficients, value, difference);
  subtract_from_fit<0>(powers, terms, coefficients, value, columns.size(), difference);
}

std::array<WindowRisk, 2> window_risk(std::span<const WindowMember> members, std::size_t terms,
                                      const float* values, WindowColumns columns, const float* coefficients,
                                      const float* risk_weight) {
  std::array<HalfSums, 2> sums;
  if (is_usual(columns)) {
    add_usual_risks(members, terms, values, coefficients, risk_weight, sums);
  } else {
    std::vector<float> difference(columns.size());
    add_risks<0>(members, terms, values, columns, coefficients, risk_weight, difference.data(), sums);
  }
  return {sums[0].risk(), sums[1].risk()};
}

}  // namespace luxel
