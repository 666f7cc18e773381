// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace luxel {

// Columns of values that are smoothed together: bands of replicates, padded so that those of one replicate
// fill whole groups of four. Column = replicate * stride() + band.
struct WindowColumns {
  std::size_t replicates = 0, bands = 0;

  std::size_t stride() const { return (bands + 3) / 4 * 4; }
  std::size_t size() const { return replicates * stride(); }
};

// A receiver in a window.
struct WindowMember {
  std::size_t index = 0;     // in its sheet
  float weight = 0.0f;       // in the window, see WindowGrid::weight
  float area = 0.0f;         // m², times the weight
  float u = 0.0f, v = 0.0f;  // place along the window's two axes, in spacings from its node
};

// Weighted least squares of a polynomial in u and v to the columns of a window's members.
class WindowFit {
 public:
  static constexpr std::size_t max_terms = 6;  // 1; u, v; u², u v, v²
  using Powers = std::array<float, max_terms>;

  // The number of terms that this many members determine, at most those of the degree (1 or 2).
  static std::size_t terms_for(std::size_t members, int degree) {
    return members >= 24 && degree >= 2 ? 6 : members >= 6 ? 3 : 1;
  }
  static Powers powers(const WindowMember& m) { return {1.0f, m.u, m.v, m.u * m.u, m.u * m.v, m.v * m.v}; }

  // values: [index * columns.size() + column]. coefficients: [term * columns.size() + column], is written. A
  // term that is linearly dependent on those before it (for example where all members lie on a line) is left
  // out.
  static void fit(std::span<const WindowMember> members, std::size_t terms, const float* values,
                  WindowColumns columns, float* coefficients);

  // difference[column] = polynomial - value, of one member.
  static void subtract(const Powers& powers, std::size_t terms, const float* coefficients, const float* value,
                       WindowColumns columns, float* difference);
};

// Sums over a window's members and all bands, of one half of the replicates: weight, area and risk weight
// times unbiased estimates, in which products of different replicates stand for squares of means.
struct WindowRisk {
  double bias = 0.0;        // square of the mean of fit - value
  double variance = 0.0;    // of the mean of fit - value
  double covariance = 0.0;  // of the mean of the value with that of fit - value
};

// Fits of the first replicates / 2 replicates, and of the others. risk_weight: [index].
std::array<WindowRisk, 2> window_risk(std::span<const WindowMember> members, std::size_t terms,
                                      const float* values, WindowColumns columns, const float* coefficients,
                                      const float* risk_weight);

}  // namespace luxel
