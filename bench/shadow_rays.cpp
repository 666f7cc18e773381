// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "luxel/lamps/direct_light.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"

#include "bench/mesher.h"
#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

constexpr Vec3 size{14.0f, 3.2f, 8.0f};  // of the room, m
constexpr float away = 0.13f;            // lamps from walls, m: 2 cm between shade and wall

// Quads between rings about a vertical axis: rings[i] is (radius, height). Fronts look outwards where heights
// rise.
void turn(Mesher& mesher, const Vec3& at, const std::vector<Vec2>& rings, int columns) {
  const auto point = [&](const Vec2& ring, int column) {
    const auto angle = -2.0f * pi * static_cast<float>(column % columns) / static_cast<float>(columns);
    return at + Vec3(ring.x * std::cos(angle), ring.y, ring.x * std::sin(angle));
  };
  for (std::size_t i = 0; i + 1 < rings.size(); ++i)
    for (int k = 0; k < columns; ++k)
      mesher.quad(point(rings[i], k), point(rings[i], k + 1), point(rings[i + 1], k + 1),
                  point(rings[i + 1], k));
}

// A bulb of 2 * rings * columns triangles, open at the poles, in a shade open above and below.
void add_lamp(Mesher& mesher, const Vec3& at, int rings, int columns) {
  std::vector<Vec2> profile;
  for (int i = 0; i <= rings; ++i) {
    const auto angle = pi * (0.05f + 0.9f * static_cast<float>(i) / static_cast<float>(rings));
    profile.emplace_back(0.035f * std::sin(angle), -0.035f * std::cos(angle));
  }
  mesher.material("bulb", Vec3(0.0f), pi * Vec3(900.0f, 700.0f, 400.0f));
  turn(mesher, at, profile, columns);
  mesher.material("shade", Vec3(0.75f));
  turn(mesher, at - Vec3(0.0f, 0.1f, 0.0f), {Vec2{0.11f, 0.0f}, Vec2{0.07f, 0.2f}}, 40);
}

// Forty lamps along the walls of an empty room.
Scene room_with_bulbs(int rings, int columns) {
  Mesher mesher(0.2f);
  mesher.material("room", Vec3(0.7f));
  mesher.box(Vec3(0.0f), size, true);
  const auto add = [&](float at_x, float at_z) { add_lamp(mesher, {at_x, 1.9f, at_z}, rings, columns); };
  for (int k = 0; k < 13; ++k)
    for (const float wall : {away, size.z - away}) add(0.75f + 1.04f * static_cast<float>(k), wall);
  for (int k = 0; k < 7; ++k)
    for (const float wall : {away, size.x - away}) add(wall, 0.7f + 1.1f * static_cast<float>(k));
  return mesher.take();
}

struct ShadowRays {
  double nanoseconds = 0.0;   // of processor time, per ray
  double relative_rms = 0.0;  // of the light of one patch of the room, over area
};

ShadowRays shadow_rays(const PatchSet& patches, std::uint32_t per_replicate) {
  const Tracer tracer(patches, Context(1));
  const Lamps lamps(patches);
  const DirectOptions options;
  const DirectLight direct(patches, tracer, lamps, options);
  std::vector<float> out(options.replicates * patches.band_count());
  double variance = 0.0, square = 0.0;
  std::uint64_t rays = 0;
  const auto spent = cost([&] {
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (patches.material_of(p).name != "room") continue;
      rays += direct.estimate(SideId(p, false), static_cast<std::uint32_t>(p), 0, per_replicate, out);
      double sum = 0.0, sum2 = 0.0;
      for (std::uint32_t r = 0; r < options.replicates; ++r) {
        const double value = out[r * patches.band_count()];
        sum += value;
        sum2 += value * value;
      }
      const double n = options.replicates, mean = sum / n;
      variance += patches.area[p] * (sum2 / n - mean * mean) / (n - 1.0);
      square += patches.area[p] * mean * mean;
    }
  });
  return {1e9 * spent.cpu / static_cast<double>(rays), std::sqrt(variance / square)};
}

}  // namespace

Json against_facets(const Settings& settings) {
  fmt::print("\nfacets: shadow rays to forty shaded bulbs of few triangles and of many\n");
  fmt::print("{:>10} {:>12} {:>16}\n", "triangles", "ns a ray", "relative RMS, %");
  Json rows = Json::array();
  for (const auto& [rings, columns] : {std::pair{1, 4}, std::pair{2, 5}, std::pair{20, 25}}) {
    const auto patches = make_patches(room_with_bulbs(rings, columns), {.max_edge = no_max_edge});
    const auto found = shadow_rays(patches, settings.small ? 1 : 16);
    fmt::print("{:>10} {:>12.0f} {:>16.2f}\n", 2 * rings * columns, found.nanoseconds,
               100.0 * found.relative_rms);
    rows.push_back({{"triangles", 2 * rings * columns},
                    {"nanoseconds", found.nanoseconds},
                    {"relative_rms", found.relative_rms}});
  }
  return rows;
}

}  // namespace luxel::bench
