// SPDX-License-Identifier: Apache-2.0
#include "luxel/lightmap/lightmap.h"

#include "luxel/lightmap/footprint.h"

namespace luxel {

Vec3 look_up(const Image& page, const Vec2& at) {
  Vec3 sum(0.0f);
  const Footprint footprint(at, page.width);
  for (std::size_t i = 0; i < 4; ++i) sum += footprint.weight[i] * page.pixels[footprint.texel[i]];
  return sum;
}

}  // namespace luxel
