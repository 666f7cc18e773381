// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/probe_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/core/sobol.h"
#include "luxel/core/warp.h"
#include "luxel/lamps/lamp_choices.h"
#include "luxel/render/doubled_samples.h"
#include "luxel/render/harmonics.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr auto replicates = gather_replicates;
constexpr std::uint32_t min_samples = 1024;       // as of SolutionProbe
constexpr std::size_t points_between_calls = 16;  // polls of the monitor

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

// Samples of one point.
class Sphere {
 public:
  Sphere(const SolutionProbe& probe, const ProbePoint& point, std::size_t count, std::uint64_t key)
      : probe_(probe),
        origin_(probe.place(point).rays),
        count_(count),
        key_(key),
        bands_(probe.solved().bands()),
        sums_(replicates * bands_ * count, 0.0),
        punctual_(bands_ * count, 0.0),
        radiosity_(bands_) {
    const auto& rays = probe.lamp_rays();
    const auto& at = origin_.position;
    for (std::size_t f = 0; f < axes.size(); ++f)
      choices_[f].make(rays.lamps(), rays.tree(), {at, at, at}, axis_of(f),
                       {.most = LampChoices::few_lamps, .closed_form = true});
    trace_punctual();
  }

  void sample(std::uint32_t r, std::uint32_t i) {
    const auto sum = std::span(sums_).subspan(r * bands_ * count_, bands_ * count_);
    for (std::size_t f = 0; f < axes.size(); ++f)
      if (!choices_[f].empty())
        sample_lamps(f, OwenSobol(nth_key(key_, axes.size() * r + f + replicates)), i, sum);
    const OwenSobol points(nth_key(key_, r));
    const auto ray = even_ray(origin_.position, points.at(i, 0), points.at(i, 1));
    ++rays_;
    std::fill(radiosity_.begin(), radiosity_.end(), 0.0);
    probe_.add_arriving(ray, probe_.tracer().nearest(ray), 4.0, radiosity_);  // 4 pi sr / pi
    add(Vec3d(ray.direction), radiosity_, 1.0, sum);
  }

  // Mean of the replicates, and the variance of its luminance, summed over coefficients.
  struct Result {
    std::vector<double> coefficients;
    double variance = 0.0;
    double luminance = 0.0;  // of the first coefficient
  };
  Result result(std::uint32_t samples) const {
    Result result{punctual_};
    const auto width = bands_ * count_;
    const auto per_sample = 1.0 / static_cast<double>(samples);
    for (std::size_t i = 0; i < sums_.size(); ++i)
      result.coefficients[i % width] += per_sample * sums_[i] / static_cast<double>(replicates);
    for (std::size_t k = 0; k < count_; ++k) {
      std::array<double, replicates> lux{};
      for (std::size_t r = 0; r < replicates; ++r)
        for (std::size_t b = 0; b < bands_; ++b)
          lux[r] += probe_.solved().lux(b) * per_sample * sums_[r * width + b * count_ + k];
      const auto error = error_of_replicates(lux);
      result.variance += error * error;
    }
    for (std::size_t b = 0; b < bands_; ++b)
      result.luminance += probe_.solved().lux(b) * result.coefficients[b * count_];
    return result;
  }
  std::uint64_t rays() const { return rays_; }

 private:
  template <typename Values>
  void add(const Vec3d& direction, const Values& radiance, double solid_angle, std::span<double> sum) const {
    const auto y = harmonics(direction);
    for (std::size_t b = 0; b < bands_; ++b)
      for (std::size_t k = 0; k < count_; ++k)
        sum[b * count_ + k] += solid_angle * static_cast<double>(radiance[b]) * y[k];
  }

  void sample_lamps(std::size_t face, const OwenSobol& points, std::uint32_t i, std::span<double> sum) {
    const auto axis = axis_of(face);
    LampRayEnds ends;
    const auto term = probe_.lamp_rays().towards_lamp({origin_.position, axis, origin_.lift}, choices_[face],
                                                      {points.at(i, 0), points.at(i, 1)}, &ends);
    rays_ += term.rays;
    if (!term.seen || !(term.given > 0.0)) return;
    const auto direction = glm::normalize(Vec3d(ends.to) - Vec3d(ends.from));
    if (face_of(direction) != face) return;
    const auto cosine = glm::dot(direction, Vec3d(axis));
    add(direction, probe_.lamp_rays().lamps().radiance(term.lamp), term.given / cosine, sum);
  }

  void trace_punctual() {
    for (const auto& lamp : probe_.patches().point_lights)
      for (std::size_t f = 0; f < axes.size(); ++f) {
        const auto axis = axis_of(f);
        const auto sight = sight_of(lamp.light, Vec3d(origin_.position), Vec3d(axis));
        if (!(sight.irradiance > 0.0) || face_of(sight.direction) != f) continue;
        ++rays_;
        if (probe_.tracer().occluded({origin_.position, Vec3(sight.direction)}, sight.distance)) continue;
        add(sight.direction, lamp.intensity, sight.irradiance / glm::dot(sight.direction, Vec3d(axis)),
            punctual_);
      }
  }

  const SolutionProbe& probe_;
  LampRayOrigin origin_;
  std::size_t count_;
  std::uint64_t key_;
  std::size_t bands_;
  std::array<LampChoices, 6> choices_;
  std::vector<double> sums_;      // [replicate][band][k], of all samples so far
  std::vector<double> punctual_;  // [band][k]
  std::vector<double> radiosity_;
  std::uint64_t rays_ = 0;
};

SphereLight measure(const SolutionProbe& probe, const ProbePoint& point, std::size_t count,
                    const ProbeOptions& options, std::uint64_t key) {
  Sphere sphere(probe, point, count, key);
  SphereLight light;
  // The first coefficient of even light that gives `floor` lx.
  const auto floor = options.floor / std::numbers::pi * std::sqrt(4.0 * std::numbers::pi);
  DoubledVariance<double> doubled;
  double variance = 0.0;
  const auto taken = double_samples(
      options.max_rays, [&](std::uint32_t r, std::uint32_t i) { sphere.sample(r, i); },
      [&](std::uint32_t samples) {
        const auto result = sphere.result(samples);
        variance = doubled.of(result.variance);
        const auto whole = std::max(result.luminance, floor);
        light.error = whole > 0.0 ? std::sqrt(variance) / whole : 0.0;
        light.reached = samples * replicates >= min_samples && light.error <= options.error;
        return light.reached;
      });
  light.coefficients = sphere.result(taken).coefficients;
  light.rays = sphere.rays();
  return light;
}

}  // namespace

std::vector<SphereLight> probe_spheres(const SolutionProbe& probe, std::span<const ProbePoint> points,
                                       std::size_t count, const ProbeOptions& options,
                                       const Context& context) {
  if (count != 4 && count != max_harmonics)
    throw InputError(fmt::format("expected 4 or 9 spherical harmonics, not {}", count));
  std::vector<SphereLight> light(points.size());
  for (std::size_t first = 0; first < points.size(); first += points_between_calls) {
    const auto done = static_cast<double>(first) / static_cast<double>(points.size());
    if (context.report({"harmonics", done}) == Next::stop) return {};
    const auto chunk = std::min(points_between_calls, points.size() - first);
    context.for_chunks(chunk, 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = first + begin; i < first + end; ++i)
        light[i] =
            measure(probe, points[i], count, options,
                    stream_key(options.seed, RandomPurpose::sphere_probes, static_cast<std::uint32_t>(i)));
    });
  }
  context.report({"harmonics", 1.0});
  return light;
}

}  // namespace luxel
