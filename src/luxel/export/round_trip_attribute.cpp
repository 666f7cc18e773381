// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/round_trip_attribute.h"

#include <cmath>

namespace luxel {

RoundTripAttribute::Numbers RoundTripAttribute::at(std::uint32_t vertex) const {
  if (const auto of_file = part_.vertices_of_file(); vertex >= of_file) {
    const auto [a, b] = part_.halved[vertex - of_file];
    return between({{a, b, b}, {0.5, 0.5, 0.0}});
  }
  const auto found = array_.at(vertex);
  return {found[0], found[1], found[2], found[3]};
}

RoundTripAttribute::Numbers RoundTripAttribute::between(const RoundTripVertex& vertex) const {
  constexpr double unit_enough = 1e-12;  // smaller squared lengths have no direction
  if (kind_ == Kind::joints) {           // indices, not quantities: taken from the nearest vertex
    const auto& w = vertex.weights;
    return at(vertex.of[w.x >= w.y && w.x >= w.z ? 0 : w.y >= w.z ? 1 : 2]);
  }
  Numbers sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto corner = at(vertex.of[i]);
    for (std::size_t c = 0; c < 4; ++c) sum[c] += vertex.weights[static_cast<int>(i)] * corner[c];
  }
  if (kind_ == Kind::direction) {
    const auto square = sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2];
    if (square > unit_enough)
      for (std::size_t c = 0; c < 3; ++c) sum[c] /= std::sqrt(square);
    if (array_.components() == 4) sum[3] = at(vertex.of[0])[3];  // handedness of a tangent
  }
  return sum;
}

}  // namespace luxel
