// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/stochastic_jacobi.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "luxel/classical/shooting.h"
#include "luxel/core/error.h"
#include "luxel/core/work_partition.h"
#include "luxel/lamps/side_power.h"
#include "luxel/lamps/sky_box.h"
#include "luxel/patch/check_light.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr std::size_t grain = 4096;  // patches per chunk

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

void check(const PatchSet& patches, const StochasticJacobiOptions& options) {
  if (!(options.tolerance > 0.0 && options.tolerance < 1.0))
    throw InputError(fmt::format("tolerance must be between 0 and 1, not {}", options.tolerance));
  check_light(patches);
}

// State of the iteration: power that has arrived, and power still to be shot.
class Iteration {
 public:
  Iteration(const PatchSet& patches, const Tracer& tracer, const StochasticJacobiOptions& options,
            const Context& context, const LightSink& on_light)
      : patches_(patches),
        options_(options),
        context_(context),
        on_light_(on_light),
        bands_(patches.band_count()),
        shooter_(patches, tracer, context),
        arrived_(side_count(patches.size()) * bands_, 0.0),
        unshot_(lamp_power(patches)) {
    auto& energy = report_.energy;
    energy.emitted = emitted_power(patches);
    emitted_ = carried_once_ = sum(energy.emitted);
    for (auto* part :
         {&energy.from_sky, &energy.absorbed, &energy.escaped, &energy.lost_at_backs, &energy.in_panes})
      part->assign(bands_, 0.0);
    report_.back_loss.assign(patches.materials.size(), 0.0);
    unshot_power_ = sum(unshot_.watts);
    report_.unshot_fraction = 1.0;
    if (patches.has_sky()) add_sky(patches, tracer);
  }

  void run(Solution& solution) {
    const auto first_step_rays =
        options_.rays > 0 ? options_.rays : automatic_rays(patches_, options_.rays_per_patch);
    while (report_.unshot_fraction > options_.tolerance) {
      const auto wanted = std::round(unshot_power_ / carried_once_ * static_cast<double>(first_step_rays));
      const auto fraction = step(static_cast<std::uint64_t>(std::max(1.0, wanted)));
      if (fraction < 1.0 || show(solution) == Next::stop) return finish(StopReason::stopped_by_user);
    }
    finish(StopReason::converged);
  }

  SolveReport& report() { return report_; }
  void fill(Solution& solution);

 private:
  // The sky is shot in the first step. The part that arrives is estimated only to choose the number of rays.
  void add_sky(const PatchSet& patches, const Tracer& tracer) {
    constexpr double min_fraction = 1.0 / 16.0;
    const SkyBox box(patches);
    add_sky_power(patches, box, unshot_);
    const auto lamps = unshot_power_;
    unshot_power_ = sum(unshot_.watts);
    const auto hits = sky_hit_fraction(patches, tracer, box);
    carried_once_ += (hits > 0.0 ? std::max(min_fraction, hits) : 1.0) * (unshot_power_ - lamps);
  }

  // Publishes the light of all bounces so far.
  Next show(Solution& solution) {
    if (!options_.shows_bounces || !(on_light_ || context_.monitor()))
      return SharedWork(context_).broadcast(Next::go_on);
    fill(solution);
    const Progress progress{"light", 1.0 - report_.unshot_fraction, report_.rays, report_.predicted_error};
    if (on_light_) on_light_(solution, progress);
    return SharedWork(context_).broadcast(context_.report(progress));
  }

  // One bounce. Returns the fraction of it that was done before the monitor stopped it.
  double step(std::uint64_t rays) {
    // Progress of the whole run: unshot power decreases geometrically, and the number of rays in proportion.
    const auto before = report_.unshot_fraction;
    const auto reflected = guessed_reflected_fraction();
    const auto tell_whole = [&](const Progress& p) {
      const auto here = before * (1.0 - p.done * (1.0 - reflected));
      return context_.report({p.stage, std::clamp(1.0 - here, 0.0, 1.0), report_.rays + p.rays});
    };
    auto arrival = shooter_.shoot(
        unshot_,
        {.rays = rays, .seed = options_.seed, .step = static_cast<std::uint32_t>(report_.steps.size())},
        tell_whole);
    report_.rays += arrival.rays;
    add_far_sides(arrival);
    if (arrival.fraction > 0.0) receive(arrival, unshot_power_ / static_cast<double>(arrival.rays));
    report_.steps.push_back({arrival.rays, report_.unshot_fraction});
    return arrival.fraction;
  }

