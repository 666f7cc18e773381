// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/sun_light.h"

#include <algorithm>
#include <bit>
#include <numbers>

#include "luxel/core/address.h"
#include "luxel/core/sobol.h"
#include "luxel/trace/panes.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr std::size_t hours_at_a_time = 16;
constexpr std::size_t hours_per_poll = 512;

PointLight disc() {
  PointLight sun;
  sun.kind = PointLightKind::directional;
  sun.angular_radius = static_cast<float>(0.5 * sun_diameter * std::numbers::pi / 180.0);
  return sun;
}

}  // namespace

SunLight::SunLight(const YearSkies& skies, std::span<const ProbePoint> points, const SunSurroundings& around,
                   std::span<const PatchSet> dark, const Context& context) {
  const Panes panes(around.patches);
  std::vector<Panes> without;
  for (const auto& patches : dark) without.emplace_back(patches);
  const auto& hours = skies.hours;
  all_.assign(hours.size() * points.size(), 0.0f);
  arrived_.assign(all_.size(), 0);
  through_.assign(without.size(), all_);
  const auto seed = nth_key(around.seed, seed_of(RandomSeed::sun_power));
  // `at`: hour * points + point.
  const auto trace = [&](const PointLight& sun, double illuminance, const ProbePoint& point, std::size_t at,
                         const OwenSobol& random) {
    for (std::uint32_t r = 0; r < rays; ++r) {
      const auto sight =
          sight_of(sun, Vec3d(point.position), Vec3d(point.normal),
                   {static_cast<double>(random.at(r, 0)), static_cast<double>(random.at(r, 1))});
      const Ray ray{point.position, Vec3(sight.direction)};
      if (!(sight.irradiance > 0.0) || around.tracer.occluded(ray, sight.distance)) continue;
      const auto arriving = [&](const Panes& glass) {
        return static_cast<float>(glass.luminous(glass.along(ray, sight.distance)) * sight.irradiance *
                                  illuminance / double{rays});
      };
      const auto lux = arriving(panes);
      arrived_[at] |= static_cast<std::uint8_t>(1u << r);
      all_[at] += lux;
      for (std::size_t g = 0; g < without.size(); ++g) through_[g][at] += lux - arriving(without[g]);
    }
  };
  for (std::size_t first = 0; first < hours.size(); first += hours_per_poll) {
    const auto done = static_cast<double>(first) / static_cast<double>(hours.size());
    if (context.report({"sun", done, rays * first * points.size()}) == Next::stop) {
      is_stopped_ = true;
      return;
    }
    const auto count = std::min(hours_per_poll, hours.size() - first);
    context.for_chunks(count, hours_at_a_time, [&](std::size_t begin, std::size_t end, int) {
      auto sun = disc();
      for (auto h = first + begin; h < first + end; ++h) {
        if (!(hours[h].sun_illuminance > 0.0)) continue;
        sun.direction = Vec3(-skies.patches.in_scene_axes(hours[h].sun.direction));
        for (std::size_t m = 0; m < points.size(); ++m)
          trace(sun, hours[h].sun_illuminance, points[m], h * points.size() + m,
                OwenSobol(stream_key(seed, static_cast<std::uint32_t>(h), static_cast<std::uint32_t>(m))));
      }
    });
  }
}

std::vector<float> SunLight::without(const std::vector<float>& light, std::uint32_t replicates,
                                     std::uint32_t left_out) const {
  std::uint8_t kept = 0;
  for (std::uint32_t r = 0; r < rays; ++r)
    if (r % replicates != left_out) kept |= static_cast<std::uint8_t>(1u << r);
  auto rest = light;
  if (kept == 0) return rest;
  const auto more = static_cast<float>(rays) / static_cast<float>(std::popcount(kept));
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (arrived_[i] == 0) continue;
    const auto part = std::popcount(static_cast<std::uint8_t>(arrived_[i] & kept));
    rest[i] *= more * static_cast<float>(part) / static_cast<float>(std::popcount(arrived_[i]));
  }
  return rest;
}

}  // namespace luxel
