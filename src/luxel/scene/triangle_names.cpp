// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/triangle_names.h"

namespace luxel {

std::vector<std::string> object_and_group(const Scene& scene, std::size_t triangle) {
  std::vector<std::string> names;
  if (triangle < scene.triangle_object.size())
    names.push_back(scene.objects[scene.triangle_object[triangle]]);
  if (triangle < scene.triangle_group.size()) names.push_back(scene.groups[scene.triangle_group[triangle]]);
  return names;
}

}  // namespace luxel
