// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/light_paths.h"

#include <algorithm>
#include <numbers>

#include "luxel/core/address.h"
#include "luxel/core/warp.h"
#include "luxel/patch/check_light.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

double dot(const Vec3& a, const Vec3& b) { return glm::dot(Vec3d(a), Vec3d(b)); }

}  // namespace

LightPaths::LightPaths(const PatchSet& patches, const Tracer& tracer)
    : patches_(patches), tracer_(tracer), lamps_(patches) {
  check_light(patches);
}

// Calls add(direction, cosine, solid_angle, radiance) for the arriving light: the expected sum of solid_angle
// (sr) times radiance(band), W/(m² sr), is the integral of radiance over all that x sees.
template <typename Add>
LightPaths::Trail LightPaths::arriving(const SurfacePoint& x, const VertexNumbers& numbers, Rays spread,
                                       const Add& add) const {
  Trail trail;
  const auto of_lamp = [&](std::size_t patch) {
    return [this, patch](std::size_t b) {
      return static_cast<double>(patches_.emittance(patch, b)) / std::numbers::pi;
    };
  };
  // Densities per steradian: of the shadow ray (lamp sampling) and of the other ray.
  const auto lamp_density = [&](std::size_t patch, double distance, double cosine) {
    return lamps_.density(patches_, patch) * distance * distance / cosine;
  };
  const auto ray_density = [spread](double cosine) {
    const auto by_cosine = cosine / std::numbers::pi;
    return spread == Rays::by_cosine ? by_cosine : 0.5 * (by_cosine + 0.5 / std::numbers::pi);
  };

  // 1. Shadow ray to a lamp.
  if (lamps_.size() > 0) {
    const auto y = lamps_.sample(patches_, numbers.lamp);
    const auto way = Vec3d(y.position) - Vec3d(x.position);
    const auto distance = glm::length(way);
    const auto here = glm::dot(Vec3d(x.normal), way) / distance;
    const auto there = -glm::dot(Vec3d(y.normal), way) / distance;
    if (here > 0.0 && there > 0.0) {
      ++trail.rays;
      if (!tracer_.occluded({x.position, Vec3(way / distance)}, static_cast<float>(distance)))
        add(way / distance, here, 1.0 / (lamp_density(y.patch, distance, there) + ray_density(here)),
            of_lamp(y.patch));
    }
  }

  for (const auto& lamp : patches_.point_lights) {
    const auto sight = sight_of(lamp.light, Vec3d(x.position), Vec3d(x.normal));
    if (!(sight.irradiance > 0.0)) continue;
    ++trail.rays;
    if (tracer_.occluded({x.position, Vec3(sight.direction)}, sight.distance)) continue;
    const auto cosine = glm::dot(Vec3d(x.normal), Vec3d(sight.direction));
    add(Vec3d(sight.direction), cosine, sight.irradiance / cosine,
        [&](std::size_t b) { return static_cast<double>(lamp.intensity[b]); });
  }

  // 2. Cosine-distributed ray or, for light vectors, one of the mixture of cosine and uniform directions.
  auto [u, v] = numbers.direction;
  const bool is_even = spread == Rays::by_cosine_or_evenly && u >= 0.5f;
  if (spread == Rays::by_cosine_or_evenly) u = 2.0f * u - (is_even ? 1.0f : 0.0f);
  const auto local = is_even ? uniform_hemisphere(u, v) : cosine_hemisphere(u, v);
  const Ray ray{x.position, Frame(x.normal).to_world(local)};
  const auto cosine = static_cast<double>(local.z);
  const auto density = ray_density(cosine);
  ++trail.rays;
  trail.first = tracer_.nearest(ray);
  trail.direction = Vec3d(ray.direction);
  trail.cosine = cosine;
  trail.solid_angle = density > 0.0 ? 1.0 / density : 0.0;
  const auto& hit = trail.first;
  if (!hit)
    add(trail.direction, cosine, trail.solid_angle,
        [&](std::size_t b) { return patches_.sky_radiosity(b) / std::numbers::pi; });
  if (!hit || hit.back || !patches_.material_of(hit.patch).is_lamp()) return trail;
  const auto facing = -dot(patches_.normal[hit.patch], ray.direction);
  if (!(facing > 0.0)) return trail;
  add(trail.direction, cosine,
      1.0 / (lamp_density(hit.patch, static_cast<double>(hit.distance), facing) + density),
      of_lamp(hit.patch));
  return trail;
}

LightPaths::Trail LightPaths::direct(const SurfacePoint& x, const VertexNumbers& numbers,
                                     std::span<const double> weight, std::span<double> sum) const {
  return arriving(x, numbers, Rays::by_cosine,
                  [&](const Vec3d&, double cosine, double solid_angle, const auto& radiance) {
                    for (std::size_t b = 0; b < sum.size(); ++b)
                      sum[b] += weight[b] * solid_angle * cosine * radiance(b);
                  });
}

LightPaths::Trail LightPaths::light_vector(const SurfacePoint& x, const VertexNumbers& numbers,
                                           std::span<glm::dvec4> sum) const {
  return arriving(x, numbers, Rays::by_cosine_or_evenly,
                  [&](const Vec3d& direction, double cosine, double solid_angle, const auto& radiance) {
                    for (std::size_t b = 0; b < sum.size(); ++b)
                      sum[b] += solid_angle * radiance(b) * glm::dvec4(direction, cosine);
                  });
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

    // Russian roulette keeps the path's throughput in its brightest band at 1.
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
