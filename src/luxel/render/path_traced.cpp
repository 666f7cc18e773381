// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/path_traced.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/address.h"
#include "luxel/core/warp.h"
#include "luxel/render/strata.h"
#include "luxel/solution/error_95th.h"

namespace luxel {
namespace {

enum Name : std::uint32_t { place, direction, lamp_place, lamp_choice };  // of strata
enum Fate : std::size_t { escaped, lost, fates };                         // of first rays, after the bands
constexpr std::uint32_t light_step = 0x70617468u;  // keeps these streams apart from a picture's

class SideMeans {
 public:
  SideMeans(const PatchSet& patches, const Tracer& tracer, const PathOptions& options)
      : patches_(patches),
        options_(options),
        bands_(patches.band_count()),
        paths_(patches, tracer),
        means_(2 * patches.size(), bands_ + fates) {}

  StopReason run(const Workers& workers, const Monitor& monitor) {
    return means_.run(
        options_.limits,
        [this](std::size_t s, std::uint64_t i, std::span<double> sums) { return draw(s, i, sums); },
        [this](const BatchMeans&) { return whole_error(); }, workers, monitor, "light");
  }

  // sqrt(sum of A variance / sum of A H²) over sides and bands.
  double whole_error() const {
    double variance = 0.0;
    double squared_light = 0.0;
    for (std::size_t side = 0; side < means_.elements(); ++side)
      for (std::size_t b = 0; b < bands_; ++b) {
        variance += area(side) * means_.variance(side, b);
        squared_light += area(side) * means_.mean(side, b) * means_.mean(side, b);
      }
    return squared_light > 0.0 ? std::sqrt(variance / squared_light) : 0.0;
  }

  double area(std::size_t side) const { return static_cast<double>(patches_.area[side / 2]); }
  const BatchMeans& means() const { return means_; }

 private:
  std::uint64_t draw(std::size_t side, std::uint64_t batch, std::span<double> sums) const {
    const auto patch = side / 2;
    const bool back = side % 2 == 1;
    if (!is_reflecting(patches_, patch, back)) return 0;
    const auto side_key = stream_key(options_.seed, light_step, static_cast<std::uint32_t>(side));
    const auto key = mix64(side_key + (batch + 1) * 0x9e3779b97f4a7c15u);
    constexpr auto cells = BatchMeans::batch_side;
    const Strata places(key, place, cells), directions(key, direction, cells), lamps(key, lamp_place, cells),
        choices(key, lamp_choice, cells);

    std::vector<double> weight(bands_);
    std::uint64_t rays = 0;
    for (std::uint32_t i = 0; i < BatchMeans::batch_paths; ++i) {
      const auto path_key = mix64(key ^ (i + 1));
      const auto u = uniform4(path_key, ~std::uint64_t{0});
      const auto v = uniform4(path_key, ~std::uint64_t{1});
      const auto at = places.pair(i, u[0], u[1]);
      const auto out = directions.pair(i, u[2], u[3]);
      const auto on_lamp = lamps.pair(i, v[0], v[1]);
      const VertexNumbers first{{out.x, out.y}, {choices.number(i, v[2]), on_lamp.x, on_lamp.y}};
      const auto trail =
          paths_.irradiance(surface_point(patches_, patch, back, uniform_triangle(at.x, at.y)), first,
                            path_key, options_.bounces_from, weight, sums.first(bands_));
      rays += trail.rays;
      if (!trail.first)
        sums[bands_ + escaped] += 1.0;
      else if (!is_reflecting(patches_, trail.first.patch, trail.first.back))
        sums[bands_ + lost] += 1.0;
    }
    return rays;
  }

  const PatchSet& patches_;
  const PathOptions& options_;
  std::size_t bands_;
  LightPaths paths_;
  BatchMeans means_;
};

void fill_light(const PatchSet& patches, const SideMeans& sides, Solution& solution) {
  const auto bands = patches.band_count();
  auto& s = solution;
  for (auto* array : {&s.irradiance_front, &s.irradiance_back, &s.radiosity_front, &s.radiosity_back,
                      &s.standard_error_front, &s.standard_error_back})
    array->assign(patches.size() * bands, 0.0f);
  for (std::size_t side = 0; side < 2 * patches.size(); ++side) {
    const bool back = side % 2 == 1;
    const auto wide = widening_of(sides.means().batches(side));
    for (std::size_t b = 0; b < bands; ++b) {
      const auto i = side / 2 * bands + b;
      const auto H = sides.means().mean(side, b);
      const auto error = wide * std::sqrt(sides.means().variance(side, b));
      const auto emittance = back ? 0.0f : patches.emittance(side / 2, b);
      const auto h = static_cast<float>(H);
      (back ? s.irradiance_back : s.irradiance_front)[i] = h;
      (back ? s.radiosity_back : s.radiosity_front)[i] = emittance + patches.reflectance(side / 2, b) * h;
      (back ? s.standard_error_back : s.standard_error_front)[i] = static_cast<float>(error);
    }
  }
  s.error_95th = error_95th_of(s);
}

void fill_power(const PatchSet& patches, const SideMeans& sides, PathReport& report) {
  const auto bands = patches.band_count();
  for (auto* part :
       {&report.emitted, &report.from_sky, &report.absorbed, &report.escaped, &report.lost_at_backs})
    part->assign(bands, 0.0);
  for (std::size_t side = 0; side < 2 * patches.size(); ++side) {
    for (std::size_t b = 0; b < bands; ++b) {
      const auto H = sides.means().mean(side, b);
      const auto rho = static_cast<double>(patches.reflectance(side / 2, b));
      const auto emitted =
          side % 2 == 0 ? sides.area(side) * static_cast<double>(patches.emittance(side / 2, b)) : 0.0;
      const auto leaves = emitted + sides.area(side) * rho * H;
      report.emitted[b] += emitted;
      report.from_sky[b] +=
          sides.area(side) * sides.means().mean(side, bands + escaped) * patches.sky_radiosity(b);
      report.absorbed[b] += sides.area(side) * (1.0 - rho) * H;
      report.escaped[b] += leaves * sides.means().mean(side, bands + escaped);
      report.lost_at_backs[b] += leaves * sides.means().mean(side, bands + lost);
    }
  }
}

}  // namespace

PathReport trace_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                       const PathOptions& options, const Workers& workers, const Monitor& monitor) {
  SideMeans sides(patches, tracer, options);
  PathReport report;
  report.stop = sides.run(workers, monitor);
  report.complete = sides.means().complete();
  report.rays = sides.means().rays();
  report.paths = sides.means().batches(0) * BatchMeans::batch_paths;
  report.predicted_error = sides.whole_error();
  solution.bands = patches.bands;
  fill_light(patches, sides, solution);
  fill_power(patches, sides, report);
  report.error_95th = solution.error_95th;

  solution.unshot_fraction = 0.0;
  solution.predicted_error = report.predicted_error;
  solution.stop = report.stop;
  solution.provenance.method = "path-traced";
  solution.provenance.seed = options.seed;
  solution.provenance.rays = report.rays;
  solution.provenance.scene_fingerprint = patches.scene_fingerprint;
  return report;
}

}  // namespace luxel
