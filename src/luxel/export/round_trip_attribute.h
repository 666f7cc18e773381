// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "luxel/export/round_trip_parts.h"
#include "luxel/export/round_trip_surfaces.h"
#include "luxel/import/gltf_array.h"

namespace luxel {

// An attribute of a primitive at the vertices of a part, the middles of others included, and between them.
// Keeps references.
class RoundTripAttribute {
 public:
  // Decides how values are interpolated.
  enum class Kind { position, direction, joints, other };
  using Numbers = std::array<double, 4>;

  RoundTripAttribute(const GltfArray& array, const RoundTripPart& part, Kind kind)
      : array_(array), part_(part), kind_(kind) {}

  Numbers at(std::uint32_t vertex) const;
  Numbers between(const RoundTripVertex& vertex) const;

 private:
  const GltfArray& array_;
  const RoundTripPart& part_;
  Kind kind_;
};

}  // namespace luxel