  // Enters the sides of diffusers to which nothing came but through the patch.
  void add_far_sides(Arrival& arrival) const {
    if (!patches_.has_diffusers()) return;
    const auto met = std::exchange(arrival.side, {});
    const auto arrived = std::exchange(arrival.arrived, {});
    const auto add = [&](SideId side, std::size_t e) {
      arrival.side.push_back(side);
      for (std::size_t b = 0; b < bands_; ++b)
        arrival.arrived.push_back(e < met.size() ? arrived[e * bands_ + b] : 0);
    };
    for (std::size_t e = 0; e < met.size(); ++e) {
      const bool diffuses = patches_.material_of(met[e].patch()).is_diffuser();
      if (diffuses && met[e].is_back() && (e == 0 || met[e - 1] != met[e].opposite()))
        add(met[e].opposite(), met.size());
      add(met[e], e);
      if (diffuses && !met[e].is_back() && (e + 1 == met.size() || met[e + 1] != met[e].opposite()))
        add(met[e].opposite(), met.size());
    }
  }

  // Adds the arrived power, in quanta of that many watts (all bands together); the reflected part becomes the
  // new unshot power. Arrivals are a Poisson count of quanta q: the irradiance H of a side of area A has the
  // variance q H / A.
  void receive(const Arrival& arrival, double quantum) {
    auto& energy = report_.energy;
    const auto watts = [&](std::int64_t units) { return arrival.scale.watts(units) / arrival.fraction; };
    unshot_.side = arrival.side;
    unshot_.watts.resize(arrival.arrived.size());
    // Sums per chunk, added in order: the same bits on any number of threads.
    const auto chunks = (patches_.size() + grain - 1) / grain;
    std::vector<double> absorbed(chunks * bands_, 0.0);
    std::vector<double> irradiance(chunks, 0.0);
    std::vector<double> unshot(chunks, 0.0);
    context_.for_chunks(patches_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
      const auto chunk = begin / grain;
      const auto range = entries_between(arrival.side, SideId(begin, false), SideId(end, false));
      for (auto e = range.begin; e < range.end; ++e) {
        const auto side = arrival.side[e];
        for (std::size_t b = 0; b < bands_; ++b) {
          const auto power = watts(arrival.arrived[e * bands_ + b]);
          const double rho = patches_.reflectance(side.patch(), b);
          const double tau = patches_.diffuse_transmittance(side.patch(), b);
          auto reflected = rho * power;
          if (tau > 0.0)  // the entries of both sides follow each other
            reflected += tau * watts(arrival.arrived[(side.is_back() ? e - 1 : e + 1) * bands_ + b]);
          arrived_[side.index() * bands_ + b] += power;
          unshot_.watts[e * bands_ + b] = reflected;
          unshot[chunk] += reflected;
          absorbed[chunk * bands_ + b] += (1.0 - rho - tau) * power;
          irradiance[chunk] += power / static_cast<double>(patches_.area[side.patch()]);
        }
      }
    });
    variance_ += quantum * sum(irradiance);
    for (std::size_t i = 0; i < absorbed.size(); ++i) energy.absorbed[i % bands_] += absorbed[i];
    for (std::size_t b = 0; b < bands_; ++b) energy.escaped[b] += watts(arrival.escaped[b]);
    for (std::size_t m = 0; m < patches_.materials.size(); ++m)
      for (std::size_t b = 0; b < bands_; ++b) {
        energy.lost_at_backs[b] += watts(arrival.absorbed[m * bands_ + b]);
        report_.back_loss[m] += watts(arrival.absorbed[m * bands_ + b]);
      }
    for (std::size_t b = 0; b < bands_; ++b) {
      energy.from_sky[b] += watts(arrival.from_sky[b]);
      emitted_ += watts(arrival.from_sky[b]);
    }
    unshot_power_ = sum(unshot);
    report_.unshot_fraction = emitted_ > 0.0 ? unshot_power_ / emitted_ : 0.0;
  }

  double guessed_reflected_fraction() const {
    const auto n = report_.steps.size();
    if (n == 0) return 0.5;
    const auto before = n > 1 ? report_.steps[n - 2].unshot_fraction : 1.0;
    return std::clamp(report_.steps[n - 1].unshot_fraction / before, 0.0, 0.99);
  }

  void finish(StopReason reason) {
    report_.stop = reason;
    report_.energy.unshot.assign(bands_, 0.0);
    // The power that the sky has not sent yet is not part of the unshot power.
    for (std::size_t i = 0; i < unshot_.watts.size(); ++i)
      if (unshot_.side[i / bands_].index() < side_count(patches_.size()))
        report_.energy.unshot[i % bands_] += unshot_.watts[i];
  }

  const PatchSet& patches_;
  const StochasticJacobiOptions& options_;
  const Context& context_;
  const LightSink& on_light_;
  std::size_t bands_;
  Shooter shooter_;
  std::vector<double> arrived_;  // W, [side][band]
  SidePower unshot_;
  double unshot_power_ = 0.0;  // W, all bands: the sum of unshot_
  double emitted_ = 0.0;       // W, all bands: by lamps, and by the sky in the steps so far
  double carried_once_ = 0.0;  // W, all bands: power that the requested rays carry once
  double variance_ = 0.0;      // sum over sides of area times the variance of the irradiance, W²/m²
  SolveReport report_;
};

