// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampled.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/core/memory.h"
#include "luxel/core/work_partition.h"
#include "luxel/patch/check_light.h"
#include "luxel/patch/side.h"
#include "luxel/solve/ray_allocation.h"
#include "luxel/solve/replicate_solve.h"
#include "luxel/solve/run_progress.h"
#include "luxel/solve/sampled_light.h"
#include "luxel/solve/sampling.h"
#include "luxel/solve/seen_measure.h"
#include "luxel/solve/survey_sides.h"
#include "luxel/solve/tuning.h"
#include "luxel/trace/sun_power.h"

namespace luxel {
namespace {

using namespace tuning::first_light;

// Tolerance of the iteration. A thousandth of the error target is below a hundredth everywhere, and light
// after a change of lamps does not differ visibly. It is the same for every answer, so that a resumed run
// repeats an uninterrupted one.
double tolerance_for(double error) { return error > 0.0 ? std::clamp(0.001 * error, 1e-6, 1e-5) : 3e-6; }

void check(const PatchSet& patches, const SampledOptions& options) {
  if (!(options.error >= 0.0))
    throw InputError(fmt::format("error must be 0 or more, not {}", options.error));
  if (options.replicates < 4 || options.replicates > 32)
    throw InputError(fmt::format("replicates must be 4 to 32, not {}", options.replicates));
  if (options.error == 0.0 && options.rays == 0 && options.ray_budget == 0 && options.seconds == 0.0)
    throw InputError("an error of 0 is never reached: a bound of rays or time is needed too");
  check_light(patches);
}

constexpr double cheap_part = 0.5;  // of the error, where it is cheap: see SampledOptions::cheap_rays

double mean(std::span<const std::uint32_t> counts) {
  const auto sum = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  return static_cast<double>(sum) / static_cast<double>(std::max<std::size_t>(1, counts.size()));
}

// A whole run: samples, the solution they give, and the test of its accuracy.
class Run {
 public:
  Run(const PatchSet& patches, const Tracer& tracer, Solution& solution, const SampledOptions& options,
      const SolveHooks& hooks, const Context& context)
      : patches_(patches),
        tracer_(tracer),
        solution_(solution),
        options_(options),
        context_(context),
        hooks_(hooks),
        progress_(options, hooks, context),
        bands_(patches.band_count()) {}

  SolveReport go() {
    if (hooks_.from) {
      restore(*hooks_.from);
    } else {
      if (!show_first_light()) return finish(StopReason::stopped_by_user);
      sampling_.emplace(patches_, tracer_, options_, context_);
      if (!sampling_->start(solution_, sampling_monitor())) return finish(StopReason::stopped_by_user);
      prepare();
      begin_iteration();
    }
    if (receivers() == 0) {  // the sky reaches no receiver
      light_->write(answer_, solution_, context_);
      sign();
      if (hooks_.halves) hooks_.halves->fill(solution_);
      return finish(StopReason::nothing_to_do);
    }
    while (true) {
      keep_state();
      if (!answer()) return finish(StopReason::stopped_by_user);
      if (kept_) hooks_.keep(kept_);
      if (progress_.is_stopped(progress_.report(rays(), &solution_)))
        return finish(StopReason::stopped_by_user);
      if (is_good_enough()) return finish(StopReason::error_reached);
      const auto units = sample_units();
      const auto rounds = rounds_before_ + report_.rounds.size();
      const auto plan = plan_round(
          units, {direct_units(), std::max(0.0, whole_squared_error()), aimed_squared_error(), rounds == 1},
          options_);
      predict_memory(units);
      if (plan.is_empty()) return finish(StopReason::error_reached);
      if (const auto bound = broken_bound(plan, options_, rays(), progress_.common_elapsed()))
        return finish(*bound);
      progress_.begin_round(plan);
      if (!sampling_->take(plan.doublings, sampling_monitor())) return finish(StopReason::stopped_by_user);
    }
  }

 private:
  // Shoots a few rays for a first picture, then more that start the iteration and are not shown.
  bool show_first_light() {
    const auto first = glance(patches_);
    return shoot_light(first.rays, first.tolerance, 0) &&
           progress_.report(rays(), &solution_) == Next::go_on &&
           shoot_light(side_count(patches_.size()), second_tolerance, 1);
  }

