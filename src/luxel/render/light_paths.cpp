// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/light_paths.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <span>

#include "luxel/core/address.h"
#include "luxel/core/warp.h"
#include "luxel/lamps/punctual_choices.h"
#include "luxel/patch/check_light.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr std::uint64_t scatter_numbers = std::uint64_t{1} << 40;  // behind those of all vertices of a path

double dot(const Vec3& a, const Vec3& b) { return glm::dot(Vec3d(a), Vec3d(b)); }

// Probability density per steradian of the ray that samples directions, not lamps. is_cosine: all rays are
// by the cosine, else half of them are spread evenly.
double ray_density(bool is_cosine, double cosine) {
  const auto by_cosine = cosine / std::numbers::pi;
  return is_cosine ? by_cosine : 0.5 * (by_cosine + 0.5 / std::numbers::pi);
}

}  // namespace

LightPaths::LightPaths(const PatchSet& patches, const Tracer& tracer)
    : patches_(patches),
      tracer_(tracer),
      lamps_(patches),
      portals_(patches, tracer),
      punctual_(patches),
      panes_(patches) {
  check_light(patches);
}

// Each light by itself where they are few; else one of them, chosen by its irradiance.
template <typename Add>
void LightPaths::add_punctual(const SurfacePoint& x, const VertexNumbers& numbers, Trail& trail,
                              const Add& add) const {
  const auto [u, v, w] = numbers.lamp;
  const std::array<double, 2> opening = {static_cast<double>(v), static_cast<double>(w)};
  const auto add_seen = [&](std::uint32_t light, const PointSight& sight, double given) {
    if (!(given > 0.0)) return;
    ++trail.rays;
    const Ray ray{x.position, Vec3(sight.direction)};
    if (tracer_.occluded(ray, sight.distance)) return;
    const auto through = panes_.along(ray, sight.distance);
    const auto cosine = glm::dot(Vec3d(x.normal), sight.direction);
    add(sight.direction, cosine, given / cosine, [&](std::size_t b) {
      return in_band(through, b) * static_cast<double>(patches_.point_lights[light].intensity[b]);
    });
  };
  const Vec3d position(x.position), normal(x.normal);
  const auto add_each = [&](std::span<const std::uint32_t> lights) {
    for (const auto i : lights) {
      const auto sight = sight_of(patches_.point_lights[i].light, position, normal, opening);
      add_seen(i, sight, sight.irradiance);
    }
  };
  add_each(punctual_.suns);
  if (punctual_.chosen.size() <= PunctualChoices::max_near) return add_each(punctual_.chosen);
  thread_local PunctualChoices choices;
  choices.make(patches_.point_lights, punctual_.weights, punctual_.chosen, {position, 0.0, normal});
  if (choices.empty()) return;
  const auto sample = choices.sample(position, normal, static_cast<double>(u), opening);
  add_seen(sample.light, sample.sight, sample.given);
}

// The ray to a portal, where it meets the sky.
template <typename Add>
void LightPaths::add_sky(const SurfacePoint& x, const VertexNumbers& numbers, Rays spread, Trail& trail,
                         const Add& add) const {
  const auto ray = portals_.sample(x.position, numbers.lamp);
  if (!ray) return;
  const auto cosine = dot(x.normal, ray->direction);
  if (!(cosine > 0.0)) return;
  ++trail.rays;
  const auto no_end = std::numeric_limits<float>::infinity();
  if (tracer_.occluded(*ray, no_end)) return;
  const auto through = panes_.along(*ray, no_end);
  const auto sky_patch = patches_.sky_patches.patch_of(Vec3d(ray->direction));
  add(Vec3d(ray->direction), cosine,
      1.0 / (portals_.density(*ray) + ray_density(spread == Rays::by_cosine, cosine)), [&](std::size_t b) {
        return in_band(through, b) * patches_.sky_radiosity(sky_patch, b) / std::numbers::pi;
      });
}

