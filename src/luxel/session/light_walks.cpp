// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/light_walks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "luxel/core/address.h"
#include "luxel/core/bounds.h"
#include "luxel/core/sobol.h"
#include "luxel/core/warp.h"
#include "luxel/patch/side.h"
#include "luxel/session/lamp_by_power.h"
#include "luxel/session/walk.h"
#include "luxel/trace/start_sides.h"

namespace luxel {
namespace {

constexpr int max_bounces = 16;
constexpr float near_fraction = 0.03f;  // of the diagonal
constexpr double too_faint = 0.002;     // of the emitted power

struct Path {
  double escaped = 0.0, escaped_at_once = 0.0, lost = 0.0;
  std::uint32_t hits = 0, backs = 0;
  std::array<SideId, max_bounces + 1> met{};  // one side per hit
  float reach = 0.0f;
  std::uint32_t lamp = 0, back_material = 0;  // materials
  Ray last;
};

// Mean of a reflectance or transmittance for white light, or of all wavebands equally.
double fraction(const PatchSet& patches, const std::vector<float>& of) {
  if (of.empty()) return 0.0;
  if (patches.wavebands.empty()) return static_cast<double>(luminance({of[0], of[1], of[2]}));
  return std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(of.size());
}

Path from_lamp(const PatchSet& patches, const Tracer& tracer, const LampByPower& lamps, std::size_t i,
               std::size_t paths, std::uint64_t seed) {
  Path path;
  double weight = 1.0;
  auto side = lamps.at((static_cast<double>(i) + 0.5) / static_cast<double>(paths));
  bool back = false;
  path.lamp = static_cast<std::uint32_t>(patches.material[side]);
  const auto u0 = uniform4({seed, step_of(RandomPurpose::walks), 0, i});
  auto weights = uniform_triangle(u0[0], u0[1]);
  auto ray = ray_from_side(patches, SideId(side, back), weights, u0[2], u0[3]);
  const auto start = ray.origin;
  for (int b = 0;; ++b) {
    const auto hit = tracer.nearest(ray);
    if (!hit) {
      path.escaped = weight;
      if (b == 0) path.escaped_at_once = weight;
      path.reach = std::numeric_limits<float>::infinity();
      path.last = ray;
      break;
    }
    path.reach = std::max(path.reach, glm::distance(start, ray.origin + hit.distance * ray.direction));
    path.met[path.hits++] = hit.side();
    path.backs += hit.back ? 1 : 0;
    const auto& material = patches.material_of(hit.patch);
    if (hit.back && !material.two_sided) {
      path.lost = weight;
      path.back_material = static_cast<std::uint32_t>(patches.material[hit.patch]);
      break;
    }
    const auto transmitted = fraction(patches, material.diffuse_transmittance);
    const auto albedo = fraction(patches, material.reflectance) + transmitted;
    weight *= albedo;
    if (weight < too_faint || b == max_bounces) break;
    side = hit.patch;
    weights = {hit.u, hit.v};
    const auto u = uniform4({seed, step_of(RandomPurpose::walks, 1 + static_cast<std::uint32_t>(b)), 0, i});
    back = hit.back != (static_cast<double>(u[0]) * albedo < transmitted);
    ray = ray_from_side(patches, SideId(side, back), weights, u[2], u[3]);
  }
  return path;
}

// Uniform over the sphere (Archimedes; Marsaglia 1972).
Vec3 any_direction(float u1, float u2) {
  const auto d = concentric_disk(u1, u2);
  const auto r2 = glm::dot(d, d);
  const auto s = 2.0f * std::sqrt(std::max(0.0f, 1.0f - r2));
  return glm::normalize(Vec3(s * d.x, s * d.y, 1.0f - 2.0f * r2));
}

// Points of the box from which most directions meet a surface, but none right in front of the eye: inside
// rooms, not tables.
std::vector<Vec3> points_inside(const PatchSet& patches, const Tracer& tracer, std::uint64_t seed,
                                const Context& context) {
  constexpr std::size_t candidates = 1024;
  constexpr std::uint32_t looks = 64;
  constexpr float most = 0.7f;    // of the directions
  constexpr float roomy = 0.04f;  // of the box's diagonal
  Bounds box;
  for (const auto& p : patches.vertices) box.add(p);
  const OwenSobol points(stream_key(seed, RandomPurpose::walks, 1));
  std::vector<std::uint8_t> is_inside(candidates, 0);
  const auto place = [&](std::size_t i) {
    const auto u = points.first4(static_cast<std::uint32_t>(i));
    return box.low + Vec3(u[0], u[1], u[2]) * box.size();
  };
  context.for_chunks(candidates, 16, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) {
      const OwenSobol directions(
          stream_key(seed, step_of(RandomPurpose::walks, 1), static_cast<std::uint32_t>(i)));
      std::uint32_t hits = 0;
      float way = 0.0f;
      for (std::uint32_t k = 0; k < looks; ++k) {
        const auto hit = tracer.nearest({place(i), any_direction(directions.at(k, 0), directions.at(k, 1))});
        if (!hit) continue;
        ++hits;
        way += hit.distance;
      }
      is_inside[i] = static_cast<float>(hits) >= most * looks &&
                     way >= roomy * glm::length(box.size()) * static_cast<float>(hits);
    }
  });
  std::vector<Vec3> inside;
  for (std::size_t i = 0; i < candidates; ++i)
    if (is_inside[i] != 0) inside.push_back(place(i));
  return inside;
}

