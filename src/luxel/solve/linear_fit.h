// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace luxel {

// Least squares of c0 + c1 u + c2 v to values over places (u, v), weighted by area, for several columns of
// values at once: replicates times bands, column = replicate * bands + band.
struct Columns {
  std::size_t replicates = 0, bands = 0;
  std::size_t size() const { return replicates * bands; }
};

// Of a patch in its region: two coordinates in the plane, about one region across; and its area, m².
struct FitPlace {
  float u = 0.0f, v = 0.0f, area = 0.0f;
};

// Sums over places that fits are made from; those of a union are the sums of both.
struct Moments {
  std::array<double, 6> gram{};  // of 1, u, v: upper triangle, row by row
  std::vector<double> right;     // of 1, u, v times the value: [3][column]
  std::uint32_t places = 0;

  explicit Moments(Columns columns) : right(3 * columns.size(), 0.0) {}
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

// The fit to some moments; a constant where there are few places, or all on a line.
class LinearFit {
 public:
  static constexpr std::uint32_t linear_places = 6;  // fewer carry a constant only

  explicit LinearFit(const Moments& m);

  // Adds the energy of the fitted functions.
  void add_energy(const Moments& m, Columns columns, Energy& energy) const;
  // c0, c1, c2 of one column.
  std::array<double, 3> coefficients(const Moments& m, std::size_t column) const;

 private:
  // The Gram matrix is L D L'.
  std::array<double, 3> lower_{};    // L10, L20, L21
  std::array<double, 3> inverse_{};  // of D; 0 for what is not fitted
};

}  // namespace luxel
