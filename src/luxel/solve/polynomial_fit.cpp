// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/polynomial_fit.h"

#include <algorithm>

namespace luxel {
namespace {

// Of the Gram matrix's diagonal, by degree: below it the places do not tell a term from those before it.
constexpr std::array<double, most_degree + 1> least_pivot = {0.0, 1e-7, 1e-10};

// Of each term.
constexpr std::array<std::size_t, most_terms> degree_of = [] {
  std::array<std::size_t, most_terms> result{};
  std::size_t at = 0;
  for (std::size_t d = 0; d <= most_degree; ++d)
    for (std::size_t i = 0; i <= d; ++i) result[at++] = d;
  return result;
}();

// Where among the powers the product of two terms is.
constexpr std::array<std::array<std::size_t, most_terms>, most_terms> product = [] {
  const auto begin = [](std::size_t degree) { return degree * (degree + 1) / 2; };
  std::array<std::array<std::size_t, most_terms>, most_terms> at{};
  for (std::size_t i = 0; i < most_terms; ++i)
    for (std::size_t j = 0; j < most_terms; ++j)
      at[i][j] = begin(degree_of[i] + degree_of[j]) + (i - begin(degree_of[i])) + (j - begin(degree_of[j]));
  return at;
}();

int carried_degree(std::uint32_t places, int degree) {
  while (places < PolynomialFit::least_places[static_cast<std::size_t>(degree)]) --degree;
  return degree;
}

}  // namespace

void Moments::clear() {
  gram.fill(0.0);
  std::fill(right.begin(), right.end(), 0.0);
  places = 0;
}

void Moments::add(const Moments& other) {
  for (std::size_t i = 0; i < gram.size(); ++i) gram[i] += other.gram[i];
  for (std::size_t i = 0; i < right.size(); ++i) right[i] += other.right[i];
  places += other.places;
}

void Energy::clear() {
  std::fill(signal.begin(), signal.end(), 0.0);
  noise = 0.0;
}

void Energy::add(const Energy& other) {
  for (std::size_t b = 0; b < signal.size(); ++b) signal[b] += other.signal[b];
  noise += other.noise;
}

PolynomialFit::PolynomialFit(const Moments& m, int degree) : degree_(carried_degree(m.places, degree)) {
  std::array<Terms, most_terms> scaled{};  // L D
  const auto terms = terms_of_degree(degree_);
  for (std::size_t i = 0; i < terms; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      scaled[i][j] = m.gram[product[i][j]];
      for (std::size_t k = 0; k < j; ++k) scaled[i][j] -= scaled[i][k] * lower_[j][k];
      lower_[i][j] = scaled[i][j] * inverse_[j];
    }
    const auto whole = m.gram[product[i][i]];
    auto pivot = whole;
    for (std::size_t k = 0; k < i; ++k) pivot -= scaled[i][k] * lower_[i][k];
    inverse_[i] = pivot > least_pivot[degree_of[i]] * whole ? 1.0 / pivot : 0.0;
  }
}

void PolynomialFit::add_energy(const Moments& m, Columns columns, Energy& energy) const {
  switch (degree_) {
    case 0:
      return add_energy_of<terms_of_degree(0)>(m, columns, energy);
    case 1:
      return add_energy_of<terms_of_degree(1)>(m, columns, energy);
    default:
      return add_energy_of<most_terms>(m, columns, energy);
  }
}

template <std::size_t terms>
void PolynomialFit::add_energy_of(const Moments& m, Columns columns, Energy& energy) const {
  const auto n = columns.size();
  const auto* right = m.right.data();
  const auto replicates = static_cast<double>(columns.replicates);
  for (std::size_t b = 0; b < columns.bands; ++b) {
    // The right side on orthogonal axes: their squares over the axes' own add up to the fit's energy.
    std::array<double, terms> sum{};
    std::array<double, terms> squares{};
    for (auto column = b; column < n; column += columns.bands) {
      std::array<double, terms> y;
      for (std::size_t i = 0; i < terms; ++i) {
        y[i] = right[i * n + column];
        for (std::size_t j = 0; j < i; ++j) y[i] -= lower_[i][j] * y[j];
        sum[i] += y[i];
        squares[i] += y[i] * y[i];
      }
    }
    double of_sum = 0.0;
    double of_squares = 0.0;
    for (std::size_t i = 0; i < terms; ++i) {
      of_sum += sum[i] * sum[i] * inverse_[i];
      of_squares += squares[i] * inverse_[i];
    }
    energy.add_sums(b, of_sum, of_squares, replicates);
  }
}

Terms PolynomialFit::coefficients(const Moments& m, std::size_t column) const {
  const auto n = m.right.size() / most_terms;
  const auto terms = terms_of_degree(degree_);
  Terms y{};
  for (std::size_t i = 0; i < terms; ++i) {
    y[i] = m.right[i * n + column];
    for (std::size_t j = 0; j < i; ++j) y[i] -= lower_[i][j] * y[j];
  }
  Terms c{};
  for (auto i = terms; i-- > 0;) {
    c[i] = y[i] * inverse_[i];
    if (inverse_[i] == 0.0) continue;
    for (auto j = i + 1; j < terms; ++j) c[i] -= lower_[j][i] * c[j];
  }
  return c;
}

}  // namespace luxel