Path from_inside(const Tracer& tracer, const std::vector<Vec3>& inside, std::size_t i, std::uint64_t seed) {
  Path path;
  const auto u = uniform4({seed, step_of(RandomPurpose::walks), 2, i});
  const Ray ray{inside[i % inside.size()], any_direction(u[0], u[1])};
  const auto hit = tracer.nearest(ray);
  path.hits = hit ? 1 : 0;
  path.backs = hit && hit.back ? 1 : 0;
  if (hit) return path;
  path.escaped = path.escaped_at_once = 1.0;
  path.last = ray;
  return path;
}

// Sums in the order of paths.
void add_up(const std::vector<Path>& paths, LightWalks& walks) {
  const auto n = static_cast<double>(paths.size());
  double squares = 0.0;
  std::uint64_t hits = 0;
  std::uint64_t backs = 0;
  for (const auto& path : paths) {
    walks.escaped += path.escaped / n;
    squares += path.escaped * path.escaped / n;
    walks.escaped_at_once += path.escaped_at_once / n;
    walks.lost_at_backs += path.lost / n;
    hits += path.hits;
    backs += path.backs;
    if (path.escaped > 0.0) walks.lost.push_back({path.last, path.escaped / n});
    if (path.lost > 0.0) walks.back_loss[path.back_material] += path.lost / n;
    if (walks.from != LightWalks::From::lamps) continue;
    ++walks.set_out[path.lamp];
    for (std::uint32_t i = 0; i < path.hits; ++i) walks.is_met[path.met[i].index()] = 1;
    if (path.reach > walks.near) ++walks.got_away[path.lamp];
  }
  walks.rays = hits + walks.lost.size();
  walks.paths = paths.size();
  walks.back_hits = hits > 0 ? static_cast<double>(backs) / static_cast<double>(hits) : 0.0;
  walks.escaped_error = std::sqrt(std::max(0.0, squares - walks.escaped * walks.escaped) / n);
}

}  // namespace

LightWalks walk_light(const PatchSet& patches, const Tracer& tracer, std::size_t paths, std::uint64_t seed,
                      const Context& context) {
  LightWalks walks;
  walks.back_loss.assign(patches.materials.size(), 0.0);
  walks.got_away.assign(patches.materials.size(), 0);
  Bounds box;
  for (const auto& p : patches.vertices) box.add(p);
  walks.near = near_fraction * glm::length(box.size());
  walks.set_out.assign(patches.materials.size(), 0);
  walks.is_met.assign(side_count(patches.size()), 0);
  const LampByPower lamps(patches);
  const auto inside = lamps.empty() ? points_inside(patches, tracer, seed, context) : std::vector<Vec3>();
  if (lamps.empty() && inside.empty()) return walks;
  walks.from = lamps.empty() ? LightWalks::From::inside : LightWalks::From::lamps;
  std::vector<Path> all(paths);
  constexpr std::size_t at_a_time = 4096;
  for (std::size_t begin = 0; begin < paths; begin += at_a_time) {
    if (context.report({.stage = "light paths",
                        .done = static_cast<double>(begin) / static_cast<double>(paths)}) == Next::stop) {
      all.resize(begin);
      break;
    }
    const auto count = std::min(at_a_time, paths - begin);
    context.for_chunks(count, 64, [&](std::size_t first, std::size_t last, int) {
      for (auto i = begin + first; i < begin + last; ++i)
        all[i] = lamps.empty() ? from_inside(tracer, inside, i, seed)
                               : from_lamp(patches, tracer, lamps, i, paths, seed);
    });
  }
  if (!all.empty()) add_up(all, walks);
  return walks;
}

}  // namespace luxel
