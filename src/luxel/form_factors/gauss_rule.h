// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

namespace luxel {

// The upper half of a rule of Gauss and Legendre on [-1, 1]; the lower is its mirror image.
struct GaussNode {
  double at = 0.0, weight = 0.0;
};

inline constexpr std::array<GaussNode, 2> gauss_4 = {
    {{0.33998104358485626, 0.6521451548625462}, {0.8611363115940526, 0.3478548451374537}}};
inline constexpr std::array<GaussNode, 4> gauss_8 = {{{0.18343464249564978, 0.36268378337836177},
                                                      {0.525532409916329, 0.31370664587788705},
                                                      {0.7966664774136267, 0.22238103445337434},
                                                      {0.9602898564975362, 0.10122853629037669}}};
inline constexpr std::array<GaussNode, 6> gauss_12 = {{{0.1252334085114689, 0.2491470458134027},
                                                       {0.3678314989981802, 0.23349253653835464},
                                                       {0.5873179542866175, 0.20316742672306565},
                                                       {0.7699026741943047, 0.1600783285433461},
                                                       {0.9041172563704748, 0.10693932599531888},
                                                       {0.9815606342467192, 0.04717533638651202}}};

// The integral of f over [from, to], exact for polynomials of a degree below twice the points.
template <typename Function>
double gauss_integral(std::span<const GaussNode> rule, double from, double to, const Function& f) {
  const auto middle = 0.5 * (from + to);
  const auto half = 0.5 * (to - from);
  double sum = 0.0;
  for (const auto& [at, weight] : rule) sum += weight * (f(middle - half * at) + f(middle + half * at));
  return half * sum;
}

}  // namespace luxel
