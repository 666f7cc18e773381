// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/path_traced.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/address.h"
#include "luxel/core/warp.h"
#include "luxel/patch/side.h"
#include "luxel/render/strata.h"
#include "luxel/solution/error_95th.h"
#include "luxel/trace/sun_power.h"

namespace luxel {
namespace {

enum Name : std::uint32_t { place, direction, lamp_place, lamp_choice };  // of strata
// Fates of the first rays, [fate][band], behind the irradiance of the bands; and the light of the sky that
// they meet.
enum Fate : std::size_t { escaped, lost, in_panes, from_sky, fates };

class SideMeans {
 public:
  SideMeans(const PatchSet& patches, const Tracer& tracer, const PathOptions& options)
      : patches_(patches),
        options_(options),
        bands_(patches.band_count()),
        paths_(patches, tracer),
        means_(side_count(patches.size()), bands_ * (1 + fates)) {}

  StopReason run(const Context& context) {
    return means_.run(
        options_.limits,
        [this](std::size_t s, std::uint64_t i, std::span<double> sums) {
          return draw(SideId::at(s), i, sums);
        },
        [this](const BatchMeans&) { return whole_error(); }, context, "light");
  }

  // sqrt(sum of A variance / sum of A H²) over sides and bands.
  double whole_error() const {
    double variance = 0.0;
    double squared_light = 0.0;
    for (std::size_t i = 0; i < means_.elements(); ++i)
      for (std::size_t b = 0; b < bands_; ++b) {
        variance += area(SideId::at(i)) * means_.variance(i, b);
        squared_light += area(SideId::at(i)) * means_.mean(i, b) * means_.mean(i, b);
      }
    return squared_light > 0.0 ? std::sqrt(variance / squared_light) : 0.0;
  }

  double area(SideId side) const { return static_cast<double>(patches_.area[side.patch()]); }
  const BatchMeans& means() const { return means_; }

 private:
  std::uint64_t draw(SideId side, std::uint64_t batch, std::span<double> sums) const {
    const auto patch = side.patch();
    const bool back = side.is_back();
    if (!is_reflecting(patches_, patch, back)) return 0;
    const auto side_key = stream_key(options_.seed, RandomPurpose::traced_sides, side.index());
    const auto key = nth_key(side_key, batch);
    constexpr auto cells = BatchMeans::batch_side;
    const Strata places(key, place, cells), directions(key, direction, cells), lamps(key, lamp_place, cells),
        choices(key, lamp_choice, cells);

    std::vector<double> weight(bands_);
    std::uint64_t rays = 0;
    for (std::uint32_t i = 0; i < BatchMeans::batch_paths; ++i) {
      const auto of_path = path_key(key, i);
      const auto u = uniform4(of_path, ~std::uint64_t{0});
      const auto v = uniform4(of_path, ~std::uint64_t{1});
      const auto at = places.pair(i, u[0], u[1]);
      const auto out = directions.pair(i, u[2], u[3]);
      const auto on_lamp = lamps.pair(i, v[0], v[1]);
      const VertexNumbers first{{out.x, out.y}, {choices.number(i, v[2]), on_lamp.x, on_lamp.y}};
      const auto trail = paths_.irradiance(surface_point(patches_, patch, back, uniform_triangle(at.x, at.y)),
                                           first, of_path, options_.bounces_from, weight, sums.first(bands_));
      rays += trail.rays;
      add_fate(trail, sums.subspan(bands_));
    }
    return rays;
  }