  bool shoot_light(std::uint64_t rays, double bias, std::uint32_t picture) {
    const auto before = first_rays_;
    const auto on_the_way = [&](const Progress& p) { return progress_.report(before + p.rays); };
    const auto seed = stream_key(options_.seed, RandomPurpose::first_pictures, picture);
    const auto shot = solve_stochastic_jacobi(
        patches_, tracer_, solution_, {.rays = rays, .tolerance = bias, .seed = seed, .shows_bounces = false},
        context_.with_monitor(on_the_way));
    report_.energy = shot.energy;
    report_.back_loss = shot.back_loss;
    report_.unshot_fraction = shot.unshot_fraction;
    report_.predicted_error = shot.predicted_error;
    first_rays_ += shot.rays;
    sign();
    return shot.stop != StopReason::stopped_by_user;
  }

  // The start of the iteration: the radiosities of the shot light.
  void begin_iteration() {
    radiosity_ = dark_but_for_sky(sampling_->hits(), patches_);
    const auto irradiance = [&](std::size_t i) {
      const auto from = side(i / bands_);
      return solution_.irradiance.of(from)[from.patch() * bands_ + i % bands_];
    };
    const auto count = receivers() * bands_;
    for (std::size_t i = 0; i < count; ++i)
      radiosity_[i] = radiosity_[count + i] = light_->scattering().sent_on(irradiance, i, bands_);
  }

  void restore(const SampleState& state) {
    sampling_.emplace(patches_, tracer_, options_, context_);
    sampling_->restore(state);
    prepare();
    if (state.radiosity.size() != (receivers() + sampling_->hits().elements()) * bands_)
      throw MismatchError("the kept radiosities are not of these patches");
    radiosity_ = state.radiosity;
    rounds_before_ = state.rounds_done;
    first_rays_ = state.first_rays;
  }

  void keep_state() {
    if (!hooks_.keep) return;
    auto state = std::make_shared<SampleState>(sampling_->state());
    state->radiosity = radiosity_;
    state->rounds_done = rounds_before_ + static_cast<std::uint32_t>(report_.rounds.size());
    state->first_rays = first_rays_;
    kept_ = std::move(state);
  }

  void prepare() {
    const auto& sides = sampling_->hits().sides();
    not_found_.emplace(patches_, sampling_->hits(), sampling_->units(), context_);
    light_.emplace(patches_, sampling_->tree(), sides, options_.smoothing, context_);
    if (options_.error_measure == ErrorMeasure::seen && sides.size() > 0) {
      seen_.emplace(patches_, sides, sampling_->units(), tracer_, context_);
      report_.views = seen_->views().stating.size();
      report_.places = seen_->views().places;
      if (!seen_->has_views()) seen_.reset();
    }
    area_.assign(light_->area().begin(), light_->area().end());
    report_.unreached_sides = sampling_->unreached_sides();
    report_.unshot_fraction = 0.0;
  }

  std::size_t receivers() const { return sampling_->hits().sides().size(); }
  SideId side(std::size_t receiver) const { return sampling_->hits().sides().side[receiver]; }

  // ---- The solution ----

