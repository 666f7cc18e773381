// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/probe_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/core/sobol.h"
#include "luxel/core/warp.h"
#include "luxel/lamps/point_lamps.h"
#include "luxel/render/doubled_samples.h"
#include "luxel/render/surface_point.h"

namespace luxel {
namespace {

constexpr auto replicates = gather_replicates;
constexpr std::uint32_t min_rays = 1024;  // cosine rays before the spread is tested: few rays may all miss a
                                          // small bright surface, and then agree with each other
constexpr std::size_t points_between_calls = 64;  // polls of the monitor

void check(const ProbeOptions& options, std::span<const ProbePoint> points) {
  if (!(options.error > 0.0 && options.error < 1.0))
    throw InputError(fmt::format("the error of a probe must be above 0 and below 1, not {}", options.error));
  if (!(options.floor >= 0.0))
    throw InputError(fmt::format("the floor of a probe's error must be 0 lx or more, not {}", options.floor));
  if (options.max_rays < min_rays)
    throw InputError(
        fmt::format("a probe takes at least {} rays per point, not {}", min_rays, options.max_rays));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [position, normal] = points[i];
    if (!std::isfinite(glm::length(position)) || !(std::abs(glm::length(normal) - 1.0f) < 1e-3f))
      throw InputError(fmt::format("point {} of the probe needs a finite position and a unit normal", i));
  }
}

// The random numbers of one point: Sobol points of each replicate, for directions and for lamps.
struct Numbers {
  std::vector<OwenSobol> direction, lamp;

  explicit Numbers(std::uint64_t key) {
    for (std::uint64_t r = 0; r < replicates; ++r) {
      direction.emplace_back(nth_key(key, 2 * r));
      lamp.emplace_back(nth_key(key, 2 * r + 1));
    }
  }
  static std::array<float, 2> pair(const OwenSobol& points, std::uint32_t i) {
    return {points.at(i, 0), points.at(i, 1)};
  }
};

}  // namespace

const char* name(ProbePlace place) {
  switch (place) {
    case ProbePlace::free:
      return "free";
    case ProbePlace::surface:
      return "surface";
    case ProbePlace::behind:
      return "behind";
    case ProbePlace::dark:
      return "dark";
  }
  return "";
}

double ProbedLight::standard_error() const { return std::hypot(sampling_error, solution_error); }

SolutionProbe::SolutionProbe(const PatchSet& patches, const Solution& solution, const Tracer& tracer,
                             const SampleState* samples, const Context& context)
    : patches_(patches),
      solution_(solution),
      tracer_(tracer),
      lamps_(patches),
      lamp_rays_(patches, tracer, lamps_, false),
      solved_(patches, solution, samples, context),
      tolerance_(surface_tolerance(patches)) {}

double SolutionProbe::add_arriving(const Ray& ray, const Hit& hit, double weight,
                                   std::span<double> radiosity) const {
  const auto& panes = lamp_rays_.panes();
  const auto through = panes.along(ray, hit.distance);
  if (hit) {
    for (std::size_t b = 0; b < radiosity.size(); ++b)
      radiosity[b] += weight * in_band(through, b) * solved_.reflected(hit, b);
  } else if (patches_.has_sky() && lamp_rays_.portals().first_crossed(ray) == none) {
    const auto sky_patch = patches_.sky_patches.patch_of(Vec3d(ray.direction));
    for (std::size_t b = 0; b < radiosity.size(); ++b)
      radiosity[b] += weight * in_band(through, b) * patches_.sky_radiosity(sky_patch, b);
  }
  return panes.luminous(through);
}

ProbedLight SolutionProbe::at(const ProbePoint& point, const ProbeOptions& options, std::uint64_t key) const {
  const auto bands = solved_.bands();
  const auto origin = place(point);
  PointLamps lamps(patches_, tracer_, lamp_rays_, origin.rays, replicates);
  const Numbers numbers(key);
  const Frame frame(origin.rays.normal);
  std::vector<double> gathered(replicates * bands, 0.0), means;
  std::vector<double> errors(solved_.error_sums(), 0.0);
  std::uint64_t behind = 0, cosine_rays = 0;
  ProbedLight light;

  const auto sample = [&](std::uint32_t r, std::uint32_t i) {
    std::array<float, 3> opening{};
    if (lamps.has_openings())
      for (int d = 0; d < 3; ++d) opening[static_cast<std::size_t>(d)] = numbers.lamp[r].at(i, d + 2);
    lamps.sample(r, Numbers::pair(numbers.lamp[r], i), opening);
    const auto [u, v] = Numbers::pair(numbers.direction[r], i);
    const Ray ray{origin.rays.position, frame.to_world(cosine_hemisphere(u, v))};
    const auto hit = tracer_.nearest(ray);
    ++cosine_rays;
    if (hit && !is_reflecting(patches_, hit.patch, hit.back)) ++behind;
    if (options.direct && hit) return;
    const auto through = add_arriving(ray, hit, 1.0, std::span(gathered).subspan(r * bands, bands));
    solved_.add_error(hit, through, errors);
  };
  DoubledVariance<double> doubled;
  const auto is_enough = [&](std::uint32_t samples) {
    means = gathered;
    for (auto& m : means) m /= static_cast<double>(samples);
    lamps.add_to(means, samples);
    std::array<double, replicates> lux{};
    light.illuminance = 0.0;
    for (std::size_t r = 0; r < replicates; ++r) {
      lux[r] = solved_.illuminance(std::span(means).subspan(r * bands, bands));
      light.illuminance += lux[r] / static_cast<double>(replicates);
    }
    const auto spread = error_of_replicates(lux);
    light.sampling_error = std::sqrt(doubled.of(spread * spread));
    light.reached = samples * replicates >= min_rays &&
                    light.sampling_error <= options.error * std::max(light.illuminance, options.floor);
    return light.reached;
  };
  double_samples(options.max_rays, sample, is_enough);

  light.irradiance.assign(bands, 0.0);
  for (std::size_t i = 0; i < means.size(); ++i)
    light.irradiance[i % bands] += means[i] / static_cast<double>(replicates);
  light.solution_error = solved_.error(errors, static_cast<double>(cosine_rays));
  light.solution_replicates = solved_.replicates(errors, static_cast<double>(cosine_rays));
  light.rays = cosine_rays + lamps.rays();
  light.place = origin.on_surface ? ProbePlace::surface : ProbePlace::free;
  if (2 * behind > cosine_rays)
    light.place = ProbePlace::behind;
  else if (!(light.illuminance > 0.0))
    light.place = ProbePlace::dark;
  return light;
}

std::vector<ProbedLight> probe_light(const SolutionProbe& probe, std::span<const ProbePoint> points,
                                     const ProbeOptions& options, const Context& context) {
  check(options, points);
  std::vector<ProbedLight> light(points.size());
  std::uint64_t rays = 0;
  for (std::size_t first = 0; first < points.size(); first += points_between_calls) {
    const auto done = static_cast<double>(first) / static_cast<double>(points.size());
    if (context.report({"points", done, rays}) == Next::stop) return {};
    const auto count = std::min(points_between_calls, points.size() - first);
    context.for_chunks(count, 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = first + begin; i < first + end; ++i)
        light[i] = probe.at(points[i], options,
                            stream_key(options.seed, RandomPurpose::probes, static_cast<std::uint32_t>(i)));
    });
    for (std::size_t i = first; i < first + count; ++i) rays += light[i].rays;
  }
  context.report({"points", 1.0, rays});
  return light;
}

}  // namespace luxel
