// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewfactors/enforce.h"

#include <algorithm>
#include <cmath>

#include "luxel/report/error.h"
#include "luxel/viewfactors/balance.h"
#include "luxel/viewfactors/exchange_areas.h"

namespace luxel {
namespace {

// Beyond what rounding leaves, m² a m²: then no choice of the listed exchange areas fills all rows.
constexpr double balanced_enough = 1e-10;

double worst_row_sum(const ExchangeAreas& areas, const std::vector<double>& area) {
  double worst = 0.0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    double sum = 0.0;
    for (auto at = areas.row_begin[i]; at < areas.row_begin[i + 1]; ++at) sum += areas.value[at];
    for (const auto& sink : areas.sink) sum += sink.value[i];
    worst = std::max(worst, std::fabs(sum / area[i] - 1.0));
  }
  return worst;
}

// Lets every row give to the environment, even those from which nothing was seen to escape.
void open_environment(ExchangeAreas& areas, const std::vector<double>& area) {
  auto& environment = areas.sink[ViewFactors::environment];
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (environment.variance[i] == 0.0) environment.variance[i] = 1e-6 * area[i] * area[i];
}

// The old factor from i to j, 0 where it is not listed; asked for with j rising.
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

// Changes over rows, in their order.
struct Changes {
  double squares = 0.0, largest = 0.0, standard_errors2 = 0.0;
  std::uint64_t count = 0;
};

}  // namespace

Enforcement enforce_laws(ViewFactors& factors, const Workers& workers) {
  for (std::size_t i = 0; i < factors.size(); ++i)
    if (!factors.is_known[i])
      throw InputError("laws can be enforced only where the rows of all elements are known");
  Enforcement done;
  auto areas = join_directions(factors, workers);
  done.worst_row_sum_before = worst_row_sum(areas, factors.area);
  const auto measured = areas.variance;
  smooth_variances(areas, factors, workers);
  auto balance = balance_rows(areas, factors.area, workers);
  if (balance.worst > balanced_enough) {
    open_environment(areas, factors.area);
    balance = balance_rows(areas, factors.area, workers);
  }
  done.worst_row_sum = balance.worst;
  done.steps = balance.steps;

  const std::span<const double> m = balance.multiplier;
  auto result = ViewFactors::between(std::move(factors.name), factors.area);
  result.rays = factors.rays;
  result.is_known = factors.is_known;
  Changes all;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    OldRow old(factors, i);
    for (auto at = areas.row_begin[i]; at < areas.row_begin[i + 1]; ++at) {
      const auto x = balanced(areas, m, i, at);
      const auto factor = x / factors.area[i];
      const auto change = std::fabs(factor - old.factor(areas.column[at]));
      all.squares += change * change;
      all.largest = std::max(all.largest, change);
      const auto shift = x - areas.value[at];
      all.standard_errors2 += shift * shift / static_cast<double>(areas.variance[at]);
      ++all.count;
      if (!(x > 0.0)) continue;
      result.column.push_back(areas.column[at]);
      result.factor.push_back(factor);
      result.standard_error.push_back(
          static_cast<float>(std::sqrt(static_cast<double>(measured[at])) / factors.area[i]));
    }
    result.row_begin[i + 1] = result.count();
    for (std::size_t k = 0; k < ViewFactors::sinks; ++k) {
      result.sink[k].factor[i] = balanced_sink(areas.sink[k], m, i) / factors.area[i];
      result.sink[k].standard_error[i] = factors.sink[k].standard_error[i];
    }
  }
  factors = std::move(result);
  if (all.count > 0) {
    const auto count = static_cast<double>(all.count);
    done.rms_change = std::sqrt(all.squares / count);
    done.largest_change = all.largest;
    done.change_in_standard_errors = std::sqrt(all.standard_errors2 / count);
  }
  return done;
}

}  // namespace luxel