// The light so far, its energy balance, and the predicted error, an area-weighted relative RMS: sqrt(sum of A
// Var(H) / sum of A H²).
void Iteration::fill(Solution& solution) {
  solution.bands = patches_.bands;
  const std::array arrays = {&solution.irradiance.front, &solution.irradiance.back, &solution.radiosity.front,
                             &solution.radiosity.back};
  context_.for_chunks(arrays.size(), 1, [&](std::size_t i, std::size_t, int) {
    arrays[i]->assign(patches_.size() * bands_, 0.0f);
  });
  std::vector<double> squares((patches_.size() + grain - 1) / grain, 0.0);
  context_.for_chunks(patches_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto p = begin; p < end; ++p) {
      const double area = patches_.area[p];
      double front_power = 0.0;
      double back_power = 0.0;
      for (std::size_t b = 0; b < bands_; ++b) {
        const auto i = p * bands_ + b;
        const double rho = patches_.reflectance(p, b);
        const auto front = arrived_[SideId(p, false).index() * bands_ + b];
        const auto back = arrived_[SideId(p, true).index() * bands_ + b];
        front_power += front;
        back_power += back;
        solution.irradiance.front[i] = static_cast<float>(front / area);
        solution.irradiance.back[i] = static_cast<float>(back / area);
        auto front_sent = rho * (front / area), back_sent = rho * (back / area);
        if (const double tau = patches_.diffuse_transmittance(p, b); tau > 0.0) {
          front_sent += tau * (back / area);
          back_sent += tau * (front / area);
        }
        solution.radiosity.front[i] = static_cast<float>(patches_.emittance(p, b) + front_sent);
        solution.radiosity.back[i] = static_cast<float>(back_sent);
      }
      squares[begin / grain] += (front_power * front_power + back_power * back_power) / area;
    }
  });
  const auto square = sum(squares);
  report_.predicted_error = square > 0.0 ? std::sqrt(variance_ / square) : 0.0;

  solution.unshot_fraction = report_.unshot_fraction;
  solution.predicted_error = report_.predicted_error;
  solution.stop = report_.stop;
  solution.provenance.method = "stochastic-jacobi";
  solution.provenance.seed = options_.seed;
  solution.provenance.rays = report_.rays;
  solution.provenance.scene_fingerprint = patches_.scene_fingerprint;
}

}  // namespace

std::vector<double> emitted_power(const PatchSet& patches) {
  std::vector<double> power(patches.band_count(), 0.0);
  const auto lamps = lamp_power(patches);
  for (std::size_t i = 0; i < lamps.watts.size(); ++i) power[i % power.size()] += lamps.watts[i];
  for (const auto& lamp : patches.point_lights)
    for (std::size_t b = 0; b < power.size(); ++b)
      power[b] += emitting_angle(lamp.light) * static_cast<double>(lamp.intensity[b]);
  return power;
}

std::uint64_t automatic_rays(const PatchSet& patches, double rays_per_patch) {
  // In a closed scene of mean reflectance rho every watt is shot 1 / (1 - rho) times.
  double area = 0.0;
  double reflected = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    area += patches.area[p];
    double rho = 0.0;
    for (std::size_t b = 0; b < patches.band_count(); ++b) rho += double{patches.albedo(p, b)};
    reflected += patches.area[p] * (rho / static_cast<double>(patches.band_count()));
  }
  const auto once = std::max(0.05, 1.0 - reflected / area);
  return static_cast<std::uint64_t>(
      std::max(100'000.0, rays_per_patch * static_cast<double>(patches.size()) * once));
}

StochasticJacobiOptions glance(const PatchSet& patches) {
  constexpr std::uint64_t min_rays = 50'000;
  constexpr std::uint64_t max_rays = 250'000;
  return {.rays = std::clamp<std::uint64_t>(side_count(patches.size()), min_rays, max_rays),
          .tolerance = 0.2};
}

SolveReport solve_stochastic_jacobi(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                                    const StochasticJacobiOptions& options, const Context& context,
                                    const LightSink& on_light) {
  check(patches, options);
  Iteration iteration(patches, tracer, options, context, on_light);
  iteration.run(solution);
  iteration.fill(solution);
  return iteration.report();
}

}  // namespace luxel
