// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/sun_power.h"

#include <span>

#include "luxel/core/address.h"
#include "luxel/patch/side.h"
#include "luxel/trace/panes.h"
#include "luxel/trace/patch_emitter.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr std::uint32_t rays = 4;
constexpr std::size_t grain = 4096;  // patches per chunk

// What the rays to a sun meet.
struct SunSight {
  const PointLight& light;
  const Tracer& tracer;
  const Panes& panes;
};

// Area that the light meets at right angles, times what panes let through: adds m² to area, [band].
void add_lit_area(const PatchSet& patches, const SunSight& sun, SideId side, std::span<double> area) {
  const PatchEmitter emitter(patches, side);
  if (!(sight_of(sun.light, Vec3d(0.0), Vec3d(emitter.normal())).irradiance > 0.0)) return;
  const auto of_ray = static_cast<double>(patches.area[side.patch()]) / rays;
  for (std::uint32_t k = 0; k < rays; ++k) {
    const auto u =
        uniform4(stream_key(seed_of(RandomSeed::sun_power), 0, static_cast<std::uint32_t>(side.index())), k);
    const auto from = emitter.point(u[0], u[1]);
    const auto sight = sight_of(sun.light, Vec3d(from), Vec3d(emitter.normal()));
    const Ray ray{from, Vec3(sight.direction)};
    if (sun.tracer.occluded(ray, sight.distance)) continue;
    const auto through = sun.panes.along(ray, sight.distance);
    for (std::size_t b = 0; b < area.size(); ++b) area[b] += of_ray * sight.irradiance * in_band(through, b);
  }
}

}  // namespace

std::vector<double> sun_power(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  const auto bands = patches.band_count();
  std::vector<double> power(bands, 0.0);
  const Panes panes(patches);
  for (const auto& lamp : patches.point_lights) {
    if (lamp.light.kind != PointLightKind::directional) continue;
    std::vector<double> area((patches.size() + grain - 1) / grain * bands, 0.0);  // m², [chunk][band]
    context.for_chunks(patches.size(), grain, [&](std::size_t begin, std::size_t end, int) {
      const auto of_chunk = std::span(area).subspan(begin / grain * bands, bands);
      for (auto p = static_cast<std::uint32_t>(begin); p < end; ++p) {
        add_lit_area(patches, {lamp.light, tracer, panes}, SideId(p, false), of_chunk);
        if (patches.material_of(p).two_sided)
          add_lit_area(patches, {lamp.light, tracer, panes}, SideId(p, true), of_chunk);
      }
    });
    for (std::size_t i = 0; i < area.size(); ++i)
      power[i % bands] += area[i] * static_cast<double>(lamp.intensity[i % bands]);
  }
  return power;
}

}  // namespace luxel
