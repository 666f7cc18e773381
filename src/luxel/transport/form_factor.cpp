// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/form_factor.h"

#include <array>

#include "luxel/transport/polygon_form_factor.h"

namespace luxel {

FormFactors::FormFactors(const PatchSet& patches, const Tracer& tracer, const Workers&)
    : patches_(patches), tracer_(tracer) {}

FormFactor FormFactors::between(std::size_t from, std::size_t to, double) const {
  const auto corners = [&](std::size_t side) {
    const auto p = patches_.points(side / 2);
    if (side % 2 == 0) return std::array{Vec3d(p[0]), Vec3d(p[1]), Vec3d(p[2])};
    return std::array{Vec3d(p[0]), Vec3d(p[2]), Vec3d(p[1])};
  };
  static_cast<void>(tracer_);
  const auto a = corners(from), b = corners(to);
  return {polygon_form_factor(a, b), 1e-2, false};
}

}  // namespace luxel
