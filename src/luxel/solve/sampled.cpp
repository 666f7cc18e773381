// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampled.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "luxel/patch/patch_tree.h"
#include "luxel/report/error.h"
#include "luxel/solve/dark_sides.h"
#include "luxel/solve/direct_samples.h"
#include "luxel/solve/gauss_seidel.h"
#include "luxel/solve/replicate_spread.h"
#include "luxel/solve/sample_plan.h"
#include "luxel/solve/share_light.h"
#include "luxel/solve/stochastic_jacobi.h"
#include "luxel/transport/direct_light.h"
#include "luxel/transport/patch_emitter.h"
#include "luxel/transport/sampled_operator.h"

namespace luxel {
namespace {

constexpr std::uint64_t least_rays = 1 << 17;  // of the first round, direct and gathered each
constexpr std::uint32_t unit_positions = 64;   // whose samples are doubled together
constexpr double shadow_ray_cost = 0.6;        // of a gather ray and its share of the sweeps
constexpr double growth_to_error = 3.0;        // a round costs at most so many times all before it
constexpr double growth_to_bound = 1.0;  // likewise, where rays or time may end it: not too far from there
constexpr double weight_before_sharing = 0.3;

void check(const PatchSet& patches, const SampledOptions& options) {
  if (!(options.error >= 0.0))
    throw InputError(fmt::format("error must be 0 or more, not {}", options.error));
  if (options.replicates < 4 || options.replicates > 32)
    throw InputError(fmt::format("replicates must be 4 to 32, not {}", options.replicates));
  if (options.error == 0.0 && options.rays == 0 && options.seconds == 0.0)
    throw InputError("an error of 0 is never reached: a bound of rays or time is needed too");
  check_lamps(patches);
}

std::uint32_t power_of_two_from(double least) {
  std::uint32_t n = 1;
  while (n < 1024 && n < least) n *= 2;
  return n;
}

// The whole run: its samples so far, and the answer they give.
class Run {
 public:
  Run(const PatchSet& patches, const Tracer& tracer, Solution& solution, const SampledOptions& options,
      const Workers& workers, const Monitor& monitor)
      : patches_(patches),
        tracer_(tracer),
        solution_(solution),
        options_(options),
        workers_(workers),
        monitor_(monitor),
        bands_(patches.band_count()),
        lamps_(patches),
        direct_light_(patches, tracer, lamps_,
                      {.seed = options.seed,
                       .replicates = options.replicates,
                       .low_discrepancy = options.low_discrepancy,
                       .stratified = options.stratified,
                       .importance = options.importance,
                       .control_variate = options.control_variate}) {}

  SolveReport go() {
    if (!first_light()) return report_;
    begin();
    while (true) {
      answer();
      if (tell(monitor_, progress()) == Next::stop) return finish(StopReason::stopped_by_user);
      // An error of nothing is an estimate that failed, or light that is exact.
      if (options_.error > 0.0 && error_ <= options_.error && (error_ > 0.0 || report_.rounds.size() > 1))
        return finish(StopReason::error_reached);
      const auto units = sample_units();
      const auto doublings = next_round(units);
      if (*std::max_element(doublings.begin(), doublings.end()) == 0)
        return finish(StopReason::error_reached);
      if (const auto bound = broken_bound(units, doublings)) return finish(*bound);
      if (!sample(doublings)) return finish(StopReason::stopped_by_user);
    }
  }

 private:
  // ---- The first picture: a few rays shot from the lamps ----

