// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/used_textures.h"

#include <map>
#include <utility>

namespace luxel {

void keep_used_textures(Scene& scene) {
  const auto all = std::exchange(scene.textures, {});
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (auto& material : scene.materials)
    for (auto* use :
         {&material.textures.reflectance, &material.textures.emittance, &material.textures.cutout}) {
      if (!*use) continue;
      const auto [place, is_new] =
          numbers.try_emplace((*use)->texture, static_cast<std::uint32_t>(scene.textures.size()));
      if (is_new) scene.textures.push_back(all[(*use)->texture]);
      (*use)->texture = place->second;
    }
}

}  // namespace luxel
