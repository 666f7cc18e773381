// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/export/round_trip_parts.h"
#include "luxel/export/round_trip_surfaces.h"
#include "luxel/scene/scene.h"

namespace luxel {

// An OBJ file whose texture coordinates are those of a lightmap: positions in the scene's coordinates, an
// object for each part, materials by name. Backs are triangles of their own, wound the other way.
class UnwrappedObj {
 public:
  // Keeps a reference.
  UnwrappedObj(const Scene& scene, double metres_per_unit);

  void add(const RoundTripPart& part, const RoundTripSurface& surface);
  const std::string& text() const { return text_; }

 private:
  // Positions of the surface's vertices, in the file's units.
  std::vector<Vec3d> positions_of(const RoundTripPart& part, const RoundTripSurface& surface) const;

  const Scene& scene_;
  double metres_per_unit_;
  std::string text_;
  std::size_t vertices_ = 0;  // written
};

}  // namespace luxel
