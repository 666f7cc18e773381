// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewfactors/balance.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

constexpr std::size_t rows_a_chunk = 256;
constexpr int most_steps = 60;
constexpr int most_iterations = 400;  // of conjugate gradients a step
constexpr int most_halvings = 20;
constexpr double enough = 2e-13;  // of a row's area
constexpr double inner_tolerance = 1e-3;

using Vector = std::vector<double>;

class Newton {
 public:
  Newton(const ExchangeAreas& areas, std::span<const double> area, const Workers& workers)
      : areas_(areas), area_(area), workers_(workers) {}

  Balance solve() {
    const auto n = areas_.size();
    Vector m(n, 0.0), r = residual(m);
    Balance best{m, worst(r), 0};
    for (int step = 1; step <= most_steps && best.worst > enough; ++step) {
      const auto direction = towards(m, r);
      // Whole steps but where pieces change: then halves.
      bool is_better = false;
      double share = 1.0;
      for (int h = 0; h < most_halvings && !is_better; ++h, share *= 0.5) {
        auto next = m;
        for (std::size_t i = 0; i < n; ++i) next[i] += share * direction[i];
        auto left = residual(next);
        is_better = dot(left, left) < dot(r, r);
        if (!is_better) continue;
        m = std::move(next);
        r = std::move(left);
      }
      if (!is_better) break;
      if (const auto w = worst(r); w < best.worst) best = {m, w, step};
    }
    return best;
  }

 private:
  template <typename Body>
  void for_rows(Body body) const {
    workers_.for_chunks(areas_.size(), rows_a_chunk, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) body(i);
    });
  }
  double dot(const Vector& a, const Vector& b) const {
    return ordered_sum(workers_, a.size(), [&](std::size_t i) { return a[i] * b[i]; });
  }
  double worst(const Vector& r) const {
    double most = 0.0;
    for (std::size_t i = 0; i < r.size(); ++i) most = std::max(most, std::fabs(r[i]) / area_[i]);
    return most;
  }

  // What each row lacks, m².
  Vector residual(const Vector& m) const {
    Vector r(m.size());
    for_rows([&](std::size_t i) {
      double sum = 0.0;
      for (auto at = areas_.row_begin[i]; at < areas_.row_begin[i + 1]; ++at)
        sum += balanced(areas_, m, i, at);
      for (const auto& sink : areas_.sink) sum += balanced_sink(sink, m, i);
      r[i] = area_[i] - sum;
    });
    return r;
  }

  // The derivative of the rows' sums at m, where x > 0, times v; and its diagonal.
  template <typename Term>
  void for_derivative(const Vector& m, std::size_t i, Term term) const {
    for (auto at = areas_.row_begin[i]; at < areas_.row_begin[i + 1]; ++at)
      if (balanced(areas_, m, i, at) > 0.0) term(areas_.column[at], static_cast<double>(areas_.variance[at]));
    for (const auto& sink : areas_.sink)
      if (balanced_sink(sink, m, i) > 0.0) term(i, sink.variance[i]);
  }
  void apply(const Vector& m, const Vector& v, Vector& result) const {
    for_rows([&](std::size_t i) {
      double sum = 0.0;
      for_derivative(
          m, i, [&](std::size_t j, double variance) { sum += variance * (j == i ? v[i] : v[i] + v[j]); });
      result[i] = sum;
    });
  }

  Vector towards(const Vector& m, const Vector& r) const {
    const auto n = m.size();
    Vector diagonal(n), x(n, 0.0), left = r, z(n), p(n), applied(n);
    for_rows([&](std::size_t i) {
      for_derivative(m, i, [&](std::size_t, double variance) { diagonal[i] += variance; });
    });
    const auto precondition = [&] {
      for (std::size_t i = 0; i < n; ++i) z[i] = diagonal[i] > 0.0 ? left[i] / diagonal[i] : 0.0;
    };
    precondition();
    p = z;
    auto rz = dot(left, z);
    const auto goal = inner_tolerance * inner_tolerance * rz;
    for (int k = 0; k < most_iterations && rz > goal; ++k) {
      apply(m, p, applied);
      const auto curvature = dot(p, applied);
      if (!(curvature > 0.0)) break;
      const auto length = rz / curvature;
      for (std::size_t i = 0; i < n; ++i) {
        x[i] += length * p[i];
        left[i] -= length * applied[i];
      }
      precondition();
      const auto next = dot(left, z);
      for (std::size_t i = 0; i < n; ++i) p[i] = z[i] + (next / rz) * p[i];
      rz = next;
    }
    return x;
  }

  const ExchangeAreas& areas_;
  std::span<const double> area_;
  const Workers& workers_;
};

}  // namespace

Balance balance_rows(const ExchangeAreas& areas, std::span<const double> area, const Workers& workers) {
  return Newton(areas, area, workers).solve();
}

}  // namespace luxel
