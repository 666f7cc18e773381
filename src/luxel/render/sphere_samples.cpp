// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/sphere_samples.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "luxel/core/address.h"
#include "luxel/core/warp.h"
#include "luxel/render/doubled_samples.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr auto replicates = gather_replicates;

constexpr std::array<std::array<float, 3>, 6> axes = {
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

Vec3 axis_of(std::size_t face) { return {axes[face][0], axes[face][1], axes[face][2]}; }

// The face of a cube that a direction from its centre passes. Its cosine with the axis of the face is at
// least 1 / sqrt 3.
std::size_t face_of(const Vec3d& d) {
  const auto a = glm::abs(d);
  const std::size_t axis = a.x >= a.y && a.x >= a.z ? 0 : (a.y >= a.z ? 1 : 2);
  return 2 * axis + (d[static_cast<int>(axis)] < 0.0 ? 1 : 0);
}

Ray even_ray(const Vec3& from, float u, float v) {
  const bool below = u >= 0.5f;
  auto direction = uniform_hemisphere(2.0f * u - (below ? 1.0f : 0.0f), v);
  if (below) direction.z = -direction.z;
  return {from, direction};
}

}  // namespace

SphereSamples::SphereSamples(const SolutionProbe& probe, const ProbePoint& point, std::size_t count,
                             Weights weights, std::uint64_t key, bool has_errors)
    : probe_(probe),
      origin_(probe.place(point).rays),
      count_(count),
      weights_of_(std::move(weights)),
      key_(key),
      has_errors_(has_errors),
      bands_(probe.solved().bands()),
      sums_(replicates * bands_ * count, 0.0),
      punctual_(bands_ * count, 0.0),
      errors_(has_errors ? count * probe.solved().error_sums() : 0, 0.0),
      radiosity_(bands_),
      weights_(count) {
  const auto& rays = probe.lamp_rays();
  const auto& at = origin_.position;
  for (std::size_t f = 0; f < axes.size(); ++f)
    choices_[f].make(rays.lamps(), rays.tree(), {at, at, at}, axis_of(f),
                     {.most = LampChoices::few_lamps, .closed_form = true});
  trace_punctual();
  choose_openings();
}

void SphereSamples::sample(std::uint32_t r, std::uint32_t i) {
  const auto sum = std::span(sums_).subspan(r * bands_ * count_, bands_ * count_);
  for (std::size_t f = 0; f < axes.size(); ++f)
    if (!choices_[f].empty())
      sample_lamps(f, OwenSobol(nth_key(key_, axes.size() * r + f + replicates)), i, sum);
  for (std::size_t f = 0; f < axes.size(); ++f)
    if (!openings_[f].empty())
      sample_openings(f, OwenSobol(nth_key(key_, axes.size() * (r + replicates) + f + replicates)), i, sum);
  const OwenSobol points(nth_key(key_, r));
  const auto ray = even_ray(origin_.position, points.at(i, 0), points.at(i, 1));
  ++rays_;
  ++even_rays_;
  std::fill(radiosity_.begin(), radiosity_.end(), 0.0);
  const auto hit = probe_.tracer().nearest(ray);
  constexpr double solid_angle = 4.0;  // 4 pi sr / pi: of radiosity
  const auto through = probe_.add_arriving(ray, hit, solid_angle, radiosity_);
  add(Vec3d(ray.direction), radiosity_, 1.0, sum);
  if (!has_errors_) return;
  const auto width = probe_.solved().error_sums();
  for (std::size_t k = 0; k < count_; ++k)
    probe_.solved().add_error(hit, solid_angle * through * weights_[k],
                              std::span(errors_).subspan(k * width, width));
}

std::vector<double> SphereSamples::means(std::uint32_t samples) const {
  auto means = punctual_;
  const auto width = bands_ * count_;
  const auto per_sample = 1.0 / static_cast<double>(samples);
  for (std::size_t i = 0; i < sums_.size(); ++i)
    means[i % width] += per_sample * sums_[i] / static_cast<double>(replicates);
  return means;
}

std::vector<double> SphereSamples::lux_of_replicates(std::size_t k, std::uint32_t samples) const {
  const auto per_sample = 1.0 / static_cast<double>(samples);
  std::vector<double> lux(replicates, 0.0);
  for (std::size_t r = 0; r < replicates; ++r)
    for (std::size_t b = 0; b < bands_; ++b)
      lux[r] += probe_.solved().lux(b) * per_sample * sums_[(r * bands_ + b) * count_ + k];
  return lux;
}

