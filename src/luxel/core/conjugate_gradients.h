// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <vector>

namespace luxel {

struct ConjugateGradientLimits {
  int max_steps = 0;
  double squared_tolerance =
      0.0;                 // stops where residual · preconditioned residual is at most this fraction ...
  double reference = 0.0;  // ... of this; 0: of its value at the start
};

// A, M and the scalar product, whose order of summation decides whether the result repeats.
template <typename Apply, typename Precondition, typename Dot>
struct LinearSystem {
  Apply apply;                // (v, result): result = A v
  Precondition precondition;  // (r, result): result = M⁻¹ r
  Dot dot;                    // (a, b)
};
template <typename Apply, typename Precondition, typename Dot>
LinearSystem(Apply, Precondition, Dot) -> LinearSystem<Apply, Precondition, Dot>;

// Solves A x = b for a symmetric positive definite A by preconditioned conjugate gradients (Hestenes and
// Stiefel 1952), and returns the number of steps. x: the start, and the result. residual: b - A x at the
// start. may_step(step, residual): called before each step; false stops. Ends early where A proves not to be
// positive definite. Cost per step: one apply, and vectors of doubles.
template <typename Apply, typename Precondition, typename Dot, typename MayStep>
int conjugate_gradients(std::vector<double>& x, std::vector<double> residual,
                        const ConjugateGradientLimits& limits,
                        const LinearSystem<Apply, Precondition, Dot>& system, const MayStep& may_step) {
  const auto& [apply, precondition, dot] = system;
  const auto n = x.size();
  assert(residual.size() == n);
  std::vector<double> scaled(n), image(n);
  precondition(residual, scaled);
  auto direction = scaled;
  auto norm = dot(residual, scaled);
  const auto goal = limits.squared_tolerance * (limits.reference > 0.0 ? limits.reference : norm);
  int step = 0;
  for (; step < limits.max_steps && norm > goal && may_step(step, residual); ++step) {
    apply(direction, image);
    const auto curvature = dot(direction, image);
    if (!(curvature > 0.0)) break;
    const auto length = norm / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += length * direction[i];
      residual[i] -= length * image[i];
    }
    precondition(residual, scaled);
    const auto next = dot(residual, scaled);
    for (std::size_t i = 0; i < n; ++i) direction[i] = scaled[i] + next / norm * direction[i];
    norm = next;
  }
  return step;
}

}  // namespace luxel
