// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/coefficients.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "luxel/core/none.h"
#include "luxel/lighting/point_rays.h"
#include "luxel/lighting/portal_sky.h"
#include "luxel/scene/band_colours.h"
#include "luxel/solve/replicate_solve.h"
#include "luxel/solve/sampling.h"

namespace luxel {
namespace {

constexpr std::size_t block_columns = 48;  // patches of the sky at a time: their light stays in the cache
constexpr double tolerance = 1e-5;         // of the iteration
constexpr std::size_t points_per_chunk = 4;

// Scattering of light of the sky's own colour at each receiver, by luminance.
ScatteringTable luminous_scattering(const PatchSet& patches, const GatherSides& sides) {
  const auto colours = patches.colours();
  const auto sky = patches.mean_sky();
  std::vector<double> weight(patches.band_count());
  for (std::size_t b = 0; b < weight.size(); ++b) {
    std::vector<double> alone(weight.size(), 0.0);
    alone[b] = static_cast<double>(sky[b]);
    weight[b] = colours.lumens(alone);
  }
  const auto whole = std::accumulate(weight.begin(), weight.end(), 0.0);
  const auto luminous = [&](const std::vector<float>& by_band) {
    std::vector<float> means;
    for (std::size_t first = 0; first < by_band.size(); first += weight.size()) {
      double sum = 0.0;
      for (std::size_t b = 0; b < weight.size(); ++b)
        sum += weight[b] / whole * static_cast<double>(by_band[first + b]);
      means.push_back(static_cast<float>(sum));
    }
    return means;
  };
  const auto of_bands = scattering_of(patches, sides, Context(1));
  return {luminous(of_bands.reflectance), luminous(of_bands.transmittance), of_bands.far};
}

std::vector<float> repeated(std::span<const float> values, std::size_t times) {
  std::vector<float> result(values.size() * times);
  for (std::size_t i = 0; i < values.size(); ++i) std::fill_n(&result[i * times], times, values[i]);
  return result;
}

// The light of all receivers from a block of patches of the sky, replicate by replicate: irradiance over the
// radiance of the patch, sr, [replicate][receiver * columns + column]. Empty after a stop.
class BlockSolver {
 public:
  BlockSolver(const PatchSet& patches, const Sampling& sampling, const Context& context)
      : patches_(patches),
        sampling_(sampling),
        transport_(sampling.transport()),
        through_portals_(sampling, context),
        scattering_(luminous_scattering(patches, sampling.hits().sides())),
        context_(context) {}

  Scattering scattering() const { return scattering_; }  // [receiver]

  std::vector<std::vector<float>> solve(std::size_t first, std::size_t columns) const {
    const auto& hits = sampling_.hits();
    const auto receivers = hits.sides().size();
    // Each patch has the radiance of the mean sky, so that the noise of the block is that of its light.
    std::vector<float> radiosity((receivers + transport_->elements()) * columns, 0.0f), radiance(columns);
    for (std::size_t c = 0; c < columns; ++c) {
      radiance[c] = mean_radiance(first + c);
      const auto shine = [&](std::size_t sink) {
        radiosity[(receivers + sink) * columns + c] = static_cast<float>(std::numbers::pi) * radiance[c];
      };
      shine(hits.escaped(first + c));
      // Rays through tinted panes are as many as their luminous part is, whatever their tint.
      for (std::size_t t = 0; t < hits.tints(); ++t) shine(hits.tinted(first + c, t));
    }
    const ScatteringTable in_columns{repeated(scattering_.reflectance, columns),
                                     repeated(scattering_.transmittance, columns), scattering_.far};
    const auto direct = through_portals_.irradiance(first, radiance, context_);
    auto light = solve_replicates(*transport_, direct, in_columns, radiosity, tolerance, context_);
    if (light.is_stopped) return {};
    for (std::size_t r = 0; r < light.gathered.size(); ++r)
      context_.for_chunks(receivers, 4096, [&](std::size_t begin, std::size_t end, int) {
        for (auto i = begin * columns; i < end * columns; ++i)
          light.gathered[r][i] = (light.gathered[r][i] + direct[r][i]) / radiance[i % columns];
      });
    return std::move(light.gathered);
  }

 private:
  float mean_radiance(std::size_t sky_patch) const {
    const auto bands = patches_.band_count();
    float sum = 0.0f;
    for (std::size_t b = 0; b < bands; ++b) sum += patches_.sky[sky_patch * bands + b];
    return sum > 0.0f ? sum : 1.0f;
  }

  const PatchSet& patches_;
  const Sampling& sampling_;
  std::unique_ptr<const SampledOperator> transport_;
  PortalSky through_portals_;
  ScatteringTable scattering_;
  const Context& context_;
};

}  // namespace

DaylightCoefficients find_coefficients(const DaylightRun& run, const Tracer& tracer,
                                       std::span<const ProbePoint> points, const CoefficientOptions& options,
                                       const Context& context) {
  const auto& patches = run.patches;
  const auto quiet = context.quiet();
  Sampling sampling(patches, tracer, run.options, quiet);
  if (run.traces_again)
    sampling.restore_rays(run.state);
  else
    sampling.restore(run.state);
  const auto& sides = sampling.hits().sides();
  const PointRays rays(patches, tracer, sides, run.state.replicates, options);

  DaylightCoefficients found;
  found.sky = patches.sky_patches;
  found.points = points.size();
  found.replicates = run.state.replicates;
  found.knows_openings = !patches.portals.empty();
  const auto width = found.sky.size();
  for (auto& part : found.of) part.assign(points.size() * found.replicates * width, 0.0f);
  std::vector<PointHits> hits(points.size());
  context.for_chunks(points.size(), points_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto m = begin; m < end; ++m) {
      const auto at = [&](DaylightPath path) {
        return std::span(found.of[static_cast<std::size_t>(path)])
            .subspan(m * found.replicates * width, found.replicates * width);
      };
      hits[m] = rays.trace(points[m], static_cast<std::uint32_t>(m), at(DaylightPath::sky),
                           at(DaylightPath::external));
    }
  });
  for (const auto& h : hits) {
    found.rays += h.rays;
    found.origins.push_back(h.origin);
  }

  const BlockSolver solver(patches, sampling, quiet);
  const auto scattering = solver.scattering();
  for (std::size_t first = 0; first < width; first += block_columns) {
    const auto columns = std::min(block_columns, width - first);
    const auto done = static_cast<double>(first) / static_cast<double>(width);
    if (context.report({"coefficients", done, found.rays}) == Next::stop) return {};
    const auto light = solver.solve(first, columns);
    context.for_chunks(points.size(), points_per_chunk, [&](std::size_t begin, std::size_t end, int) {
      for (auto m = begin; m < end; ++m)
        for (std::uint32_t r = 0; r < found.replicates; ++r)
          for (const auto& hit : hits[m].of_replicate(r)) {
            const auto path = hit.is_external ? DaylightPath::external : DaylightPath::internal;
            auto* to = &found.of[static_cast<std::size_t>(path)][(m * found.replicates + r) * width + first];
            const auto add = [&](std::size_t receiver, float weight) {
              const auto* from = &light[r][receiver * columns];
              for (std::size_t c = 0; c < columns; ++c) to[c] += weight * from[c];
            };
            add(hit.receiver, hit.weight * scattering.reflectance[hit.receiver]);
            if (scattering.transmits())
              add(scattering.far[hit.receiver], hit.weight * scattering.transmittance[hit.receiver]);
          }
    });
  }
  context.report({"coefficients", 1.0, found.rays});
  return found;
}

}  // namespace luxel
