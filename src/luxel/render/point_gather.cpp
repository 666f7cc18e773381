// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/point_gather.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "luxel/core/address.h"
#include "luxel/core/sobol.h"
#include "luxel/render/batch_means.h"
#include "luxel/render/doubled_samples.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_irradiance.h"

namespace luxel {
namespace {

constexpr auto replicates = gather_replicates;

}  // namespace

PointGather::PointGather(const PatchSet& patches, const SmoothLight& light, const Tracer& tracer)
    : patches_(patches), light_(light), paths_(patches, tracer), colours_(patches.colours()) {}

PointGather::Result PointGather::at(const SurfacePoint& point, const Limits& limits,
                                    std::uint64_t key) const {
  const auto bands = colours_.bands();
  const std::vector<double> one(bands, 1.0);
  std::vector<double> sums(replicates * bands, 0.0);
  std::vector<glm::dvec4> vectors(limits.with_light_vector ? replicates * bands : 0, glm::dvec4(0.0));
  Result result;
  const auto numbers_of = [](const OwenSobol& points, std::uint32_t i) {
    return VertexNumbers{{points.at(i, 0), points.at(i, 1)},
                         {points.at(i, 4), points.at(i, 2), points.at(i, 3)}};
  };
  // Light that leaves the surface at the end of a ray, W/m²: radiance times pi.
  const auto reflected = [&](const Hit& hit, std::size_t b) {
    return smooth_sent_on(patches_, light_, hit.side(), {hit.u, hit.v}, b);
  };
  const auto sample = [&](std::uint32_t r, std::uint32_t i) {
    const OwenSobol points(nth_key(key, r));
    const auto sum = std::span(sums).subspan(r * bands, bands);
    if (!limits.with_light_vector) {
      const auto trail = paths_.direct(point, numbers_of(points, i), one, sum);
      result.rays += trail.rays;
      const auto& hit = trail.first;
      if (!hit || !is_reflecting(patches_, hit.patch, hit.back)) return;
      for (std::size_t b = 0; b < bands; ++b) sum[b] += in_band(trail.through, b) * reflected(hit, b);
      return;
    }
    const auto vector = std::span(vectors).subspan(r * bands, bands);
    const auto trail = paths_.light_vector(point, numbers_of(points, i), vector);
    result.rays += trail.rays;
    const auto& hit = trail.first;
    const bool reflects = hit && is_reflecting(patches_, hit.patch, hit.back);
    for (std::size_t b = 0; b < bands; ++b) {
      if (reflects)
        vector[b] += trail.solid_angle * in_band(trail.through, b) * reflected(hit, b) / std::numbers::pi *
                     glm::dvec4(trail.direction, trail.cosine);
      sum[b] = vector[b].w;
    }
  };
  DoubledVariance<Vec3d> doubled;
  const auto is_enough = [&](std::uint32_t samples) {
    std::array<Vec3d, replicates> means;
    result.irradiance = Vec3d(0.0);
    for (std::size_t r = 0; r < replicates; ++r) {
      means[r] = colours_.rgb(std::span(sums).subspan(r * bands, bands)) / static_cast<double>(samples);
      result.irradiance += means[r] / static_cast<double>(replicates);
    }
    Vec3d variance(0.0);
    for (const auto& mean : means)
      variance += (mean - result.irradiance) * (mean - result.irradiance) /
                  static_cast<double>(replicates * (replicates - 1));
    variance = doubled.of(variance);
    result.standard_error = widening_of(replicates) * glm::sqrt(variance);
    const auto whole = std::max(glm::length(result.irradiance), limits.least);
    result.reached = samples > first_gather_samples && samples * replicates >= limits.min_rays &&
                     std::sqrt(variance.x + variance.y + variance.z) <= limits.error * whole;
    return result.reached;
  };

  const auto taken = double_samples(limits.max_rays, sample, is_enough);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      result.light_vector[axis] += colours_.of(i % bands) * vectors[i][static_cast<int>(axis)] /
                                   static_cast<double>(taken * replicates);
  return result;
}

}  // namespace luxel