  bool first_light() {
    const auto rays = std::clamp<std::uint64_t>(2 * patches_.size(), 50'000, 1'000'000);
    const auto shot =
        solve_stochastic_jacobi(patches_, tracer_, solution_,
                                {.rays = rays, .tolerance = 0.03, .seed = options_.seed}, workers_, monitor_);
    report_ = shot;
    report_.steps.clear();
    traced_ = shot.rays;
    const auto answer = tell(monitor_, {"light", 0.01, traced_, 0.0, &solution_});
    if (shot.stop == StopReason::stopped_by_user || answer == Next::stop) {
      report_.stop = solution_.stop = StopReason::stopped_by_user;
      return false;
    }
    return true;
  }

  // ---- Samples ----

  // The first rays of every side. Those that no light reaches are left out from then on.
  void begin() {
    tree_ = make_patch_tree(patches_, workers_);
    transport_.emplace(patches_, all_gather_sides(patches_, tree_), tracer_,
                       SampledOperatorOptions{.seed = options_.seed,
                                              .replicates = options_.replicates,
                                              .low_discrepancy = options_.low_discrepancy,
                                              .stratified = options_.stratified});
    direct_.emplace(direct_light_, transport_->sides(), options_.replicates, bands_);
    const auto first = power_of_two_from(static_cast<double>(least_rays) /
                                         static_cast<double>(slots() * options_.replicates));
    std::vector<std::uint32_t> all(slots());
    std::iota(all.begin(), all.end(), 0u);
    traced_ += direct_->double_samples(all, first, workers_);
    traced_ += transport_->double_rays(all, first, workers_).value();
    leave_out_dark_sides();
    units_ = make_units();
    const auto count = slots() * bands_;
    reflectance_.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      reflectance_[i] = patches_.material_of(side(i / bands_) / 2).reflectance[i % bands_];
    irradiance_.assign(options_.replicates, std::vector<float>(count, 0.0f));
    // The iteration starts from the first picture.
    std::vector<float> start(transport_->elements() * bands_, 0.0f);
    for (std::size_t i = 0; i < count; ++i) {
      const auto s = side(i / bands_);
      const auto& H = s % 2 == 0 ? solution_.irradiance_front : solution_.irradiance_back;
      start[i] = reflectance_[i] * H[s / 2 * bands_ + i % bands_];
    }
    radiosity_.assign(options_.replicates, start);
  }

  std::size_t slots() const { return transport_->sides().size(); }
  std::size_t side(std::size_t slot) const { return transport_->sides().side[slot]; }

  void leave_out_dark_sides() {
    const auto lit = lit_slots(patches_, *transport_, solution_, direct_->irradiance(), workers_);
    report_.dark_sides = static_cast<std::uint64_t>(std::count(lit.begin(), lit.end(), 0));
    if (report_.dark_sides == 0) return;
    transport_->keep(lit, workers_);
    direct_->keep(lit, transport_->sides());
  }

  // Where units begin, and at the end the number of slots.
  std::vector<std::uint32_t> make_units() const {
    const auto& sides = transport_->sides();
    std::vector<std::uint32_t> begins;
    for (std::uint32_t s = 0; s < slots(); ++s)
      if (s == 0 || s == sides.fronts ||
          sides.position[s] / unit_positions != sides.position[s - 1] / unit_positions)
        begins.push_back(s);
    begins.push_back(static_cast<std::uint32_t>(slots()));
    return begins;
  }

  // What the samples of direct light (first) and gathered light (then) cost and leave to be desired.
  std::vector<SampleUnit> sample_units() const {
    const auto n = units_.size() - 1;
    std::vector<SampleUnit> units(2 * n);
    const auto book = [&](SampleUnit& unit, std::size_t u, const std::vector<double>& error2_of,
                          double samples, double cost) {
      for (auto s = units_[u]; s < units_[u + 1]; ++s) unit.error2 += error2_of[s];
      unit.error2 = std::max(0.0, unit.error2);
      unit.cost = cost * samples * options_.replicates * (units_[u + 1] - units_[u]);
    };
    for (std::size_t u = 0; u < n; ++u) {
      book(units[u], u, direct_error2_, direct_->samples_a_slot()[units_[u]], shadow_ray_cost);
      book(units[n + u], u, gathered_error2_, transport_->rays_a_slot()[units_[u]], 1.0);
    }
    // Together they are the whole squared error.
    double sum = 0.0;
    for (const auto& u : units) sum += u.error2;
    for (auto& u : units) u.error2 *= spread_.error2 / std::max(sum, 1e-300);
    return units;
  }

  // The samples of the next round: doublings of each unit. What they are does not depend on the bounds, so
  // that a longer run goes the same way.
  std::vector<std::uint8_t> next_round(std::span<const SampleUnit> units) const {
    const bool bounded = options_.rays > 0 || options_.seconds > 0.0;
    double spent = 0.0;
    for (const auto& u : units) spent += u.cost;
    return plan_doublings(units, options_.error * options_.error * spread_.light2,
                          (bounded ? growth_to_bound : growth_to_error) * spent);
  }

  // The bound that those samples would break, if any.
  std::optional<StopReason> broken_bound(std::span<const SampleUnit> units,
                                         std::span<const std::uint8_t> doublings) const {
    double spent = 0.0;
    double more = 0.0;
    double rays = 0.0;
    for (std::size_t u = 0; u < units.size(); ++u) {
      const auto cost = units[u].cost * ((1 << doublings[u]) - 1);
      spent += units[u].cost;
      more += cost;
      rays += u < units.size() / 2 ? cost / shadow_ray_cost : cost;
    }
    if (options_.rays > 0 && static_cast<double>(traced_) + rays > static_cast<double>(options_.rays))
      return StopReason::ray_limit;
    if (options_.seconds > 0.0 && elapsed() * (1.0 + more / spent) > options_.seconds)
      return StopReason::time_limit;
    return {};
  }

  bool sample(const std::vector<std::uint8_t>& doublings) {
    const auto n = units_.size() - 1;
    for (std::uint8_t turn = 0; turn < *std::max_element(doublings.begin(), doublings.end()); ++turn) {
      std::vector<std::uint32_t> direct;
      std::map<std::uint32_t, std::vector<std::uint32_t>> gathered;  // by rays so far
      for (std::size_t u = 0; u < n; ++u)
        for (auto s = units_[u]; s < units_[u + 1]; ++s) {
          if (doublings[u] > turn) direct.push_back(s);
          if (doublings[n + u] > turn) gathered[transport_->rays_a_slot()[s]].push_back(s);
        }
      traced_ += direct_->double_samples(direct, 0, workers_);
      for (auto& [rays, slots] : gathered) {
        const auto traced = transport_->double_rays(std::move(slots), 0, workers_, progress_monitor());
        if (!traced) return false;
        traced_ += *traced;
      }
    }
    return true;
  }

  // ---- The answer ----

  void answer() {
    RoundRecord round;
    auto direct = direct_->irradiance();
    std::vector<std::vector<float>> gathered(options_.replicates);
    for (std::uint32_t r = 0; r < options_.replicates; ++r) {
      const auto solved = gauss_seidel(transport_->replicate(r), direct[r], reflectance_, radiosity_[r],
                                       irradiance_[r], {}, workers_);
      round.sweeps = std::max(round.sweeps, static_cast<int>(solved.change.size()));
      round.residual = std::max(round.residual, solved.distance);
      gathered[r].resize(irradiance_[r].size());
      for (std::size_t i = 0; i < gathered[r].size(); ++i) gathered[r][i] = irradiance_[r][i] - direct[r][i];
    }
    const auto area = [this](std::size_t slot) { return static_cast<double>(patches_.area[side(slot) / 2]); };
    std::vector<float> bias(slots() * bands_, 0.0f);
    std::vector<float> gathered_bias(slots() * bands_, 0.0f);
    // What guides the next samples: the spread after sharing, and some of the spread before, which knows more
    // degrees of freedom. Not the bias: its estimate is so noisy that to go by it would spoil it.
    const std::vector<float> none(bias.size(), 0.0f);
    const auto spread_before = [&](const std::vector<std::vector<float>>& values) {
      auto error2 = spread_of(values, none, bands_, area, workers_).error2_of;
      for (auto& e : error2) e *= weight_before_sharing;
      return error2;
    };
    direct_error2_ = spread_before(direct);
    gathered_error2_ = spread_before(gathered);
    if (options_.share) {
      share_light(patches_, tree_, transport_->sides(), direct, bias, workers_);
      share_light(patches_, tree_, transport_->sides(), gathered, gathered_bias, workers_);
    }
    const auto add_spread = [&](std::vector<double>& to, const std::vector<std::vector<float>>& fitted) {
      const auto error2 = spread_of(fitted, none, bands_, area, workers_).error2_of;
      for (std::size_t s = 0; s < error2.size(); ++s) to[s] += (1.0 - weight_before_sharing) * error2[s];
    };
    add_spread(direct_error2_, direct);
    add_spread(gathered_error2_, gathered);
    for (std::size_t i = 0; i < bias.size(); ++i) bias[i] += gathered_bias[i];
    for (std::size_t r = 0; r < gathered.size(); ++r)
      for (std::size_t i = 0; i < bias.size(); ++i) gathered[r][i] += direct[r][i];
    spread_ = spread_of(gathered, bias, bands_, area, workers_);
    error_ = spread_.light2 > 0.0 ? std::sqrt(std::max(0.0, spread_.error2) / spread_.light2) : 0.0;

    round.gather_rays = static_cast<std::uint32_t>(options_.replicates * mean(transport_->rays_a_slot()));
    round.shadow_rays = static_cast<std::uint32_t>(options_.replicates * mean(direct_->samples_a_slot()));
    round.rays = traced_;
    round.error = error_;
    report_.rounds.push_back(round);
    fill();
  }

  double mean(std::span<const std::uint32_t> counts) const {
    return std::accumulate(counts.begin(), counts.end(), 0.0) /
           std::max<double>(1.0, static_cast<double>(counts.size()));
  }

  double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

  // ---- What the caller gets ----

  void fill() {
    const auto count = patches_.size() * bands_;
    auto& s = solution_;
    for (auto* array : {&s.irradiance_front, &s.irradiance_back, &s.radiosity_front, &s.radiosity_back,
                        &s.standard_error_front, &s.standard_error_back})
      array->assign(count, 0.0f);
    for (std::size_t p = 0; p < patches_.size(); ++p)
      for (std::size_t b = 0; b < bands_; ++b)
        s.radiosity_front[p * bands_ + b] = patches_.material_of(p).emittance[b];
    for (std::size_t i = 0; i < slots() * bands_; ++i) {
      const bool back = side(i / bands_) % 2 == 1;
      const auto at = side(i / bands_) / 2 * bands_ + i % bands_;
      const auto H = std::max(0.0f, spread_.mean[i]);
      (back ? s.irradiance_back : s.irradiance_front)[at] = H;
      (back ? s.radiosity_back : s.radiosity_front)[at] += reflectance_[i] * H;
      (back ? s.standard_error_back : s.standard_error_front)[at] = spread_.standard_error[i];
    }
    s.bands = patches_.bands;
    s.unshot_share = 0.0;
    s.predicted_error = error_;
    s.error_95th = spread_.percentile_95;
    s.provenance.method = "sampled";
    s.provenance.seed = options_.seed;
    s.provenance.rays = traced_;
    s.provenance.scene_fingerprint = patches_.scene_fingerprint;
  }

  SolveReport finish(StopReason reason) {
    report_.stop = solution_.stop = reason;
    report_.rays = solution_.provenance.rays = traced_;
    report_.unshot_share = 0.0;
    report_.predicted_error = error_;
    report_.error_95th = spread_.percentile_95;
    return report_;
  }

  Progress progress() const {
    const auto done = error_ > 0.0 ? std::min(1.0, options_.error * options_.error / (error_ * error_)) : 0.0;
    return {"light", done, traced_, error_, &solution_};
  }
  Monitor progress_monitor() const {
    return [this](const Progress& p) {
      return tell(monitor_, {"light", progress().done, traced_ + p.rays, error_});
    };
  }

  const PatchSet& patches_;
  const Tracer& tracer_;
  Solution& solution_;
  const SampledOptions& options_;
  const Workers& workers_;
  const Monitor& monitor_;
  std::size_t bands_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Lamps lamps_;
  DirectLight direct_light_;
  PatchTree tree_;
  std::optional<SampledOperator> transport_;
  std::optional<DirectSamples> direct_;
  std::vector<std::uint32_t> units_;            // where they begin, slots
  std::vector<float> reflectance_;              // [slot][band]
  std::vector<std::vector<float>> radiosity_;   // [replicate], reflected, W/m², [element][band]
  std::vector<std::vector<float>> irradiance_;  // [replicate], W/m², [slot][band]
  Spread spread_;
  std::vector<double> direct_error2_, gathered_error2_;  // [slot]: parts of the squared error
  double error_ = 0.0;                                   // of the whole
  std::uint64_t traced_ = 0;
  SolveReport report_;
};

}  // namespace

SolveReport solve_sampled(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                          const SampledOptions& options, const Workers& workers, const Monitor& monitor) {
  check(patches, options);
  return Run(patches, tracer, solution, options, workers, monitor).go();
}

}  // namespace luxel
