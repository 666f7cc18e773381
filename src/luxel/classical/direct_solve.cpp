// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/direct_solve.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "luxel/core/disjoint_sets.h"
#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr std::size_t block = 48;  // columns eliminated together, so that their rows stay in the cache
constexpr std::size_t tile = 512;  // columns updated together
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
      for (auto i = k + 1; i < last; ++i) subtract(row(i), row(i)[k], row(k), last, n_);
  }

  // Tile by tile of columns, and four eliminated columns at a time, so that a row is read and written from
  // the nearest cache a quarter as often.
  void update_rest(std::size_t first, std::size_t last) {
    context_.for_chunks(n_ - last, rows_per_chunk, [&](std::size_t begin, std::size_t end, int) {
      for (auto left = last; left < n_; left += tile) {
        const auto right = std::min(n_, left + tile);
        auto k = first;
        for (; k + 4 <= last; k += 4)
          for (auto i = last + begin; i < last + end; ++i) subtract_four(row(i), k, left, right);
        for (; k < last; ++k)
          for (auto i = last + begin; i < last + end; ++i) subtract(row(i), row(i)[k], row(k), left, right);
      }
    });
  }

  void subtract_four(double* from, std::size_t k, std::size_t left, std::size_t right) {
    const double f0 = from[k], f1 = from[k + 1], f2 = from[k + 2], f3 = from[k + 3];
    const double *w0 = row(k), *w1 = row(k + 1), *w2 = row(k + 2), *w3 = row(k + 3);
    for (auto j = left; j < right; ++j)
      from[j] = (((from[j] - f0 * w0[j]) - f1 * w1[j]) - f2 * w2[j]) - f3 * w3[j];
  }

  static void subtract(double* from, double factor, const double* what, std::size_t left, std::size_t right) {
    if (factor == 0.0) return;
    for (auto j = left; j < right; ++j) from[j] -= factor * what[j];
  }

  std::size_t n_;
  std::vector<double> a_;
  std::vector<std::size_t> rows_;
  const Context& context_;
};

// The rows whose light depends on one another, directly or through others, as sets: the inside of a closed
// box and its outside are two systems of equations.
std::vector<std::vector<std::uint32_t>> coupled_rows(std::span<const float> factors,
                                                     const Scattering& scattering, std::size_t n) {
  DisjointSets sets(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (scattering.transmits()) sets.join(i, scattering.far[i]);
    for (std::uint32_t j = 0; j < n; ++j)
      if (factors[std::size_t{i} * n + j] != 0.0f) sets.join(i, j);
  }
  std::vector<std::vector<std::uint32_t>> rows(n);
  for (std::uint32_t i = 0; i < n; ++i) rows[sets.of(i)].push_back(i);
  std::erase_if(rows, [](const auto& set) { return set.empty(); });
  return rows;
}

// The equations of one band.
class Equations {
 public:
  Equations(std::span<const float> factors, const Scattering& scattering, std::size_t n, std::size_t bands)
      : factors_(factors), scattering_(scattering), n_(n), bands_(bands) {}

  // I - rho F of some rows, without the columns of others, on which they do not depend.
  std::vector<double> matrix(std::span<const std::uint32_t> rows, std::size_t band,
                             const Context& context) const {
    const auto m = rows.size();
    std::vector<double> matrix(m * m);
    context.for_chunks(m, rows_per_chunk, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        const auto* own = &factors_[rows[i] * n_];
        const double reflectance = scattering_.reflectance[rows[i] * bands_ + band];
        for (std::size_t j = 0; j < m; ++j)
          matrix[i * m + j] = (i == j ? 1.0 : 0.0) - reflectance * double{own[rows[j]]};
        if (!scattering_.transmits()) continue;
        const auto* far = &factors_[scattering_.far[rows[i]] * n_];
        const double transmittance = scattering_.transmittance[rows[i] * bands_ + band];
        for (std::size_t j = 0; j < m; ++j) matrix[i * m + j] -= transmittance * double{far[rows[j]]};
      }
    });
    return matrix;
  }

  // Returns whether these rows have the same matrix in both bands.
  bool are_alike(std::span<const std::uint32_t> rows, std::size_t a, std::size_t b) const {
    return std::all_of(rows.begin(), rows.end(), [&](std::uint32_t i) {
      const auto same = [&](std::span<const float> values) {
        return values[i * bands_ + a] == values[i * bands_ + b];
      };
      return same(scattering_.reflectance) && (!scattering_.transmits() || same(scattering_.transmittance));
    });
  }

 private:
  std::span<const float> factors_;
  const Scattering& scattering_;
  std::size_t n_, bands_;
};

}  // namespace

bool solve_directly(std::span<const float> factors, std::span<const float> emittance,
                    const Scattering& scattering, std::span<float> radiosity, const Context& context) {
  const auto n = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(factors.size()))));
  std::copy(emittance.begin(), emittance.end(), radiosity.begin());
  if (n == 0) return true;
  const auto bands = emittance.size() / n;
  const Equations equations(factors, scattering, n, bands);
  std::vector<float> result(radiosity.begin(), radiosity.end());
  const auto systems = coupled_rows(factors, scattering, n);
  const auto cost = [](std::span<const std::uint32_t> rows) {
    return std::pow(static_cast<double>(rows.size()), 3);
  };
  double all = 0.0, done = 0.0;
  for (const auto& rows : systems) all += static_cast<double>(bands) * cost(rows);
  for (const auto& rows : systems) {
    std::vector<bool> is_solved(bands, false);
    for (std::size_t band = 0; band < bands; ++band, done += cost(rows)) {
      if (is_solved[band]) continue;
      Elimination elimination(rows.size(), equations.matrix(rows, band, context), context);
      const auto report = [&](double fraction) {
        return context.report({"light", (done + fraction * cost(rows)) / all});
      };
      if (!elimination.run(report)) return false;
      // Solves all bands that have the same reflectances.
      for (auto other = band; other < bands; ++other) {
        if (!equations.are_alike(rows, band, other)) continue;
        std::vector<double> right;
        for (const auto i : rows) right.push_back(double{emittance[i * bands + other]});
        const auto solved = elimination.solve(right);
        for (std::size_t i = 0; i < rows.size(); ++i)
          result[rows[i] * bands + other] = static_cast<float>(solved[i]);
        is_solved[other] = true;
      }
    }
  }
  std::copy(result.begin(), result.end(), radiosity.begin());
  return true;
}

}  // namespace luxel
