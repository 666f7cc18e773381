// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/scene.h"

namespace luxel {

Bounds bounds(const Scene& scene) {
  Bounds box;
  for (const auto& triangle : scene.triangles)
    for (const auto corner : triangle) box.add(scene.positions[corner]);
  return box;
}

}  // namespace luxel
