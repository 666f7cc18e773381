// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/edge_pair_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "luxel/core/logarithm.h"
#include "luxel/core/trig.h"
#include "luxel/form_factors/dilogarithm.h"

namespace luxel {
namespace {

constexpr double pi_d = std::numbers::pi;
constexpr double parallel_sine = 1e-14;  // lines that double precision cannot distinguish from parallel ones
constexpr double skew_sine = 0.3;        // below it, the closed form loses digits in proportion to 1 / sine²
constexpr double max_cancelled =
    20.0;  // largest size of its cancelling terms, for edges of about unit length
constexpr double log_floor = 1e-290;

double safe_log(double x) { return natural_logarithm(std::max(x, log_floor)); }

// The parts of u, given sinh u = x, that the dilogarithms need: e^-|u|, |u| and the sign.
struct Hyperbolic {
  double decay = 1.0;
  double u = 0.0;
};
Hyperbolic area_sinh(double x) {
  const auto size = std::fabs(x);
  const auto grown = size + std::sqrt(size * size + 1.0);
  const auto u = natural_logarithm(grown);
  return {1.0 / grown, x < 0.0 ? -u : u};
}

// An even, smooth function of u: the integral of arctan(cot(angle / 2) tanh(u / 2)), and a constant.
struct Angle {
  double angle, cosine, sine;
};
double bent(double u, double decay, const Angle& a) {
  return dilogarithm_imaginary(decay, a.angle, a.cosine, a.sine) + 0.5 * (pi_d - a.angle) * std::fabs(u);
}

// Two skew lines, parameterised by length from the foot points of their common perpendicular.
struct Skew {
  Angle between;  // the lines
  double distance = 0.0;

  // G with d²G / ds dt = ln(s² - 2 s t cos + t² + d²).
  double corner(double s, double t) const;
};

double Skew::corner(double s, double t) const {
  const auto [angle, c, S] = between;
  const auto d = distance;
  const auto along_s = s - c * t, along_t = t - c * s;
  const auto off_s = std::sqrt(S * S * t * t + d * d), off_t = std::sqrt(S * S * s * s + d * d);
  const auto L = safe_log(along_s * along_s + off_s * off_s);
  auto G = (s * t - 0.5 * c * (s * s + t * t)) * L - 3.0 * s * t + s * off_t * arc_tangent(along_t, off_t) +
           t * off_s * arc_tangent(along_s, off_s);
  // As d goes to 0, the last term vanishes as d² ln d.
  const auto x = s * S / d, y = t * S / d;
  if (!(std::fabs(x) < 1e12 && std::fabs(y) < 1e12)) return G;
  const auto phi = area_sinh(x), theta = area_sinh(y);
  // e^-|a + b| from e^-|a| and e^-|b|.
  const auto both = phi.decay * theta.decay;
  const auto ratio = std::min(phi.decay, theta.decay) / std::max(phi.decay, theta.decay);
  const bool same = (phi.u < 0.0) == (theta.u < 0.0);
  const Angle other{pi_d - angle, -c, S};
  const auto P =
      bent(phi.u + theta.u, same ? both : ratio, other) - bent(theta.u - phi.u, same ? ratio : both, between);
  return G + d * d / S * P;
}

// K with d²K / dw² = ln(w² + d²): parallel lines at the distance d.
double parallel_corner(double w, double d) {
  const auto w2 = w * w, d2 = d * d;
  return 0.5 * (w2 - d2) * safe_log(w2 + d2) - 1.5 * w2 + 2.0 * d * w * arc_tangent(w, d);
}

template <typename Corner>
double over_edges(const Corner& G, double s0, double s1, double t0, double t1) {
  return (G(s1, t1) - G(s0, t1)) - (G(s1, t0) - G(s0, t0));
}

}  // namespace

double edge_pair_integral(const Edge& p, const Edge& q) {
  const auto length_p = glm::length(p.to - p.from), length_q = glm::length(q.to - q.from);
  if (!(length_p > 0.0 && length_q > 0.0)) return 0.0;
  const auto u = (p.to - p.from) / length_p, v = (q.to - q.from) / length_q;
  const auto c = glm::dot(u, v);
  if (c == 0.0) return 0.0;
  const auto across = glm::cross(u, v);
  const auto S = glm::length(across);
  const auto apart = q.from - p.from;

  if (S < parallel_sine) {
    // w = s -/+ t - foot_point.
    const auto sign = c < 0.0 ? -1.0 : 1.0;
    const auto foot_point = glm::dot(apart, u);
    const auto d = glm::length(apart - foot_point * u);
    const auto K = [&](double s, double t) { return parallel_corner(s - sign * t - foot_point, d); };
    return -c * sign * over_edges(K, 0.0, length_p, 0.0, length_q);
  }

  if (S < skew_sine) return edge_pair_quadrature(p, q);
  const auto du = glm::dot(apart, u), dv = glm::dot(apart, v);
  const auto foot_point_p = (du - c * dv) / (S * S), foot_point_q = (c * du - dv) / (S * S);
  const auto d = std::fabs(glm::dot(apart, across)) / S;
  const auto farthest = std::max({std::fabs(foot_point_p), std::fabs(length_p - foot_point_p),
                                  std::fabs(foot_point_q), std::fabs(length_q - foot_point_q)});
  if (farthest * farthest + d * d / S > max_cancelled) return edge_pair_quadrature(p, q);
  const Skew lines{{arc_tangent(S, c), c, S}, d};
  const auto G = [&](double s, double t) { return lines.corner(s, t); };
  return c * over_edges(G, -foot_point_p, length_p - foot_point_p, -foot_point_q, length_q - foot_point_q);
}

}  // namespace luxel
