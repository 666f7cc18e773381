// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewfactors/exchange_areas.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

constexpr std::size_t rows_a_chunk = 256;

// Who sees element j, rows rising, and where that factor stands.
struct Transposed {
  std::vector<std::uint64_t> begin;  // [element + 1]
  std::vector<std::uint32_t> row;
  std::vector<std::uint64_t> at;
};

Transposed transposed(const ViewFactors& f) {
  Transposed t;
  t.begin.assign(f.size() + 1, 0);
  for (const auto j : f.column) ++t.begin[j + 1];
  for (std::size_t j = 0; j < f.size(); ++j) t.begin[j + 1] += t.begin[j];
  t.row.resize(f.count());
  t.at.resize(f.count());
  auto next = t.begin;
  for (std::uint32_t i = 0; i < f.size(); ++i)
    for (auto at = f.row_begin[i]; at < f.row_begin[i + 1]; ++at) {
      const auto to = next[f.column[at]]++;
      t.row[to] = i;
      t.at[to] = at;
    }
  return t;
}

// Calls body(j, place of F_ij, place of F_ji) for every j of row i with either; count() where there is none.
template <typename Body>
void for_row(const ViewFactors& f, const Transposed& t, std::size_t i, Body body) {
  auto a = f.row_begin[i];
  auto b = t.begin[i];
  while (a < f.row_begin[i + 1] || b < t.begin[i + 1]) {
    const auto from = a < f.row_begin[i + 1] ? f.column[a] : 0xffffffffu;
    const auto to = b < t.begin[i + 1] ? t.row[b] : 0xffffffffu;
    const auto j = std::min(from, to);
    body(j, from == j ? a++ : f.count(), to == j ? t.at[b++] : f.count());
  }
}

struct Estimate {
  double value = 0.0, variance = 0.0;
};

Estimate exchange(const ViewFactors& f, std::size_t i, std::uint64_t at) {
  if (at >= f.count()) return {};
  const auto error = f.area[i] * static_cast<double>(f.standard_error[at]);
  return {f.area[i] * f.factor[at], error * error};
}

// Alike whichever is first: sums and products of two know no order.
Estimate joined(const Estimate& a, double weight_a, const Estimate& b, double weight_b) {
  const auto sum = weight_a + weight_b;
  return {(weight_a * a.value + weight_b * b.value) / sum,
          (weight_a * weight_a * a.variance + weight_b * weight_b * b.variance) / (sum * sum)};
}

// The variance of an exchange area that lines of this density would count: binomial, with half a count more,
// so that neither none nor all is certain. full: the most it can be.
double counted_variance(double value, double density, double full) {
  const auto half = 0.5 / density;
  return (value + half) / density * std::max(1.0 - value / full, 0.5 / (density * full + 1.0));
}

}  // namespace

ExchangeAreas join_directions(const ViewFactors& factors, const Workers& workers) {
  const auto n = factors.size();
  const auto t = transposed(factors);
  ExchangeAreas areas;
  areas.weight.resize(n);
  for (std::size_t i = 0; i < n; ++i) areas.weight[i] = factors.rays[i] / factors.area[i];
  for (std::size_t k = 0; k < ViewFactors::sinks; ++k) {
    areas.sink[k].value.resize(n);
    areas.sink[k].variance.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto error = factors.area[i] * static_cast<double>(factors.sink[k].standard_error[i]);
      areas.sink[k].value[i] = factors.area[i] * factors.sink[k].factor[i];
      areas.sink[k].variance[i] = error * error;
    }
  }
  areas.row_begin.assign(n + 1, 0);
  workers.for_chunks(n, rows_a_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i)
      for_row(factors, t, i, [&](std::uint32_t, std::uint64_t, std::uint64_t) { ++areas.row_begin[i + 1]; });
  });
  for (std::size_t i = 0; i < n; ++i) areas.row_begin[i + 1] += areas.row_begin[i];
  areas.column.resize(areas.row_begin[n]);
  areas.value.resize(areas.row_begin[n]);
  areas.variance.resize(areas.row_begin[n]);
  workers.for_chunks(n, rows_a_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) {
      auto to = areas.row_begin[i];
      for_row(factors, t, i, [&](std::uint32_t j, std::uint64_t own, std::uint64_t other) {
        const auto a = exchange(factors, i, own);
        const auto b = exchange(factors, j, other);
        const bool is_counted = areas.weight[i] > 0.0 && areas.weight[j] > 0.0;
        const auto both =
            j == i ? a : joined(a, is_counted ? areas.weight[i] : 1.0, b, is_counted ? areas.weight[j] : 1.0);
        areas.column[to] = j;
        areas.value[to] = both.value;
        areas.variance[to++] = static_cast<float>(both.variance);
      });
    }
  });
  return areas;
}

void smooth_variances(ExchangeAreas& areas, const ViewFactors& factors, const Workers& workers) {
  const auto n = areas.size();
  const auto is_counted = [&](std::size_t i) { return areas.weight[i] > 0.0; };
  const auto of_counts = [&](std::size_t i, std::uint64_t at) {
    const auto j = areas.column[at];
    if (!is_counted(i) || !is_counted(j)) return 0.0;
    const auto density = j == i ? areas.weight[i] : areas.weight[i] + areas.weight[j];
    return counted_variance(areas.value[at], density, std::min(factors.area[i], factors.area[j]));
  };
  const auto row_sum = [&](auto term) {
    return ordered_sum(workers, n, [&](std::size_t i) {
      double sum = 0.0;
      for (auto at = areas.row_begin[i]; at < areas.row_begin[i + 1]; ++at) sum += term(i, at);
      return sum;
    });
  };
  const auto measured =
      row_sum([&](std::size_t, std::uint64_t at) { return static_cast<double>(areas.variance[at]); });
  const auto counted = row_sum(of_counts);
  const auto scale = counted > 0.0 ? measured / counted : 0.0;
  // Where factors are integrated, not counted, no error is smaller than rounding.
  const auto mixed = [&](double own, double of_count, double area) {
    const auto least = 1e-12 * area;
    return of_count > 0.0 ? 0.5 * (own + scale * of_count) + least * least : own + least * least;
  };
  workers.for_chunks(n, rows_a_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) {
      for (auto at = areas.row_begin[i]; at < areas.row_begin[i + 1]; ++at)
        areas.variance[at] =
            static_cast<float>(mixed(static_cast<double>(areas.variance[at]), of_counts(i, at),
                                     std::min(factors.area[i], factors.area[areas.column[at]])));
      for (auto& sink : areas.sink)
        sink.variance[i] =
            sink.value[i] > 0.0
                ? mixed(
                      sink.variance[i],
                      is_counted(i) ? counted_variance(sink.value[i], areas.weight[i], factors.area[i]) : 0.0,
                      factors.area[i])
                : 0.0;
    }
  });
}

}  // namespace luxel