  void add_fate(const LightPaths::Trail& trail, std::span<double> fate) const {
    const auto& hit = trail.first;
    const auto sky_patch = hit ? 0 : patches_.sky_patches.patch_of(trail.direction);
    const bool is_lost = hit && !is_reflecting(patches_, hit.patch, hit.back);
    for (std::size_t b = 0; b < bands_; ++b) {
      const auto through = in_band(trail.through, b);
      fate[in_panes * bands_ + b] += 1.0 - through;
      if (is_lost) fate[lost * bands_ + b] += through;
      if (hit) continue;
      fate[escaped * bands_ + b] += through;
      fate[from_sky * bands_ + b] += through * patches_.sky_radiosity(sky_patch, b);
    }
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
  for (auto* array : {&s.irradiance.front, &s.irradiance.back, &s.radiosity.front, &s.radiosity.back,
                      &s.standard_error.front, &s.standard_error.back})
    array->assign(patches.size() * bands, 0.0f);
  for (std::size_t index = 0; index < side_count(patches.size()); ++index) {
    const auto side = SideId::at(index);
    const bool back = side.is_back();
    const auto wide = widening_of(sides.means().batches(side.index()));
    for (std::size_t b = 0; b < bands; ++b) {
      const auto i = side.patch() * bands + b;
      const auto H = sides.means().mean(side.index(), b);
      const auto error = wide * std::sqrt(sides.means().variance(side.index(), b));
      const auto emittance = back ? 0.0f : patches.emittance(side.patch(), b);
      const auto h = static_cast<float>(H);
      s.irradiance.of(back)[i] = h;
      s.radiosity.of(back)[i] = emittance + patches.reflectance(side.patch(), b) * h;
      if (const auto tau = patches.diffuse_transmittance(side.patch(), b); tau > 0.0f)
        s.radiosity.of(back)[i] += tau * static_cast<float>(sides.means().mean(side.opposite().index(), b));
      s.standard_error.of(back)[i] = static_cast<float>(error);
    }
  }
  s.error_95th = error_95th_of(s);
}

void fill_power(const PatchSet& patches, const SideMeans& sides, PathReport& report) {
  const auto bands = patches.band_count();
  for (auto* part : {&report.emitted, &report.from_sky, &report.absorbed, &report.escaped,
                     &report.lost_at_backs, &report.in_panes})
    part->assign(bands, 0.0);
  for (std::size_t i = 0; i < side_count(patches.size()); ++i) {
    const auto side = SideId::at(i);
    for (std::size_t b = 0; b < bands; ++b) {
      const auto H = sides.means().mean(side.index(), b);
      const auto rho = static_cast<double>(patches.reflectance(side.patch(), b));
      const auto emitted =
          side.is_back() ? 0.0 : sides.area(side) * static_cast<double>(patches.emittance(side.patch(), b));
      const auto tau = static_cast<double>(patches.diffuse_transmittance(side.patch(), b));
      const auto far = tau > 0.0 ? sides.means().mean(side.opposite().index(), b) : 0.0;
      const auto leaves = emitted + sides.area(side) * (rho * H + tau * far);
      report.emitted[b] += emitted;
      const auto fraction = [&](Fate fate) {
        return sides.means().mean(side.index(), bands * (1 + fate) + b);
      };
      report.from_sky[b] += sides.area(side) * fraction(from_sky);
      report.absorbed[b] += sides.area(side) * (1.0 - rho - tau) * H;
      report.escaped[b] += leaves * fraction(escaped);
      report.lost_at_backs[b] += leaves * fraction(lost);
      report.in_panes[b] += leaves * fraction(in_panes);
    }
  }
}

}  // namespace

PathReport trace_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                       const PathOptions& options, const Context& context) {
  SideMeans sides(patches, tracer, options);
  PathReport report;
  report.stop = sides.run(context);
  report.complete = sides.means().complete();
  report.rays = sides.means().rays();
  report.paths = sides.means().batches(0) * BatchMeans::batch_paths;
  report.predicted_error = sides.whole_error();
  solution.bands = patches.bands;
  fill_light(patches, sides, solution);
  fill_power(patches, sides, report);
  const auto suns = sun_power(patches, tracer, context);
  for (std::size_t b = 0; b < suns.size(); ++b) report.from_sky[b] += suns[b];
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