  // Returns false, and keeps the previous solution, if the monitor stops the work.
  bool answer() {
    const auto begin_seconds = progress_.elapsed();
    progress_.begin_answer();
    auto direct =
        sum_of_groups(sampling_->direct().irradiance(), patches_.group_count(), bands_, {}, context_);
    transport_.reset();
    transport_ = sampling_->transport();
    auto solved = solve_replicates(
        *transport_, direct, light_->scattering(), radiosity_, tolerance_for(finest_target()),
        context_.with_monitor([this](const Progress&) { return progress_.report(rays()); }));
    if (solved.is_stopped) return false;
    progress_.end_iteration();
    auto& gathered = solved.gathered;
    gathered_ = mean_of(gathered, context_);
    const auto enough = [&](const Spread& own) { return error_by_measure(own) <= finest_target(); };
    answer_ =
        light_->answer(direct, gathered, not_found_->variance(), enough, context_, [&](bool is_smoothed) {
          direct_squared_error_ = squared_errors(direct, bands_, context_);
          gathered_squared_error_ = squared_errors(gathered, bands_, context_);
          if (is_smoothed) return;
          own_gathered_squared_error_ = gathered_squared_error_;
          report_.means = measure_surfaces(patches_, sampling_->hits().sides(), direct, gathered, context_);
        });
    if (seen_) seen_->take(answer_, direct, gathered, context_);
    error_ = seen_ ? seen_->error() : error_of(answer_);

    RoundRecord round;
    round.sweeps = static_cast<int>(solved.iteration.change.size());
    round.residual = solved.iteration.distance;
    round.gather_rays =
        static_cast<std::uint32_t>(options_.replicates * mean(sampling_->hits().rays_per_receiver()));
    round.shadow_rays =
        static_cast<std::uint32_t>(options_.replicates * mean(sampling_->direct().samples_per_receiver()));
    round.rays = rays();
    round.seconds = progress_.elapsed();
    round.answer_seconds = round.seconds - begin_seconds;
    round.error = error_;
    round.power_error = error_of(answer_);
    round.uncertainty = uncertainty();
    report_.rounds.push_back(round);
    report_.streamed = sampling_->hits().is_streamed();
    report_.predicted_error = error_of(answer_);
    report_.seen_error = seen_ ? error_ : 0.0;
    report_.error_uncertainty = uncertainty();
    light_->write(answer_, solution_, context_);
    sign();
    if (hooks_.halves) write_halves(direct, gathered);
    progress_.aim_at(target());
    progress_.end_answer(error_, safe_error(), cost_of_samples(*sampling_, options_.replicates), rays());
    return true;
  }

  void write_halves(Replicates direct, Replicates gathered) {
    for (std::size_t half = 0; half < 2; ++half) {
      const auto first = transport_->half_begin(half);
      const auto count = transport_->half_begin(half + 1) - first;
      auto& solution = (*hooks_.halves)[half];
      light_->write(
          light_->answer_of_part(direct.subspan(first, count), gathered.subspan(first, count), context_),
          solution, context_);
      solution.provenance = solution_.provenance;
      solution.seen_error = std::sqrt(2.0) * solution_.seen_error;
    }
  }

  // ---- Accuracy, and the next samples ----

  // An error of 0 after one round means a failed estimate or exact light.
  bool is_good_enough() const {
    return options_.error > 0.0 && safe_error() <= target() &&
           (error_ > 0.0 || rounds_before_ + report_.rounds.size() > 1);
  }
  // The error at which the run ends: half of the requested one where that is cheap. It follows from the
  // answer alone, so that a resumed run decides alike.
  double target() const {
    const auto growth = safe_error() / (cheap_part * options_.error);
    const auto needed = static_cast<double>(rays()) * growth * growth;
    return needed <= static_cast<double>(options_.cheap_rays) ? cheap_part * options_.error : options_.error;
  }
  // The smallest that it may be, before the error is known.
  double finest_target() const {
    return rays() <= options_.cheap_rays ? cheap_part * options_.error : options_.error;
  }
  double error_by_measure(const Spread& answer) const {
    return seen_ ? seen_->error_of(answer) : error_of(answer);
  }
  double uncertainty() const { return seen_ ? seen_->uncertainty() : 0.0; }
  // Includes the uncertainty of the estimate, so that a low estimate by chance does not end the run.
  double safe_error() const { return error_ * (1.0 + uncertainty()); }
  // The sum of the squared errors of all units, and its target.
  double whole_squared_error() const {
    return seen_ ? safe_error() * safe_error() : answer_.total_squared_error;
  }
  double aimed_squared_error() const {
    return tuning::rounds::aim * target() * target() * (seen_ ? 1.0 : answer_.total_squared_light);
  }

  // Returns the variance of each receiver's irradiance, [receiver].
  std::span<const double> importance() const { return seen_ ? seen_->importance() : area_; }
  std::size_t direct_units() const { return sampling_->units().size() - 1; }

