// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/stochastic_jacobi.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "luxel/report/error.h"
#include "luxel/transport/patch_emitter.h"
#include "luxel/transport/shooting.h"

namespace luxel {
namespace {

constexpr std::size_t grain = 4096;  // patches a chunk

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

void check(const PatchSet& patches, const StochasticJacobiOptions& options) {
  if (!(options.tolerance > 0.0 && options.tolerance < 1.0))
    throw InputError(fmt::format("tolerance must be between 0 and 1, not {}", options.tolerance));
  check_lamps(patches);
}

// The state of the iteration: power that arrived so far, and power that is still to be shot.
class Iteration {
 public:
  Iteration(const PatchSet& patches, const Tracer& tracer, const StochasticJacobiOptions& options,
            const Workers& workers)
      : patches_(patches),
        tracer_(tracer),
        options_(options),
        workers_(workers),
        bands_(patches.band_count()),
        arrived_(2 * patches.size() * bands_, 0.0),
        unshot_(arrived_.size(), 0.0) {
    report_.energy.emitted = emitted_power(patches);
    emitted_ = sum(report_.energy.emitted);
    for (auto* part : {&report_.energy.absorbed, &report_.energy.escaped, &report_.energy.lost_at_backs})
      part->assign(bands_, 0.0);
    report_.back_loss.assign(patches.materials.size(), 0.0);
    for (const auto& material : patches.materials)
      reflectance_.insert(reflectance_.end(), material.reflectance.begin(), material.reflectance.end());
    for (std::size_t p = 0; p < patches.size(); ++p)
      for (std::size_t b = 0; b < bands_; ++b)
        unshot_[side_of(p, false) * bands_ + b] =
            static_cast<double>(patches.area[p]) * patches.material_of(p).emittance[b];
    unshot_power_ = sum_unshot();
    report_.unshot_share = 1.0;
  }

  void run(const Monitor& monitor) {
    const auto first_step_rays =
        options_.rays > 0 ? options_.rays : automatic_rays(patches_, options_.rays_per_patch);
    while (report_.unshot_share > options_.tolerance) {
      const auto wanted = std::round(report_.unshot_share * static_cast<double>(first_step_rays));
      const auto share = step(static_cast<std::uint64_t>(std::max(1.0, wanted)), monitor);
      if (share < 1.0) return finish(StopReason::stopped_by_user);
    }
    finish(StopReason::converged);
  }

  SolveReport& report() { return report_; }
  void fill(Solution& solution) const;

 private:
  // One bounce. Returns the share of it that was done before the monitor said stop.
  double step(std::uint64_t rays, const Monitor& monitor) {
    // The bar of the whole run: unshot power falls geometrically, and the rays follow it.
    const auto before = report_.unshot_share;
    const auto reflected = guess_reflected_share();
    const auto tell_whole = [&](const Progress& p) {
      const auto here = before * (1.0 - p.done * (1.0 - reflected));
      return tell(monitor, {p.stage, std::clamp(1.0 - here, 0.0, 1.0), report_.rays + p.rays});
    };
    const auto arrival =
        shoot(patches_, tracer_, unshot_,
              {.rays = rays, .seed = options_.seed, .step = static_cast<std::uint32_t>(report_.steps.size())},
              workers_, tell_whole);
    report_.rays += arrival.rays;
    if (arrival.share > 0.0) receive(arrival, unshot_power_ / static_cast<double>(arrival.rays));
    report_.steps.push_back({arrival.rays, report_.unshot_share});
    return arrival.share;
  }

