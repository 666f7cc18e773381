// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/lightmap.h"

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/render/footprint.h"

namespace luxel {

void check_is_of(const PatchSet& patches, const Lightmap& lightmap) {
  if (lightmap.atlas.chart_of.size() != side_count(patches.size()))
    throw MismatchError(
        fmt::format("the lightmap is of {} sides but the scene has {}: make it from this scene",
                    lightmap.atlas.chart_of.size(), side_count(patches.size())));
}

Vec3 look_up(const Image& page, const Vec2& at) {
  Vec3 sum(0.0f);
  const Footprint footprint(at, page.width);
  for (std::size_t i = 0; i < 4; ++i) sum += footprint.weight[i] * page.pixels[footprint.texel[i]];
  return sum;
}

}  // namespace luxel
