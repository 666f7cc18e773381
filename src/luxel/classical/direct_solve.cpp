// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/direct_solve.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr std::size_t block = 48;  // columns eliminated together, so that their rows stay in the cache
constexpr std::size_t rows_per_chunk = 16;

// A = P^-1 L U, stored in place of A. Rows are not moved but indexed: row i of the factors is rows_[i] of A.
class Elimination {
 public:
  Elimination(std::size_t n, std::vector<double> matrix, const Context& context)
      : n_(n), a_(std::move(matrix)), rows_(n), context_(context) {
    std::iota(rows_.begin(), rows_.end(), std::size_t{0});
  }

  // fraction_done(columns done / n) may stop the work.
  template <typename FractionDone>
  bool run(const FractionDone& fraction_done) {
    for (std::size_t first = 0; first < n_; first += block) {
      const auto last = std::min(n_, first + block);
      eliminate_columns(first, last);
      finish_rows(first, last);
      update_rest(first, last);
      if (fraction_done(static_cast<double>(last) / static_cast<double>(n_)) == Next::stop) return false;
    }
    return true;
  }

  std::vector<double> solve(const std::vector<double>& right) const {
    std::vector<double> x(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      const auto* row = &a_[rows_[i] * n_];
      double sum = right[rows_[i]];
      for (std::size_t j = 0; j < i; ++j) sum -= row[j] * x[j];
      x[i] = sum;
    }
    for (std::size_t i = n_; i-- > 0;) {
      const auto* row = &a_[rows_[i] * n_];
      for (std::size_t j = i + 1; j < n_; ++j) x[i] -= row[j] * x[j];
      x[i] /= row[i];
    }
    return x;
  }

 private:
  double* row(std::size_t i) { return &a_[rows_[i] * n_]; }

  // Eliminates columns [first, last) of the rows from `first` on.
  void eliminate_columns(std::size_t first, std::size_t last) {
    for (auto k = first; k < last; ++k) {
      auto pivot = k;
      for (auto i = k + 1; i < n_; ++i)
        if (std::abs(row(i)[k]) > std::abs(row(pivot)[k])) pivot = i;
      std::swap(rows_[k], rows_[pivot]);
      const auto* top = row(k);
      if (top[k] == 0.0) throw InputError("the equations of the light have no single solution");
      for (auto i = k + 1; i < n_; ++i) {
        auto* below = row(i);
        const auto factor = below[k] /= top[k];
        for (auto j = k + 1; j < last; ++j) below[j] -= factor * top[j];
      }
    }
  }

  // Updates the rows [first, last) to the right of these columns.
  void finish_rows(std::size_t first, std::size_t last) {
    for (auto k = first; k < last; ++k)
      for (auto i = k + 1; i < last; ++i) subtract(row(i), row(i)[k], row(k), last);
  }

  void update_rest(std::size_t first, std::size_t last) {
    context_.for_chunks(n_ - last, rows_per_chunk, [&](std::size_t begin, std::size_t end, int) {
      for (auto k = first; k < last; ++k)
        for (auto i = last + begin; i < last + end; ++i) subtract(row(i), row(i)[k], row(k), last);
    });
  }

  void subtract(double* from, double factor, const double* what, std::size_t column) const {
    if (factor == 0.0) return;
    for (auto j = column; j < n_; ++j) from[j] -= factor * what[j];
  }

  std::size_t n_;
  std::vector<double> a_;
  std::vector<std::size_t> rows_;
  const Context& context_;
};

}  // namespace

bool solve_directly(std::span<const float> factors, std::span<const float> emittance,
                    const Scattering& scattering, std::span<float> radiosity, const Context& context) {
  const auto reflectance = scattering.reflectance, transmittance = scattering.transmittance;
  const auto n = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(factors.size()))));
  std::copy(emittance.begin(), emittance.end(), radiosity.begin());
  if (n == 0) return true;
  const auto bands = emittance.size() / n;
  std::vector<float> result(radiosity.begin(), radiosity.end());
  std::vector<std::uint8_t> is_solved(bands, 0);
  for (std::size_t band = 0; band < bands; ++band) {
    if (is_solved[band]) continue;
    std::vector<double> matrix(n * n);
    context.for_chunks(n, rows_per_chunk, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        for (std::size_t j = 0; j < n; ++j)
          matrix[i * n + j] =
              (i == j ? 1.0 : 0.0) - double{reflectance[i * bands + band]} * double{factors[i * n + j]};
        for (std::size_t j = 0; scattering.transmits() && j < n; ++j)
          matrix[i * n + j] -=
              double{transmittance[i * bands + band]} * double{factors[scattering.far[i] * n + j]};
      }
    });
    Elimination elimination(n, std::move(matrix), context);
    const auto tell_whole = [&](double fraction) {
      return context.report({"light", (static_cast<double>(band) + fraction) / static_cast<double>(bands)});
    };
    if (!elimination.run(tell_whole)) return false;
    // Solves all bands that have the same reflectances.
    for (auto other = band; other < bands; ++other) {
      bool is_alike = true;
      for (std::size_t i = 0; i < n && is_alike; ++i)
        is_alike =
            reflectance[i * bands + other] == reflectance[i * bands + band] &&
            (transmittance.empty() || transmittance[i * bands + other] == transmittance[i * bands + band]);
      if (!is_alike) continue;
      std::vector<double> right(n);
      for (std::size_t i = 0; i < n; ++i) right[i] = double{emittance[i * bands + other]};
      const auto solved = elimination.solve(right);
      for (std::size_t i = 0; i < n; ++i) result[i * bands + other] = static_cast<float>(solved[i]);
      is_solved[other] = 1;
    }
  }
  std::copy(result.begin(), result.end(), radiosity.begin());
  return true;
}

}  // namespace luxel
