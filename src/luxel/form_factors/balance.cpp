// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/balance.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/conjugate_gradients.h"

namespace luxel {
namespace {

constexpr std::size_t rows_per_chunk = 256;
constexpr int max_steps = 60;
constexpr int max_iterations = 400;  // of conjugate gradients per Newton step
constexpr int max_halvings = 20;
constexpr double enough = 2e-13;  // largest residual of a row, relative to its area
constexpr double inner_tolerance = 1e-3;

using Vector = std::vector<double>;

class Newton {
 public:
  Newton(ExchangeAreas& areas, std::span<const double> area, const Context& context)
      : areas_(areas), area_(area), context_(context), diagonal_(areas.size()) {}

  Balance solve() {
    const auto n = areas_.size();
    Vector m(n, 0.0), r = residual(m);
    Balance best{m, worst(r), 0};
    first_ = best.worst;
    for (int step = 1; step <= max_steps && best.worst > enough && !is_stopped_; ++step) {
      const auto direction = towards(r);
      // Full steps, except where the set of active constraints changes: then the step is halved.
      bool is_better = false;
      double fraction = 1.0;
      for (int h = 0; h < max_halvings && !is_better && !is_stopped_; ++h, fraction *= 0.5) {
        auto next = m;
        for (std::size_t i = 0; i < n; ++i) next[i] += fraction * direction[i];
        auto left = residual(next);
        is_better = dot(left, left) < dot(r, r);
        if (!is_better) continue;
        m = std::move(next);
        r = std::move(left);
      }
      if (!is_better) break;
      if (const auto w = worst(r); w < best.worst) best = {m, w, step};
    }
    best.passes = passes_;
    best.is_stopped = is_stopped_;
    return best;
  }

 private:
  template <typename Body>
  void for_rows(Body body) const {
    context_.for_chunks(areas_.size(), rows_per_chunk, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) body(i);
    });
  }
  double dot(const Vector& a, const Vector& b) const {
    return ordered_sum(context_, a.size(), [&](std::size_t i) { return a[i] * b[i]; });
  }
  double worst(const Vector& r) const {
    double most = 0.0;
    for (std::size_t i = 0; i < r.size(); ++i) most = std::max(most, std::fabs(r[i]) / area_[i]);
    return most;
  }

  // One more pass over the areas: some tenths of a second per hundred million.
  void count_pass(double worst_left) {
    ++passes_;
    // Fraction of the required digits that is reached.
    const auto done = worst_left < first_ ? std::log(worst_left / first_) / std::log(enough / first_) : 0.0;
    if (context_.report({"enforce", std::min(done, 1.0)}) == Next::stop) is_stopped_ = true;
  }

  // The residual of each row, m². Also marks the areas that are held at 0, and computes the diagonal of the
  // derivative.
  Vector residual(const Vector& m) {
    Vector r(m.size());
    for_rows([&](std::size_t i) {
      double sum = 0.0, diagonal = 0.0;
      for (auto at = areas_.row_begin[i]; at < areas_.row_begin[i + 1]; ++at) {
        const auto x = balanced(areas_, m, i, at);
        const auto variance = std::fabs(areas_.variance[at]);
        const auto noted = x > 0.0 ? variance : -variance;
        if (noted != areas_.variance[at]) areas_.variance[at] = noted;
        sum += x;
        diagonal += x > 0.0 ? static_cast<double>(variance) : 0.0;
      }
      for (const auto& sink : areas_.sink) {
        const auto x = balanced_sink(sink, m, i);
        sum += x;
        diagonal += x > 0.0 ? sink.variance[i] : 0.0;
      }
      r[i] = area_[i] - sum;
      diagonal_[i] = diagonal;
    });
    sinks_at_ = m;
    count_pass(worst(r));
    return r;
  }

  // The derivative of the rows' sums where x > 0, times v.
  void apply(const Vector& v, Vector& result) const {
    for_rows([&](std::size_t i) {
      double sum = 0.0;
      for (auto at = areas_.row_begin[i]; at < areas_.row_begin[i + 1]; ++at) {
        const auto variance = std::max(areas_.variance[at], 0.0f);
        const auto j = areas_.column[at];
        sum += static_cast<double>(variance) * (j == i ? v[i] : v[i] + v[j]);
      }
      for (const auto& sink : areas_.sink)
        if (balanced_sink(sink, sinks_at_, i) > 0.0) sum += sink.variance[i] * v[i];
      result[i] = sum;
    });
  }

  Vector towards(const Vector& r) {
    const auto n = r.size();
    Vector x(n, 0.0);
    const auto precondition = [&](const Vector& v, Vector& result) {
      for (std::size_t i = 0; i < n; ++i) result[i] = diagonal_[i] > 0.0 ? v[i] / diagonal_[i] : 0.0;
    };
    conjugate_gradients(x, r, {max_iterations, inner_tolerance * inner_tolerance},
                        LinearSystem{[&](const Vector& v, Vector& result) { apply(v, result); }, precondition,
                                     [&](const Vector& a, const Vector& b) { return dot(a, b); }},
                        [&](int, const Vector& left) {
                          count_pass(worst(left));
                          return !is_stopped_;
                        });
    return x;
  }

  ExchangeAreas& areas_;
  std::span<const double> area_;
  const Context& context_;
  // Values at the point of the last residual.
  Vector diagonal_, sinks_at_;
  double first_ = 0.0;  // the residual at the start
  int passes_ = 0;
  bool is_stopped_ = false;
};

}  // namespace

Balance balance_rows(ExchangeAreas& areas, std::span<const double> area, const Context& context) {
  return Newton(areas, area, context).solve();
}

}  // namespace luxel