  // Books what arrived, in quanta of that many watts (all bands together); what is reflected of it becomes
  // the new unshot power. Arrivals are a Poisson count of quanta q: the irradiance H of a side of area A has
  // variance q H / A.
  void receive(const Arrival& arrival, double quantum) {
    auto& energy = report_.energy;
    const auto watts = [&](std::int64_t units) { return arrival.scale.watts(units) / arrival.share; };
    // Sums per chunk, added in order: the same bits on any number of threads.
    std::vector<double> absorbed((patches_.size() + grain - 1) / grain * bands_, 0.0);
    std::vector<double> irradiance((patches_.size() + grain - 1) / grain, 0.0);
    workers_.for_chunks(patches_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
      auto* chunk_absorbed = &absorbed[begin / grain * bands_];
      for (auto p = begin; p < end; ++p) {
        const auto* rho = &reflectance_[static_cast<std::size_t>(patches_.material[p]) * bands_];
        for (auto i = side_of(p, false) * bands_; i < side_of(p + 1, false) * bands_; ++i) {
          const auto b = i % bands_;
          const auto power = watts(arrival.arrived[i]);
          arrived_[i] += power;
          unshot_[i] = rho[b] * power;
          chunk_absorbed[b] += (1.0 - rho[b]) * power;
          irradiance[begin / grain] += power / static_cast<double>(patches_.area[p]);
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
    unshot_power_ = sum_unshot();
    report_.unshot_share = unshot_power_ / emitted_;
  }

  double sum_unshot() const {
    return ordered_sum(workers_, unshot_.size(), [this](std::size_t i) { return unshot_[i]; });
  }

  double guess_reflected_share() const {
    const auto n = report_.steps.size();
    if (n == 0) return 0.5;
    const auto before = n > 1 ? report_.steps[n - 2].unshot_share : 1.0;
    return std::clamp(report_.steps[n - 1].unshot_share / before, 0.0, 0.99);
  }

  void finish(StopReason reason) {
    report_.stop = reason;
    report_.energy.unshot.assign(bands_, 0.0);
    for (std::size_t i = 0; i < unshot_.size(); ++i) report_.energy.unshot[i % bands_] += unshot_[i];
    report_.predicted_error = predicted_error();
  }

  // Area-weighted relative RMS: sqrt(sum of A Var(H) / sum of A H²).
  double predicted_error() const {
    double square = 0.0;
    for (std::size_t s = 0; s < 2 * patches_.size(); ++s) {
      double power = 0.0;
      for (std::size_t b = 0; b < bands_; ++b) power += arrived_[s * bands_ + b];
      square += power * power / static_cast<double>(patches_.area[s / 2]);
    }
    return square > 0.0 ? std::sqrt(variance_ / square) : 0.0;
  }

  const PatchSet& patches_;
  const Tracer& tracer_;
  const StochasticJacobiOptions& options_;
  const Workers& workers_;
  std::size_t bands_;
  std::vector<double> reflectance_;  // [material][band]
  std::vector<double> arrived_;      // W, [side][band]
  std::vector<double> unshot_;       // W, [side][band]
  double unshot_power_ = 0.0;        // W, all bands: the sum of unshot_
  double emitted_ = 0.0;             // W, all bands
  double variance_ = 0.0;            // sum over sides of area times the variance of the irradiance, W²/m²
  SolveReport report_;
};

void Iteration::fill(Solution& solution) const {
  solution.bands = patches_.bands;
  const auto count = patches_.size() * bands_;
  for (auto* array : {&solution.irradiance_front, &solution.irradiance_back, &solution.radiosity_front,
                      &solution.radiosity_back})
    array->assign(count, 0.0f);
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const auto& material = patches_.material_of(p);
    for (std::size_t b = 0; b < bands_; ++b) {
      const auto i = p * bands_ + b;
      const double area = patches_.area[p];
      const double rho = material.reflectance[b];
      const auto front = arrived_[side_of(p, false) * bands_ + b] / area;
      const auto back = arrived_[side_of(p, true) * bands_ + b] / area;
      solution.irradiance_front[i] = static_cast<float>(front);
      solution.irradiance_back[i] = static_cast<float>(back);
      solution.radiosity_front[i] = static_cast<float>(material.emittance[b] + rho * front);
      solution.radiosity_back[i] = static_cast<float>(rho * back);
    }
  }
}

}  // namespace

std::vector<double> emitted_power(const PatchSet& patches) {
  std::vector<double> power(patches.band_count(), 0.0);
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t b = 0; b < power.size(); ++b)
      power[b] += static_cast<double>(patches.area[p]) * patches.material_of(p).emittance[b];
  return power;
}

void check_lamps(const PatchSet& patches) {
  if (sum(emitted_power(patches)) > 0.0) return;
  throw InputError(
      "the scene has no lamp: give a material a 'Ke R G B' line (radiance, W/(m² sr)) in its MTL file, and "
      "use that material on at least one face");
}

std::uint64_t automatic_rays(const PatchSet& patches, double rays_per_patch) {
  // In a closed scene of mean reflectance rho every watt is shot 1 / (1 - rho) times.
  double area = 0.0;
  double reflected = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto& rho = patches.material_of(p).reflectance;
    area += patches.area[p];
    reflected +=
        patches.area[p] * std::accumulate(rho.begin(), rho.end(), 0.0) / static_cast<double>(rho.size());
  }
  const auto once = std::max(0.05, 1.0 - reflected / area);
  return static_cast<std::uint64_t>(
      std::max(100'000.0, rays_per_patch * static_cast<double>(patches.size()) * once));
}

SolveReport solve_stochastic_jacobi(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                                    const StochasticJacobiOptions& options, const Workers& workers,
                                    const Monitor& monitor) {
  check(patches, options);
  Iteration iteration(patches, tracer, options, workers);
  iteration.run(monitor);
  iteration.fill(solution);
  const auto& report = iteration.report();
  solution.unshot_share = report.unshot_share;
  solution.predicted_error = report.predicted_error;
  solution.stop = report.stop;
  solution.provenance.method = "stochastic-jacobi";
  solution.provenance.seed = options.seed;
  solution.provenance.rays = report.rays;
  solution.provenance.scene_fingerprint = patches.scene_fingerprint;
  return report;
}

}  // namespace luxel