  std::vector<SampleUnit> sample_units() const {
    const auto of_own_noise = importance_of_own_noise(sampling_->units(), importance(),
                                                      own_gathered_squared_error_, gathered_squared_error_);
    const auto gather_squared_error = gather_errors(patches_, *transport_,
                                                    {sampling_->units(), of_own_noise, radiosity_, gathered_,
                                                     weighted_sum(importance(), gathered_squared_error_)},
                                                    context_);
    return make_sample_units(*sampling_, options_.replicates, importance(), direct_squared_error_,
                             gather_squared_error, std::max(0.0, whole_squared_error()));
  }

  // After the first round: the predicted peak memory of the process, if the error decreases as planned.
  void predict_memory(std::span<const SampleUnit> units) {
    if (report_.rounds.size() > 1) return;
    double hits = 0.0;
    if (!sampling_->hits().is_streamed()) {
      const auto doublings = plan_doublings(units, aimed_squared_error(), 0.0, 1e30);
      for (auto u = direct_units(); u < units.size(); ++u) hits += units[u].cost * (1 << doublings[u]);
    }
    report_.memory = begin_memory_ + sampling_->bytes_of_state() +
                     2 * sizeof(std::uint32_t) * static_cast<std::uint64_t>(hits);
  }

  std::uint64_t rays() const { return first_rays_ + (sampling_ ? sampling_->rays() : 0); }

  // ---- Reports to the caller ----

  SolveReport finish(StopReason reason) {
    if (!report_.rounds.empty()) {
      const auto energy = energy_of(patches_, *transport_, answer_.mean, context_);
      report_.energy = energy.balance;
      const auto suns = sun_power(patches_, tracer_, context_);
      for (std::size_t b = 0; b < suns.size(); ++b) report_.energy.from_sky[b] += suns[b];
      report_.back_loss = energy.back_loss;
    }
    report_.stop = reason;
    report_.rays = rays();
    report_.own_rays =
        (sampling_ ? sampling_->own_rays() : 0) + first_rays_ / SharedWork(context_).processes();
    report_.error_95th = solution_.error_95th;
    solution_.stop = reason;
    sign();
    return report_;
  }

  // Fills the error estimates of the solution.
  void sign() {
    solution_.bands = patches_.bands;
    solution_.unshot_fraction = report_.unshot_fraction;
    solution_.predicted_error = report_.predicted_error;
    solution_.seen_error = report_.seen_error;
    solution_.provenance.method = "sampled";
    solution_.provenance.seed = options_.seed;
    solution_.provenance.rays = rays();
    solution_.provenance.scene_fingerprint = patches_.scene_fingerprint;
  }

  Monitor sampling_monitor() {
    return [this](const Progress& p) { return progress_.report(std::max(rays(), first_rays_ + p.rays)); };
  }

  const PatchSet& patches_;
  const Tracer& tracer_;
  Solution& solution_;
  const SampledOptions& options_;
  const Context& context_;
  const SolveHooks& hooks_;
  RunProgress progress_;
  std::size_t bands_;
  std::optional<Sampling> sampling_;
  std::unique_ptr<const SampledOperator> transport_;  // operator of the rays of the last answer
  std::uint64_t first_rays_ = 0;
  std::uint32_t rounds_before_ = 0;  // of the resumed run
  std::shared_ptr<const SampleState> kept_;
  std::optional<SampledLight> light_;
  std::optional<SkyNotFound> not_found_;
  std::vector<float> radiosity_;     // reflected, and of the sky, W/m², [element][band]
  std::optional<SeenMeasure> seen_;  // used where the seen error ends the run
  std::vector<double> area_;         // [receiver], m²
  SampledLight::Answer answer_;
  std::vector<float> gathered_;  // before smoothing, W/m², [receiver * bands + band]
  // [receiver]: variances of direct and gathered light summed over bands; of gathered light also before
  // smoothing.
  std::vector<double> direct_squared_error_, gathered_squared_error_, own_gathered_squared_error_;
  double error_ = 0.0;                              // by the measure that ends the run
  std::uint64_t begin_memory_ = resident_memory();  // bytes of the process
  SolveReport report_;
};

}  // namespace

SolveReport solve_sampled(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                          const SampledOptions& options, const SolveHooks& hooks, const Context& context) {
  check(patches, options);
  return Run(patches, tracer, solution, options, hooks, context).go();
}

}  // namespace luxel
