// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/one_way_sides.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/address.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {
namespace {

constexpr std::uint32_t purpose = 0x6f6e6577u;  // keeps these points apart from those of other stages
constexpr std::uint32_t probes = 4;      // per side: nineteen in twenty of those half covered are found
constexpr float min_height = 8.0f;       // of a triangle, in lifts of an origin
constexpr float probe_length = 8.0f;     // likewise
constexpr float probe_fraction = 1e-3f;  // of the root of the area, if that is longer
constexpr std::size_t grain = 256;       // sides per chunk

bool is_sliver(const std::array<Vec3, 3>& p, float area, float lift) {
  const auto longest =
      std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
  return 2.0f * area < min_height * lift * longest;
}

}  // namespace

std::vector<std::uint8_t> one_way_sides(const PatchSet& patches, const GatherSides& sides,
                                        const Tracer& tracer, const Workers& workers) {
  std::vector<std::uint8_t> one_way(sides.size(), 0);
  workers.for_chunks(sides.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto s = begin; s < end; ++s) {
      const auto side = sides.side[s];
      const auto patch = side / 2;
      const auto points = patches.points(patch);
      const auto lift = origin_lift(points);
      if (patches.material_of(patch).textures.cutout || is_sliver(points, patches.area[patch], lift)) {
        one_way[s] = 1;
        continue;
      }
      const PatchEmitter emitter(patches, side);
      const auto length = std::max(probe_length * lift, probe_fraction * std::sqrt(patches.area[patch]));
      for (std::uint32_t i = 0; i < probes && one_way[s] == 0; ++i) {
        const auto ray = emitter.ray(uniform4(stream_key(0, purpose, side), i));
        const auto hit = tracer.nearest({ray.origin + length * ray.direction, -ray.direction});
        if (hit && hit.patch == patch && hit.back == (side % 2 == 1)) continue;
        one_way[s] = 1;
      }
    }
  });
  return one_way;
}

}  // namespace luxel
