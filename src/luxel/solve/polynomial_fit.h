// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace luxel {

// Least squares of a polynomial in u and v to values over places (u, v), weighted by area, for several
// columns of values at once: replicates times bands, column = replicate * bands + band.
struct Columns {
  std::size_t replicates = 0, bands = 0;
  std::size_t size() const { return replicates * bands; }
};

// Of a patch in its region: two coordinates in the plane, about one region across; and its area, m².
struct FitPlace {
  float u = 0.0f, v = 0.0f, area = 0.0f;
};

// Terms of a polynomial, by degree: 1; u, v; u², u v, v²; ...
constexpr std::size_t terms_of_degree(int degree) {
  return static_cast<std::size_t>((degree + 1) * (degree + 2) / 2);
}
inline constexpr int most_degree = 2;
inline constexpr std::size_t most_terms = terms_of_degree(most_degree);
using Terms = std::array<double, most_terms>;  // coefficients

// Powers up to a degree, times a number.
template <int degree>
constexpr std::array<double, terms_of_degree(degree)> powers(const FitPlace& at, double times) {
  std::array<double, terms_of_degree(degree)> result{};
  result[0] = times;
  std::size_t from = 0;
  std::size_t to = 1;
  for (std::size_t d = 1; d <= degree; ++d) {
    for (std::size_t i = 0; i < d; ++i) result[to++] = result[from + i] * static_cast<double>(at.u);
    result[to++] = result[from + d - 1] * static_cast<double>(at.v);
    from += d;
  }
  return result;
}

// Sums over places that fits are made from; those of a union are the sums of both.
struct Moments {
  std::array<double, terms_of_degree(2 * most_degree)> gram{};  // of area times powers
  std::vector<double> right;  // of area times power times value: [power][column]
  std::uint32_t places = 0;

  explicit Moments(Columns columns) : right(most_terms * columns.size(), 0.0) {}
  void clear();
  void add(const Moments& other);
};

// What replicates say of a sum of squares: an estimate of the square of the mean, free of noise, and the
// variance of the mean.
struct Energy {
  std::vector<double> signal;  // [band]
  double noise = 0.0;          // all bands

  explicit Energy(Columns columns) : signal(columns.bands, 0.0) {}
  void clear();
  void add(const Energy& other);
  // From sums over replicates: |sum of x_r|² and sum of |x_r|².
  void add_sums(std::size_t band, double of_sum, double of_squares, double replicates) {
    const auto pairs = replicates * (replicates - 1.0);
    signal[band] += (of_sum - of_squares) / pairs;
    noise += (of_squares - of_sum / replicates) / pairs;
  }
};

// The fit to some moments.
class PolynomialFit {
 public:
  // How many places carry a polynomial of a degree; fewer carry a lower one.
  static constexpr std::array<std::uint32_t, most_degree + 1> least_places = {0, 6, 24};

  // A term that the places cannot tell from those before it (all of them lie on a line, say) is left out.
  PolynomialFit(const Moments& m, int degree);

  // Adds the energy of the fitted functions.
  void add_energy(const Moments& m, Columns columns, Energy& energy) const;
  // Of one column; 0 for what is not fitted.
  Terms coefficients(const Moments& m, std::size_t column) const;

 private:
  template <std::size_t terms>
  void add_energy_of(const Moments& m, Columns columns, Energy& energy) const;

  int degree_ = 0;
  // The Gram matrix is L D L'.
  std::array<Terms, most_terms> lower_{};  // below the diagonal
  Terms inverse_{};                        // of D; 0 for what is not fitted
};

}  // namespace luxel
