// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/image/image.h"
#include "luxel/solution/solution_file.h"

namespace luxel {

/// A place where two solutions differ.
struct Difference {
  std::size_t index = 0;  ///< solutions: side 2 * patch (front) or 2 * patch + 1; pictures: pixel, row by row
  double a = 0.0, b = 0.0;  ///< mean over bands; solutions: irradiance, W/m²; pictures: radiance, W/(m² sr)
  double error = 0.0;       ///< standard error of b - a, of the mean over bands; 0: not known
};

/// Difference of B from A. Weights: the area of a side; pictures: every pixel alike. Every band counts.
struct Comparison {
  std::size_t numbers = 0;    ///< compared: places times bands
  double relative_rms = 0.0;  ///< sqrt(sum of w (b - a)² / sum of w a²)
  double mean_bias = 0.0;     ///< sum of w (b - a) / sum of w a
  /// z = (b - a) / sqrt(error of a² + error of b²), of the numbers where an error is known and not 0.
  std::size_t scored = 0;
  /// About 1 if the stated errors of both are true. |z| beyond 6 counts as 6: a solution states no error
  /// where no light has arrived yet, and a few such places would dominate the mean.
  double mean_z2 = 0.0;
  std::size_t outliers = 0;           ///< with |z| beyond 6
  double within = 0.0;                ///< fraction with |z| < 1.96: about 0.95
  double expected_rms = 0.0;          ///< relative_rms if only the stated errors contribute
  double bias_error = 0.0;            ///< standard error of mean_bias, were errors of places independent
  std::vector<Difference> largest{};  ///< by |b - a|, largest first

  /// Returns whether the stated errors explain the difference; nothing where either states none. The width of
  /// an error bar is known to a tenth, noise has tails, and errors of different places are correlated, so the
  /// test is coarse: mean_z2 up to 1.5, within from 0.9 on, mean_bias up to half of expected_rms or five
  /// bias_error. Where one states only an error of the whole, nothing is scored, and the square of
  /// relative_rms may be 1.5 times that of expected_rms.
  std::optional<bool> agrees() const;
};

/// Two solutions on the same patches. Where one is of a spectrum and the other of plain colour, or of another
/// spectrum, both are compared as linear sRGB (PatchSet::colours). Throws MismatchError, in one sentence,
/// where patches differ, or bands that have no colour; materials may. places: of `largest`, at most.
Comparison compare_solutions(const Baked& a, const Baked& b, std::size_t places = 10);

/// Two pictures of one size; standard errors are pictures too, or null. Throws MismatchError where sizes
/// differ.
Comparison compare_pictures(const Image& a, const Image& b, const Image* error_a = nullptr,
                            const Image* error_b = nullptr, std::size_t places = 10);

/// (b - a) / max(a, floor) of the mean over bands: signed, per side or per pixel as `index` above. floor: a
/// hundredth of the mean of a over lit places, so that dark places do not dominate. NaN where both are 0 and
/// there is nothing to compare.
std::vector<float> relative_differences(const Baked& a, const Baked& b);
std::vector<float> relative_differences(const Image& a, const Image& b);

}  // namespace luxel
