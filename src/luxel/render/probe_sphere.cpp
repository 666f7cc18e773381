// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/probe_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/render/doubled_samples.h"
#include "luxel/render/harmonics.h"
#include "luxel/render/sphere_samples.h"

namespace luxel {
namespace {

constexpr auto replicates = gather_replicates;
constexpr std::uint32_t min_samples = 1024;       // as of SolutionProbe
constexpr std::size_t points_between_calls = 16;  // polls of the monitor

void harmonic_weights(const Vec3d& direction, std::span<double> weights) {
  const auto y = harmonics(direction);
  std::copy_n(y.begin(), weights.size(), weights.begin());
}

// The coefficients of the samples so far: their mean over replicates, and the variance of its luminance,
// summed over coefficients.
struct Result {
  std::vector<double> coefficients;
  double variance = 0.0;
  double luminance = 0.0;  // of the first coefficient
};
Result result_of(const SphereSamples& sphere, const SolutionLight& solved, std::size_t count,
                 std::uint32_t samples) {
  Result result{sphere.means(samples)};
  for (std::size_t k = 0; k < count; ++k) {
    const auto error = error_of_replicates(sphere.lux_of_replicates(k, samples));
    result.variance += error * error;
  }
  for (std::size_t b = 0; b < solved.bands(); ++b)
    result.luminance += solved.lux(b) * result.coefficients[b * count];
  return result;
}

SphereLight measure(const SolutionProbe& probe, const ProbePoint& point, std::size_t count,
                    const ProbeOptions& options, std::uint64_t key) {
  SphereSamples sphere(probe, point, count, harmonic_weights, key);
  SphereLight light;
  // The first coefficient of even light that gives `floor` lx.
  const auto floor = options.floor / std::numbers::pi * std::sqrt(4.0 * std::numbers::pi);
  DoubledVariance<double> doubled;
  double variance = 0.0;
  const auto taken = double_samples(
      options.max_rays, [&](std::uint32_t r, std::uint32_t i) { sphere.sample(r, i); },
      [&](std::uint32_t samples) {
        const auto result = result_of(sphere, probe.solved(), count, samples);
        variance = doubled.of(result.variance);
        const auto whole = std::max(result.luminance, floor);
        light.error = whole > 0.0 ? std::sqrt(variance) / whole : 0.0;
        light.reached = samples * replicates >= min_samples && light.error <= options.error;
        return light.reached;
      });
  light.coefficients = sphere.means(taken);
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
