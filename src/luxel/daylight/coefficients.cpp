// SPDX-License-Identifier: Apache-2.0
#include "luxel/daylight/coefficients.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "luxel/core/none.h"
#include "luxel/daylight/point_rays.h"
#include "luxel/scene/band_colours.h"
#include "luxel/solve/replicate_solve.h"
#include "luxel/solve/sampling.h"

namespace luxel {
namespace {

constexpr std::size_t block_columns = 48;  // patches of the sky at a time: their light stays in the cache
constexpr double tolerance = 1e-5;         // of the iteration
constexpr std::size_t points_per_chunk = 4;

// Luminous reflectance of each receiver: under light of the sky's own colour.
std::vector<float> luminous_reflectance(const PatchSet& patches, const GatherSides& sides) {
  const auto colours = patches.colours();
  const auto sky = patches.mean_sky();
  std::vector<double> weight(patches.band_count());
  for (std::size_t b = 0; b < weight.size(); ++b) {
    std::vector<double> alone(weight.size(), 0.0);
    alone[b] = static_cast<double>(sky[b]);
    weight[b] = colours.lumens(alone);
  }
  const auto whole = std::accumulate(weight.begin(), weight.end(), 0.0);
  std::vector<float> reflectance;
  for (const auto side : sides.side) {
    double sum = 0.0;
    for (std::size_t b = 0; b < weight.size(); ++b)
      sum += weight[b] / whole * static_cast<double>(patches.reflectance(side.patch(), b));
    reflectance.push_back(static_cast<float>(sum));
  }
  return reflectance;
}

// The light of all receivers from a block of patches of the sky, replicate by replicate: irradiance over the
// radiance of the patch, sr, [replicate][receiver * columns + column]. Empty after a stop.
class BlockSolver {
 public:
  BlockSolver(const PatchSet& patches, const Sampling& sampling, const Context& context)
      : patches_(patches),
        sampling_(sampling),
        transport_(sampling.transport()),
        reflectance_(luminous_reflectance(patches, sampling.hits().sides())),
        context_(context) {}

  std::span<const float> reflectance() const { return reflectance_; }

  std::vector<std::vector<float>> solve(std::size_t first, std::size_t columns) const {
    const auto& hits = sampling_.hits();
    const auto receivers = hits.sides().size();
    // Each patch has the radiance of the mean sky, so that the noise of the block is that of its light.
    std::vector<float> radiosity((receivers + transport_->elements()) * columns, 0.0f), scale(columns);
    for (std::size_t c = 0; c < columns; ++c) {
      const auto own = mean_radiance(first + c);
      scale[c] = 1.0f / own;
      const auto shine = [&](std::size_t sink) {
        radiosity[(receivers + sink) * columns + c] = static_cast<float>(std::numbers::pi) * own;
      };
      shine(hits.escaped(first + c));
      // Rays through tinted panes are as many as their luminous part is, whatever their tint.
      for (std::size_t t = 0; t < hits.tints(); ++t) shine(hits.tinted(first + c, t));
    }
    std::vector<float> reflectances(receivers * columns);
    for (std::size_t s = 0; s < receivers; ++s)
      std::fill_n(&reflectances[s * columns], columns, reflectance_[s]);
    const std::vector<std::vector<float>> direct(hits.replicates(),
                                                 std::vector<float>(receivers * columns, 0.0f));
    auto light = solve_replicates(*transport_, direct, reflectances, radiosity, tolerance, context_);
    if (light.is_stopped) return {};
    for (auto& replicate : light.gathered)
      context_.for_chunks(receivers, 4096, [&](std::size_t begin, std::size_t end, int) {
        for (auto i = begin * columns; i < end * columns; ++i) replicate[i] *= scale[i % columns];
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
  std::vector<float> reflectance_;
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
  const PointRays rays(patches, run.openings, tracer, sides, run.state.replicates, options);

  DaylightCoefficients found;
  found.sky = patches.sky_patches;
  found.points = points.size();
  found.replicates = run.state.replicates;
  found.knows_openings = !run.openings.empty();
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
            const auto* from = &light[r][hit.receiver * columns];
            const auto weight = hit.weight * solver.reflectance()[hit.receiver];
            for (std::size_t c = 0; c < columns; ++c) to[c] += weight * from[c];
          }
    });
  }
  context.report({"coefficients", 1.0, found.rays});
  return found;
}

}  // namespace luxel
