// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/polygon_form_factor.h"

#include <numbers>

namespace luxel {

double polygon_exchange_area(std::span<const Vec3d> a, std::span<const Vec3d> b) {
  constexpr int cuts = 8;
  const auto middle_of = [](std::span<const Vec3d> p, std::size_t k, int i, int j, Vec3d& normal) {
    const auto s = (i + 0.5) / cuts, t = (j + 0.5) / cuts;
    const auto u = p[k] - p[0], v = p[k + 1] - p[0];
    normal = s * glm::cross(u, v) / double(cuts * cuts);
    return p[0] + s * ((1.0 - t) * u + t * v);
  };
  double sum = 0.0;
  for (std::size_t k = 1; k + 1 < a.size(); ++k)
    for (std::size_t l = 1; l + 1 < b.size(); ++l)
      for (int i = 0; i < cuts * cuts; ++i)
        for (int j = 0; j < cuts * cuts; ++j) {
          Vec3d m, n;
          const auto d = middle_of(b, l, j / cuts, j % cuts, n) - middle_of(a, k, i / cuts, i % cuts, m);
          const auto r2 = glm::dot(d, d);
          const auto out = glm::dot(m, d), in = -glm::dot(n, d);
          if (out > 0.0 && in > 0.0) sum += out * in / (std::numbers::pi * r2 * r2);
        }
  return sum;
}

double polygon_form_factor(std::span<const Vec3d> a, std::span<const Vec3d> b) {
  double area2 = 0.0;
  for (std::size_t k = 1; k + 1 < a.size(); ++k)
    area2 += glm::length(glm::cross(a[k] - a[0], a[k + 1] - a[0]));
  return area2 > 0.0 ? polygon_exchange_area(a, b) / (0.5 * area2) : 0.0;
}

}  // namespace luxel