// Calls add(direction, cosine, solid_angle, radiance) for the arriving light: the expected sum of solid_angle
// (sr) times radiance(band), W/(m² sr), is the integral of radiance over all that x sees.
template <typename Add>
LightPaths::Trail LightPaths::arriving(const SurfacePoint& x, const VertexNumbers& numbers, Rays spread,
                                       const Add& add) const {
  Trail trail;
  const auto of_lamp = [&](std::size_t patch, std::span<const double> through) {
    return [this, patch, through](std::size_t b) {
      return in_band(through, b) * static_cast<double>(patches_.emittance(patch, b)) / std::numbers::pi;
    };
  };
  // Density per steradian of the shadow ray (lamp sampling).
  const auto lamp_density = [&](std::size_t patch, double distance, double cosine) {
    return lamps_.density(patches_, patch) * distance * distance / cosine;
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
      const Ray ray{x.position, Vec3(way / distance)};
      if (!tracer_.occluded(ray, static_cast<float>(distance)))
        add(way / distance, here,
            1.0 / (lamp_density(y.patch, distance, there) + ray_density(spread == Rays::by_cosine, here)),
            of_lamp(y.patch, panes_.along(ray, static_cast<float>(distance))));
    }
  }

  if (!patches_.point_lights.empty()) add_punctual(x, numbers, trail, add);
  const bool aims_at_sky = !portals_.empty() && patches_.has_sky();
  if (aims_at_sky) add_sky(x, numbers, spread, trail, add);

  // 2. Cosine-distributed ray or, for light vectors, one of the mixture of cosine and uniform directions.
  auto [u, v] = numbers.direction;
  const bool is_even = spread == Rays::by_cosine_or_evenly && u >= 0.5f;
  if (spread == Rays::by_cosine_or_evenly) u = 2.0f * u - (is_even ? 1.0f : 0.0f);
  const auto local = is_even ? uniform_hemisphere(u, v) : cosine_hemisphere(u, v);
  const Ray ray{x.position, Frame(x.normal).to_world(local)};
  const auto cosine = static_cast<double>(local.z);
  const auto density = ray_density(spread == Rays::by_cosine, cosine);
  ++trail.rays;
  trail.first = tracer_.nearest(ray);
  trail.direction = Vec3d(ray.direction);
  trail.cosine = cosine;
  trail.solid_angle = density > 0.0 ? 1.0 / density : 0.0;
  const auto& hit = trail.first;
  if (const auto through = panes_.along(ray, hit.distance); !through.empty())
    trail.through.assign(through.begin(), through.end());
  if (!hit) {
    const auto sky_patch = patches_.sky_patches.patch_of(trail.direction);
    const auto aimed = aims_at_sky ? portals_.density(ray) : 0.0;
    const auto solid_angle = density > 0.0 ? 1.0 / (aimed + density) : 0.0;
    add(trail.direction, cosine, solid_angle, [&](std::size_t b) {
      return in_band(trail.through, b) * patches_.sky_radiosity(sky_patch, b) / std::numbers::pi;
    });
  }
  if (!hit || hit.back || !patches_.material_of(hit.patch).is_lamp()) return trail;
  const auto facing = -dot(patches_.normal[hit.patch], ray.direction);
  if (!(facing > 0.0)) return trail;
  add(trail.direction, cosine,
      1.0 / (lamp_density(hit.patch, static_cast<double>(hit.distance), facing) + density),
      of_lamp(hit.patch, trail.through));
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

// Multiplies the path's weight by what the surface reflects or, of a diffuser, by what it transmits.
// Diffusers do one of the two, chosen in proportion to the light. Returns the side from which the path
// continues.
SideId LightPaths::scatter(const Hit& hit, float u, std::span<double> weight) const {
  const auto rho = [&](std::size_t b) { return static_cast<double>(patches_.reflectance(hit.patch, b)); };
  const auto tau = [&](std::size_t b) {
    return static_cast<double>(patches_.diffuse_transmittance(hit.patch, b));
  };
  double transmitted = 0.0, whole = 0.0;
  if (patches_.material_of(hit.patch).is_diffuser())
    for (std::size_t b = 0; b < weight.size(); ++b) {
      transmitted += weight[b] * tau(b);
      whole += weight[b] * (rho(b) + tau(b));
    }
  const auto chance = whole > 0.0 ? transmitted / whole : 0.0;
  const bool passes = static_cast<double>(u) < chance;
  for (std::size_t b = 0; b < weight.size(); ++b)
    weight[b] *= passes ? tau(b) / chance : chance > 0.0 ? rho(b) / (1.0 - chance) : rho(b);
  return passes ? hit.side().opposite() : hit.side();
}

LightPaths::Trail LightPaths::irradiance(const SurfacePoint& x, const VertexNumbers& first, std::uint64_t key,
                                         BouncesFrom from, std::span<double> weight,
                                         std::span<double> sum) const {
  std::fill(weight.begin(), weight.end(), 1.0);
  auto whole = direct(x, first, weight, sum);
  auto hit = whole.first;
  for (std::size_t b = 0; b < whole.through.size(); ++b) weight[b] *= whole.through[b];
  for (std::uint64_t vertex = 0; hit && is_reflecting(patches_, hit.patch, hit.back); ++vertex) {
    const auto u = uniform4(key, 2 * vertex);
    const auto v = uniform4(key, 2 * vertex + 1);

    const auto side = scatter(hit, uniform4(key, scatter_numbers + vertex)[0], weight);
    // Russian roulette keeps the path's throughput in its brightest band at 1.
    const auto survival = std::min(1.0, *std::max_element(weight.begin(), weight.end()));
    if (!(static_cast<double>(u[0]) < survival)) break;
    for (auto& w : weight) w /= survival;

    const auto at = from == BouncesFrom::points ? Vec2(hit.u, hit.v) : uniform_triangle(v[2], v[3]);
    const auto trail = direct(surface_point(patches_, side.patch(), side.is_back(), at),
                              {{v[0], v[1]}, {u[1], u[2], u[3]}}, weight, sum);
    whole.rays += trail.rays;
    hit = trail.first;
    for (std::size_t b = 0; b < trail.through.size(); ++b) weight[b] *= trail.through[b];
  }
  return whole;
}

}  // namespace luxel
