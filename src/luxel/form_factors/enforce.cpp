// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/enforce.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/error.h"
#include "luxel/form_factors/balance.h"
#include "luxel/form_factors/exchange_areas.h"

namespace luxel {
namespace {

// Largest residual of a row that rounding explains, m² per m²; above it no choice of the listed exchange
// areas fills all rows.
constexpr double balanced_enough = 1e-10;

constexpr std::size_t rows_per_chunk = 256;

double worst_row_sum(const ExchangeAreas& areas, const std::vector<double>& area, const Context& context) {
  std::vector<double> off(areas.size());
  context.for_chunks(areas.size(), rows_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) {
      double sum = 0.0;
      for (auto at = areas.row_begin[i]; at < areas.row_begin[i + 1]; ++at) sum += areas.value[at];
      for (const auto& sink : areas.sink) sum += sink.value[i];
      off[i] = std::fabs(sum / area[i] - 1.0);
    }
  });
  return off.empty() ? 0.0 : *std::max_element(off.begin(), off.end());
}

// Allows every row to exchange with the environment, including rows from which no ray escaped.
void open_environment(ExchangeAreas& areas, const std::vector<double>& area) {
  auto& environment = areas.sink[ViewFactors::environment];
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (environment.variance[i] == 0.0) environment.variance[i] = 1e-6 * area[i] * area[i];
}

// The old factor from i to j, 0 where it is not listed; queried with ascending j.
class OldRow {
 public:
  OldRow(const ViewFactors& factors, std::size_t i)
      : factors_(factors), at_(factors.row_begin[i]), end_(factors.row_begin[i + 1]) {}
  double factor(std::uint32_t j) {
    while (at_ < end_ && factors_.column[at_] < j) ++at_;
    return at_ < end_ && factors_.column[at_] == j ? factors_.factor[at_] : 0.0;
  }

 private:
  const ViewFactors& factors_;
  std::uint64_t at_, end_;
};

// Changes of some rows, joined in the order of rows.
struct Changes {
  double squares = 0.0, largest = 0.0, standard_errors2 = 0.0;
};

// Converts exchange areas to factors in place, including those held at 0.
Changes make_factors(ExchangeAreas& areas, const ViewFactors& old, std::span<const double> multiplier,
                     const Context& context) {
  std::vector<Changes> parts((areas.size() + rows_per_chunk - 1) / rows_per_chunk);
  context.for_chunks(areas.size(), rows_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    auto& part = parts[begin / rows_per_chunk];
    for (auto i = begin; i < end; ++i) {
      OldRow old_row(old, i);
      for (auto at = areas.row_begin[i]; at < areas.row_begin[i + 1]; ++at) {
        const auto x = balanced(areas, multiplier, i, at);
        const auto factor = x / old.area[i];
        const auto change = std::fabs(factor - old_row.factor(areas.column[at]));
        const auto shift = x - areas.value[at];
        part.squares += change * change;
        part.largest = std::max(part.largest, change);
        part.standard_errors2 += shift * shift / std::fabs(static_cast<double>(areas.variance[at]));
        areas.value[at] = factor;
      }
      for (auto& sink : areas.sink) sink.value[i] = balanced_sink(sink, multiplier, i) / old.area[i];
    }
  });
  Changes all;
  for (const auto& part : parts) {
    all.squares += part.squares;
    all.largest = std::max(all.largest, part.largest);
    all.standard_errors2 += part.standard_errors2;
  }
  return all;
}

// Removes the factors that are 0.
void close_ranks(ExchangeAreas& areas) {
  std::uint64_t to = 0, at = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    for (const auto end = areas.row_begin[i + 1]; at < end; ++at) {
      if (!(areas.value[at] > 0.0)) continue;
      areas.column[to] = areas.column[at];
      areas.value[to] = areas.value[at];
      areas.standard_error[to++] = areas.standard_error[at];
    }
    areas.row_begin[i + 1] = to;
  }
  areas.column.resize(to);
  areas.value.resize(to);
  areas.standard_error.resize(to);
}

}  // namespace

Enforcement enforce_laws(ViewFactors& factors, const Context& context) {
  for (std::size_t i = 0; i < factors.size(); ++i)
    if (!factors.is_known[i])
      throw InputError("laws can be enforced only where the rows of all elements are known");
  Enforcement done;
  done.count = factors.count();
  auto joined = join_directions(factors, context);
  if (!joined) {
    done.is_stopped = true;
    return done;
  }
  auto& areas = *joined;
  done.worst_row_sum_before = worst_row_sum(areas, factors.area, context);
  smooth_variances(areas, factors, context);
  auto balance = balance_rows(areas, factors.area, context);
  if (balance.worst > balanced_enough && !balance.is_stopped) {
    open_environment(areas, factors.area);
    balance = balance_rows(areas, factors.area, context);
  }
  done.worst_row_sum = balance.worst;
  done.steps = balance.steps;
  done.passes = balance.passes;
  done.is_stopped = balance.is_stopped;

  const auto changes = make_factors(areas, factors, balance.multiplier, context);
  if (const auto count = static_cast<double>(areas.column.size()); count > 0.0) {
    done.rms_change = std::sqrt(changes.squares / count);
    done.max_change = changes.largest;
    done.change_in_standard_errors = std::sqrt(changes.standard_errors2 / count);
  }
  std::vector<float>().swap(areas.variance);
  close_ranks(areas);
  done.count = areas.column.size();
  factors.row_begin = std::move(areas.row_begin);
  factors.column = std::move(areas.column);
  factors.factor = std::move(areas.value);
  factors.standard_error = std::move(areas.standard_error);
  for (std::size_t k = 0; k < ViewFactors::sinks; ++k)
    factors.sink[k].factor = std::move(areas.sink[k].value);
  return done;
}

}  // namespace luxel