double SphereSamples::lux_of_punctual(std::size_t k) const {
  double lux = 0.0;
  for (std::size_t b = 0; b < bands_; ++b) lux += probe_.solved().lux(b) * punctual_[b * count_ + k];
  return lux;
}

std::span<const double> SphereSamples::error_sums(std::size_t k) const {
  const auto width = probe_.solved().error_sums();
  return std::span(errors_).subspan(k * width, width);
}

template <typename Values>
void SphereSamples::add(const Vec3d& direction, const Values& radiance, double solid_angle,
                        std::span<double> sum) {
  weights_of_(direction, weights_);
  for (std::size_t b = 0; b < bands_; ++b)
    for (std::size_t k = 0; k < count_; ++k)
      sum[b * count_ + k] += solid_angle * static_cast<double>(radiance[b]) * weights_[k];
}

void SphereSamples::add_seen(const BandPointLight& lamp, const PointSight& sight, double solid_angle,
                             std::span<double> sum) {
  const Ray ray{origin_.position, Vec3(sight.direction)};
  ++rays_;
  if (probe_.tracer().occluded(ray, sight.distance)) return;
  const auto through = probe_.lamp_rays().panes().along(ray, sight.distance);
  for (std::size_t b = 0; b < bands_; ++b)
    radiosity_[b] = in_band(through, b) * static_cast<double>(lamp.intensity[b]);
  add(sight.direction, radiosity_, solid_angle, sum);
}

void SphereSamples::sample_lamps(std::size_t face, const OwenSobol& points, std::uint32_t i,
                                 std::span<double> sum) {
  const auto axis = axis_of(face);
  LampRayEnds ends;
  const auto term = probe_.lamp_rays().towards_lamp({origin_.position, axis, origin_.lift}, choices_[face],
                                                    {points.at(i, 0), points.at(i, 1)}, &ends);
  rays_ += term.rays;
  if (!(term.seen > 0.0) || !(term.given > 0.0)) return;
  const auto direction = glm::normalize(Vec3d(ends.to) - Vec3d(ends.from));
  if (face_of(direction) != face) return;
  const auto cosine = glm::dot(direction, Vec3d(axis));
  const auto& lamps = probe_.lamp_rays().lamps();
  const auto radiance = lamps.radiance(term.lamp);
  const auto more = lamps.triangles()[term.lamp].is_portal() ? lamps.sky_difference(term.sky_patch)
                                                             : std::span<const float>();
  for (std::size_t b = 0; b < bands_; ++b)
    radiosity_[b] = in_band(term.of_band, b) *
                    (static_cast<double>(radiance[b]) + (more.empty() ? 0.0 : static_cast<double>(more[b])));
  add(direction, radiosity_, term.value() / cosine, sum);
}

void SphereSamples::choose_openings() {
  const auto& punctual = probe_.lamp_rays().punctual();
  for (std::size_t f = 0; f < axes.size(); ++f)
    openings_[f].make(probe_.patches().point_lights, punctual.weights, punctual.with_opening,
                      {Vec3d(origin_.position), 0.0, Vec3d(axis_of(f))});
}

void SphereSamples::sample_openings(std::size_t face, const OwenSobol& points, std::uint32_t i,
                                    std::span<double> sum) {
  const Vec3d axis(axis_of(face));
  const auto u = points.first4(i);
  const auto sample = openings_[face].sample(Vec3d(origin_.position), axis, static_cast<double>(u[0]),
                                             {static_cast<double>(u[1]), static_cast<double>(u[2])});
  const auto& sight = sample.sight;
  if (!(sample.given > 0.0) || face_of(sight.direction) != face) return;
  add_seen(probe_.patches().point_lights[sample.light], sight, sample.given / glm::dot(sight.direction, axis),
           sum);
}

void SphereSamples::trace_punctual() {
  for (const auto& lamp : probe_.patches().point_lights) {
    if (has_opening(lamp.light)) continue;  // the disc of a sun counts as its centre
    for (std::size_t f = 0; f < axes.size(); ++f) {
      const auto axis = axis_of(f);
      const auto sight = sight_of(lamp.light, Vec3d(origin_.position), Vec3d(axis));
      if (!(sight.irradiance > 0.0) || face_of(sight.direction) != f) continue;
      add_seen(lamp, sight, sight.irradiance / glm::dot(sight.direction, Vec3d(axis)), punctual_);
    }
  }
}

}  // namespace luxel
