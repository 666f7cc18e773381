// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// Returns Im Li2(radius e^{i angle}), the imaginary part of the dilogarithm within the unit disk: radius in
// [0, 1], angle in [0, pi]; its cosine and sine are given too, so that callers that have them lose no digits.
// Absolute error about 1e-15. From Debye's series in Bernoulli numbers, after Euler's reflection where that
// is nearer (Lewin 1981). About 60 ns.
double dilogarithm_imaginary(double radius, double angle, double cosine, double sine);

}  // namespace luxel
