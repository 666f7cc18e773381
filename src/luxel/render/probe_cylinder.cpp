// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/probe_cylinder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/render/doubled_samples.h"
#include "luxel/render/sphere_samples.h"

namespace luxel {
namespace {

constexpr auto replicates = gather_replicates;
constexpr std::uint32_t min_samples = 1024;       // as of SolutionProbe
constexpr std::size_t points_between_calls = 16;  // polls of the monitor
constexpr auto cylinder_stream = step_of(RandomPurpose::sphere_probes, 1);

// Weights of a direction: horizontal, cylindrical and, with a facing, semi-cylindrical.
class CylinderWeights {
 public:
  explicit CylinderWeights(const CylinderOptions& cylinder) : axis_(cylinder.axis) {
    if (!cylinder.facing) return;
    const Vec3d facing(*cylinder.facing);
    const auto across = facing - glm::dot(facing, axis_) * axis_;
    if (!(glm::length(across) > 1e-6 * glm::length(facing)))
      throw InputError(
          "the direction of semi-cylindrical illuminance must not be that of the axis: expected a horizontal "
          "one");
    facing_ = glm::normalize(across);
  }
  std::size_t count() const { return facing_ ? 3 : 2; }
  void operator()(const Vec3d& direction, std::span<double> weights) const {
    const auto along = glm::dot(direction, axis_);
    const auto sine = std::sqrt(std::max(0.0, 1.0 - along * along));
    weights[0] = std::max(0.0, along);
    weights[1] = sine / std::numbers::pi;
    if (facing_) weights[2] = std::max(0.0, sine + glm::dot(direction, *facing_)) / std::numbers::pi;
  }

 private:
  Vec3d axis_;
  std::optional<Vec3d> facing_;
};

CylinderLight measure(const SolutionProbe& probe, const ProbePoint& point, const CylinderWeights& weights,
                      const ProbeOptions& options, std::uint64_t key) {
  const auto count = weights.count();
  SphereSamples sphere(probe, point, count, weights, key, true);
  CylinderLight light;
  const std::array<IntegratedLight*, 3> parts = {&light.horizontal, &light.cylindrical,
                                                 &light.semicylindrical};
  std::array<DoubledVariance<double>, 3> doubled;
  const auto sample = [&](std::uint32_t r, std::uint32_t i) { sphere.sample(r, i); };
  double_samples(options.max_rays, sample, [&](std::uint32_t samples) {
    light.reached = samples * replicates >= min_samples;
    for (std::size_t k = 0; k < count; ++k) {
      auto& part = *parts[k];
      const auto lux = sphere.lux_of_replicates(k, samples);
      part.illuminance = sphere.lux_of_punctual(k);
      for (const auto value : lux) part.illuminance += value / static_cast<double>(replicates);
      const auto error = error_of_replicates(lux);
      part.sampling_error = std::sqrt(doubled[k].of(error * error));
      if (part.sampling_error > options.error * std::max(part.illuminance, options.floor))
        light.reached = false;
    }
    return light.reached;
  });
  for (std::size_t k = 0; k < count; ++k) {
    const auto sums = sphere.error_sums(k);
    parts[k]->solution_error = probe.solved().error(sums, sphere.error_whole());
    parts[k]->solution_replicates = probe.solved().replicates(sums, sphere.error_whole());
  }
  light.rays = sphere.rays();
  return light;
}

}  // namespace

double IntegratedLight::standard_error() const { return std::hypot(sampling_error, solution_error); }

std::vector<CylinderLight> probe_cylinders(const SolutionProbe& probe, std::span<const ProbePoint> points,
                                           const CylinderOptions& cylinder, const ProbeOptions& options,
                                           const Context& context) {
  const CylinderWeights weights(cylinder);
  std::vector<CylinderLight> light(points.size());
  std::uint64_t rays = 0;
  for (std::size_t first = 0; first < points.size(); first += points_between_calls) {
    const auto done = static_cast<double>(first) / static_cast<double>(points.size());
    if (context.report({"cylinders", done, rays}) == Next::stop) return {};
    const auto chunk = std::min(points_between_calls, points.size() - first);
    context.for_chunks(chunk, 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = first + begin; i < first + end; ++i)
        light[i] = measure(probe, points[i], weights, options,
                           stream_key(options.seed, cylinder_stream, static_cast<std::uint32_t>(i)));
    });
    for (std::size_t i = first; i < first + chunk; ++i) rays += light[i].rays;
  }
  context.report({"cylinders", 1.0, rays});
  return light;
}

}  // namespace luxel
