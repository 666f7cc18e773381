// SPDX-License-Identifier: Apache-2.0
#include "luxel/reference/light_paths.h"

#include <algorithm>
#include <numbers>

#include "luxel/patch/check_light.h"
#include "luxel/random/address.h"
#include "luxel/random/warp.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

double dot(const Vec3& a, const Vec3& b) { return glm::dot(Vec3d(a), Vec3d(b)); }

}  // namespace

LightPaths::LightPaths(const PatchSet& patches, const Tracer& tracer)
    : patches_(patches), tracer_(tracer), lamps_(patches) {
  check_light(patches);
}

LightPaths::Trail LightPaths::direct(const SurfacePoint& x, const VertexNumbers& numbers,
                                     std::span<const double> weight, std::span<double> sum) const {
  Trail trail;
  // value: irradiance over the lamp's emittance.
  const auto add = [&](std::size_t patch, double value) {
    for (std::size_t b = 0; b < sum.size(); ++b)
      sum[b] += weight[b] * value * static_cast<double>(patches_.emittance(patch, b));
  };
  // Densities per steradian: of the shadow ray's direction, and of the cosine ray's.
  const auto lamp_density = [&](std::size_t patch, double distance, double cosine) {
    return lamps_.density(patches_, patch) * distance * distance / cosine;
  };
  const auto cosine_density = [](double cosine) { return cosine / std::numbers::pi; };

  // 1. To a lamp. Radiance is emittance / pi, so radiance * cosine = emittance * cosine_density.
  if (lamps_.size() > 0) {
    const auto y = lamps_.sample(patches_, numbers.lamp);
    const auto way = Vec3d(y.position) - Vec3d(x.position);
    const auto distance = glm::length(way);
    const auto here = glm::dot(Vec3d(x.normal), way) / distance;
    const auto there = -glm::dot(Vec3d(y.normal), way) / distance;
    if (here > 0.0 && there > 0.0) {
      ++trail.rays;
      if (!tracer_.occluded({x.position, Vec3(way / distance)}, static_cast<float>(distance)))
        add(y.patch, cosine_density(here) / (lamp_density(y.patch, distance, there) + cosine_density(here)));
    }
  }

  for (const auto& lamp : patches_.point_lights) {
    const auto sight = sight_of(lamp.light, Vec3d(x.position), Vec3d(x.normal));
    if (!(sight.irradiance > 0.0)) continue;
    ++trail.rays;
    if (tracer_.occluded({x.position, Vec3(sight.direction)}, sight.distance)) continue;
    for (std::size_t b = 0; b < sum.size(); ++b)
      sum[b] += weight[b] * sight.irradiance * static_cast<double>(lamp.intensity[b]);
  }

  // 2. Where the light goes that the surface itself would send.
  const auto local = cosine_hemisphere(numbers.direction[0], numbers.direction[1]);
  const Ray ray{x.position, Frame(x.normal).to_world(local)};
  ++trail.rays;
  trail.first = tracer_.nearest(ray);
  const auto& hit = trail.first;
  if (!hit)
    for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += weight[b] * patches_.sky_radiosity(b);
  if (!hit || hit.back || !patches_.material_of(hit.patch).is_lamp()) return trail;
  const auto facing = -dot(patches_.normal[hit.patch], ray.direction);
  if (!(facing > 0.0)) return trail;
  const auto density = cosine_density(static_cast<double>(local.z));
  add(hit.patch, density / (lamp_density(hit.patch, static_cast<double>(hit.distance), facing) + density));
  return trail;
}

LightPaths::Trail LightPaths::irradiance(const SurfacePoint& x, const VertexNumbers& first, std::uint64_t key,
                                         BouncesFrom from, std::span<double> weight,
                                         std::span<double> sum) const {
  std::fill(weight.begin(), weight.end(), 1.0);
  auto whole = direct(x, first, weight, sum);
  auto hit = whole.first;
  for (std::uint64_t vertex = 0; hit && is_reflecting(patches_, hit.patch, hit.back); ++vertex) {
    const auto u = uniform4(key, 2 * vertex);
    const auto v = uniform4(key, 2 * vertex + 1);

    // Roulette keeps what a path carries, in its brightest band, at one.
    for (std::size_t b = 0; b < weight.size(); ++b)
      weight[b] *= static_cast<double>(patches_.reflectance(hit.patch, b));
    const auto survival = std::min(1.0, *std::max_element(weight.begin(), weight.end()));
    if (!(static_cast<double>(u[0]) < survival)) break;
    for (auto& w : weight) w /= survival;

    const auto at = from == BouncesFrom::points ? Vec2(hit.u, hit.v) : uniform_triangle(v[2], v[3]);
    const auto trail = direct(surface_point(patches_, hit.patch, hit.back, at),
                              {{v[0], v[1]}, {u[1], u[2], u[3]}}, weight, sum);
    whole.rays += trail.rays;
    hit = trail.first;
  }
  return whole;
}

}  // namespace luxel
