// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/is_gltf.h"

#include "luxel/core/ending_of.h"

namespace luxel {

bool is_gltf(const std::filesystem::path& path) {
  const auto ending = ending_of(path);
  return ending == ".glb" || ending == ".gltf";
}

}  // namespace luxel
