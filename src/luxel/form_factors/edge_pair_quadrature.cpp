// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "luxel/core/logarithm.h"
#include "luxel/core/trig.h"
#include "luxel/form_factors/edge_pair_integral.h"
#include "luxel/form_factors/gauss_rule.h"

namespace luxel {
namespace {

constexpr double smallest_interval = 1e-8;  // of an edge: the remaining error is proportional to its square
constexpr double log_floor = 1e-290;

// A point in the complex plane of the outer variable where the integrand is not analytic.
struct Bend {
  double at = 0.0, off = 0.0;
};

// Integral over an edge of ln(m² + off²), m along that edge, at distance `off` from its line.
double along(double m, double off) {
  return m * natural_logarithm(std::max(m * m + off * off, log_floor)) - 2.0 * m +
         2.0 * off * arc_tangent(m, off);
}

template <typename Function>
double graded(const Function& f, double from, double to, const std::array<Bend, 3>& bends, double smallest) {
  const auto length = to - from;
  const auto is_near = [&](const Bend& bend) {
    const auto beside = std::max({0.0, from - bend.at, bend.at - to});
    return beside * beside + bend.off * bend.off < length * length;
  };
  if (length <= smallest || std::none_of(bends.begin(), bends.end(), is_near))
    return gauss_integral(gauss_12, from, to, f);
  // Split at a singular point within the interval, so that the intervals grow away from it; else in the
  // middle.
  auto cut = 0.5 * (from + to);
  for (const auto& bend : bends)
    if (bend.at > from + 1e-3 * length && bend.at < to - 1e-3 * length) cut = bend.at;
  return graded(f, from, cut, bends, smallest) + graded(f, cut, to, bends, smallest);
}

}  // namespace

double edge_pair_quadrature(const Edge& p, const Edge& q) {
  const auto length_p = glm::length(p.to - p.from), length_q = glm::length(q.to - q.from);
  if (!(length_p > 0.0 && length_q > 0.0)) return 0.0;
  const auto u = (p.to - p.from) / length_p, v = (q.to - q.from) / length_q;
  const auto c = glm::dot(u, v);
  const auto apart = q.from - p.from;

  const auto inner = [&](double s) {
    const auto x = s * u - apart;  // relative to the beginning of q
    const auto m = glm::dot(x, v);
    const auto off = glm::length(glm::cross(x, v));
    return along(length_q - m, off) - along(-m, off);
  };
  // Singular points: opposite the ends of q, and where the lines are nearest.
  const auto beside = [&](const Vec3d& end) {
    const auto at = glm::dot(end - p.from, u);
    return Bend{at, glm::length(end - p.from - at * u)};
  };
  auto crossing = Bend{-1e30, 0.0};
  const auto across = glm::cross(u, v);
  if (const auto S = glm::length(across); S > 1e-12)
    crossing = {(glm::dot(apart, u) - c * glm::dot(apart, v)) / (S * S),
                std::fabs(glm::dot(apart, across)) / (S * S)};
  return c *
         graded(inner, 0.0, length_p, {beside(q.from), beside(q.to), crossing}, smallest_interval * length_p);
}

}  // namespace luxel
