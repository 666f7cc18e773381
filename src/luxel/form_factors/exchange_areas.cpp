// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/exchange_areas.h"

#include <algorithm>
#include <cmath>

#include "luxel/form_factors/reverse_rows.h"

namespace luxel {
namespace {

constexpr std::size_t rows_per_chunk = 256;

struct Estimate {
  double value = 0.0, variance = 0.0;
};

Estimate exchange(double area, double factor, float standard_error) {
  const auto error = area * static_cast<double>(standard_error);
  return {area * factor, error * error};
}

// Independent of the order of a and b: a sum or product of two terms commutes exactly.
Estimate joined(const Estimate& a, double weight_a, const Estimate& b, double weight_b) {
  const auto sum = weight_a + weight_b;
  return {(weight_a * a.value + weight_b * b.value) / sum,
          (weight_a * weight_a * a.variance + weight_b * weight_b * b.variance) / (sum * sum)};
}

// The binomial variance of an exchange area estimated from this density of lines, with half a count added, so
// that a count of 0 or of all lines is not certain. full: the largest possible value.
double counted_variance(double value, double density, double full) {
  const auto half = 0.5 / density;
  return (value + half) / density * std::max(1.0 - value / full, 0.5 / (density * full + 1.0));
}

// Calls body(reverse rows of the run, its first row, its end) for all runs; returns false where the monitor
// stops the work.
template <typename Body>
bool for_runs(const ViewFactors& f, const Context& context, double done_before, Body body) {
  const auto grain = ReverseRows::rows_per_run(f);
  const auto turn = grain * static_cast<std::size_t>(context.threads());
  std::vector<ReverseRows> reverse(static_cast<std::size_t>(context.threads()));
  for (std::size_t from = 0; from < f.size(); from += turn) {
    const auto done = done_before + 0.5 * static_cast<double>(from) / static_cast<double>(f.size());
    if (context.report({"join", done}) == Next::stop) return false;
    context.for_chunks(std::min(turn, f.size() - from), grain,
                       [&](std::size_t begin, std::size_t end, int thread) {
                         auto& own = reverse[static_cast<std::size_t>(thread)];
                         own.fill(f, from + begin, from + end);
                         for (auto i = from + begin; i < from + end; ++i) body(own, i);
                       });
  }
  return true;
}

}  // namespace

std::optional<ExchangeAreas> join_directions(const ViewFactors& factors, const Context& context) {
  const auto n = factors.size();
  ExchangeAreas areas;
  areas.weight.resize(n);
  for (std::size_t i = 0; i < n; ++i) areas.weight[i] = factors.rays[i] / factors.area[i];
  for (std::size_t k = 0; k < ViewFactors::sinks; ++k) {
    areas.sink[k].value.resize(n);
    areas.sink[k].variance.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto sink =
          exchange(factors.area[i], factors.sink[k].factor[i], factors.sink[k].standard_error[i]);
      areas.sink[k].value[i] = sink.value;
      areas.sink[k].variance[i] = sink.variance;
    }
  }
  areas.row_begin.assign(n + 1, 0);
  if (!for_runs(factors, context, 0.0, [&](const ReverseRows& reverse, std::size_t i) {
        reverse.for_row(factors, i, [&](std::uint32_t, std::uint64_t, const ReverseRows::Entry*) {
          ++areas.row_begin[i + 1];
        });
      }))
    return {};
  for (std::size_t i = 0; i < n; ++i) areas.row_begin[i + 1] += areas.row_begin[i];
  areas.column.resize(areas.row_begin[n]);
  areas.value.resize(areas.row_begin[n]);
  areas.standard_error.resize(areas.row_begin[n]);
  areas.variance.resize(areas.row_begin[n]);
  if (!for_runs(factors, context, 0.5, [&](const ReverseRows& reverse, std::size_t i) {
        auto to = areas.row_begin[i];
        reverse.for_row(factors, i, [&](std::uint32_t j, std::uint64_t own, const ReverseRows::Entry* other) {
          Estimate a, b;
          if (own < factors.count())
            a = exchange(factors.area[i], factors.factor[own], factors.standard_error[own]);
          if (other) b = exchange(factors.area[j], other->factor, other->standard_error);
          const bool is_counted = areas.weight[i] > 0.0 && areas.weight[j] > 0.0;
          const auto both =
              j == i ? a
                     : joined(a, is_counted ? areas.weight[i] : 1.0, b, is_counted ? areas.weight[j] : 1.0);
          areas.column[to] = j;
          areas.value[to] = both.value;
          areas.standard_error[to] = static_cast<float>(std::sqrt(both.variance) / factors.area[i]);
          areas.variance[to++] = static_cast<float>(both.variance);
        });
      }))
    return {};
  return areas;
}

void smooth_variances(ExchangeAreas& areas, const ViewFactors& factors, const Context& context) {
  const auto n = areas.size();
  const auto is_counted = [&](std::size_t i) { return areas.weight[i] > 0.0; };
  const auto of_counts = [&](std::size_t i, std::uint64_t at) {
    const auto j = areas.column[at];
    if (!is_counted(i) || !is_counted(j)) return 0.0;
    const auto density = j == i ? areas.weight[i] : areas.weight[i] + areas.weight[j];
    return counted_variance(areas.value[at], density, std::min(factors.area[i], factors.area[j]));
  };
  const auto row_sum = [&](auto term) {
    return ordered_sum(context, n, [&](std::size_t i) {
      double sum = 0.0;
      for (auto at = areas.row_begin[i]; at < areas.row_begin[i + 1]; ++at) sum += term(i, at);
      return sum;
    });
  };
  const auto measured =
      row_sum([&](std::size_t, std::uint64_t at) { return static_cast<double>(areas.variance[at]); });
  const auto counted = row_sum(of_counts);
  const auto scale = counted > 0.0 ? measured / counted : 0.0;
  // Integrated factors have no counting error: their variance is bounded below by rounding alone.
  const auto mixed = [&](double own, double of_count, double area) {
    const auto least = 1e-12 * area;
    return of_count > 0.0 ? 0.5 * (own + scale * of_count) + least * least : own + least * least;
  };
  context.for_chunks(n, rows_per_chunk, [&](std::size_t begin, std::size_t end, int) {
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
