// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/sun_power.h"

#include <algorithm>

#include "luxel/core/address.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr std::uint32_t rays = 4;

// Area that the light meets at right angles, m².
double lit_area(const PatchSet& patches, const Tracer& tracer, const PointLight& light, SideId side) {
  const PatchEmitter emitter(patches, side);
  if (!(sight_of(light, Vec3d(0.0), Vec3d(emitter.normal())).irradiance > 0.0)) return 0.0;
  double sum = 0.0;
  for (std::uint32_t k = 0; k < rays; ++k) {
    const auto u =
        uniform4(stream_key(seed_of(RandomSeed::sun_power), 0, static_cast<std::uint32_t>(side.index())), k);
    const auto from = emitter.point(u[0], u[1]);
    const auto sight = sight_of(light, Vec3d(from), Vec3d(emitter.normal()));
    if (!tracer.occluded({from, Vec3(sight.direction)}, sight.distance)) sum += sight.irradiance;
  }
  return sum / rays * static_cast<double>(patches.area[side.patch()]);
}

}  // namespace

std::vector<double> sun_power(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  std::vector<double> power(patches.band_count(), 0.0);
  for (const auto& lamp : patches.point_lights) {
    if (lamp.light.kind != PointLightKind::directional) continue;
    const auto area = ordered_sum(context, patches.size(), [&](std::size_t p) {
      const auto patch = static_cast<std::uint32_t>(p);
      const auto front = lit_area(patches, tracer, lamp.light, SideId(patch, false));
      return patches.material_of(p).two_sided
                 ? front + lit_area(patches, tracer, lamp.light, SideId(patch, true))
                 : front;
    });
    for (std::size_t b = 0; b < power.size(); ++b) power[b] += area * static_cast<double>(lamp.intensity[b]);
  }
  return power;
}

}  // namespace luxel
