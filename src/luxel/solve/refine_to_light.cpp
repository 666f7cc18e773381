// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/refine_to_light.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/patch/refine_patches.h"
#include "luxel/solve/cut_patches.h"
#include "luxel/solve/level_difference.h"
#include "luxel/solve/mesh_estimate.h"
#include "luxel/solve/part_light.h"
#include "luxel/solve/refine_progress.h"
#include "luxel/solve/seen_measure.h"
#include "luxel/solve/trial_cuts.h"
#include "luxel/trace/tracer.h"

namespace luxel {
namespace {

// Error to which light is solved over the mesh error target; and the largest error of it, seen and of the
// power: the same light in most rooms.
constexpr double light_fraction = 2.0;
constexpr double poorest_seen = 0.1, poorest_power = 0.03;
constexpr double aim = 0.8;  // of the allowed squared error: the target of the next mesh
// By how much errors are too small whose estimates have decided about cuts: where noise made them small they
// were kept, where it made them large they were replaced. Against the light solved again: 2.7 and 3.1 in two
// rooms after 4 and 6 cuts; 0.8 after one.
constexpr std::size_t selected = 3;
// By how much they are too small besides where no solve confirms them: 1.36 of it because half is taken for
// what the residual of a patch shows, where 0.27 is right, and the rest because the importance of a unit is
// too low for its dim patches, as at contacts. On nine meshes the estimates that decided are 0.7 to 1.6 times
// what light that was solved well on them shows.
constexpr double unconfirmed = 1.92;
// Fraction of the estimated error that may stay in uncut patches in one pass, and patches to cut at least:
// small steps follow an edge of light to where it is, rather than around it.
constexpr double max_unrefined_fraction = 0.7;
constexpr double usual_step = 0.05, step_of_large_meshes = 0.01;  // fractions of the patches
constexpr std::size_t large_step = 500;                           // at which the one gives way to the other
// Trial cuts: rays of the first trial over those of the first light; of a later trial over those of the first
// trial; and the squared error found over the squared target from which on another trial follows.
constexpr double trial_part = 2.0 / 3.0, later_trials = 0.25, min_found = 0.02;
constexpr int max_trials = 5;
constexpr double min_gain = 0.1;  // of the squared error in patches that are cut, for another level
// patches over those before, for another level, where the cost has a bound
constexpr double min_level = 1.01;
// Estimated error over that of the level before, up to which more than the usual patches pay.
constexpr double max_left_by_level = 0.6;
// At most, of a solve, where the cost has a bound: some scenes do not come near their error.
constexpr double part_of_free_rays = 0.4;
constexpr std::uint64_t rays_per_side = 64;
constexpr double rays_exponent = 1.15;  // squared error of a solve ~ rays^-rays_exponent

void check(const RefineOptions& options) {
  if (!(options.mesh_error > 0.0))
    throw InputError(fmt::format("mesh_error must be above 0, not {}", options.mesh_error));
  if (options.max_levels < 1)
    throw InputError(fmt::format("max_levels must be 1 or more, not {}", options.max_levels));
}

// A mesh with its light.
struct Level {
  PatchSet patches;
  Answers answers;
  double sampling_error = 0.0;  // of the light that was solved, of both answers together
  std::uint64_t rays = 0;
};

class Refinement {
  using Clock = std::chrono::steady_clock;

 public:
  Refinement(PatchSet patches, const RefineOptions& options, RefineReport& report, const Context& context)
      : options_(options),
        report_(report),
        context_(context),
        progress_(options.later_error, options.later_ray_budget, context) {
    options_.smooth.lights_hidden = false;  // that light is for the eye, and no answer of the solver
    options_.usual_patches = std::min(options.usual_patches, options.max_patches);
    now_.patches = std::move(patches);
  }

  PatchSet go() {
    if (!look(
            cut_large_patches(now_.patches, options_.light.error_measure, options_.usual_patches, context_)))
      return end(RefineStop::stopped_by_user);
    bound_cost();
    if (!cut_on_trial()) return end(RefineStop::stopped_by_user);
    double error_before = 0.0;  // estimated for the mesh before
    for (int level = 0;; ++level) {
      if (is_met()) {
        if (cuts_ == 0 || is_cost_bounded()) return end(RefineStop::mesh_error_reached);
        if (!look_again()) return end(RefineStop::stopped_by_user);
        continue;
      }
      // The next level costs about as much as the last one that was cut.
      const bool is_within = is_within_cost(report_.levels.size() > 1 ? report_.levels.back().rays : 0);
      const bool pays = level == 0 || estimate_.error() <= max_left_by_level * error_before;
      const bool is_last = !is_within || (!pays && now_.patches.size() >= options_.usual_patches);
      error_before = estimate_.error();
      const auto marks = marked_by_difference(is_last);
      if (!is_worth_a_level(marks)) return end(RefineStop::drowned_in_noise);
      if (level == options_.max_levels) return end(RefineStop::level_limit);
      auto refined = cut_marked(marks, pays || is_last ? options_.max_patches : options_.usual_patches);
      if (!refined) return end(RefineStop::patch_limit);
      if (is_last)
        return end_unseen(std::move(*refined), is_within ? RefineStop::patch_limit : RefineStop::cost_limit);
      if (is_cost_bounded() &&
          static_cast<double>(refined->patches.size()) < min_level * static_cast<double>(now_.patches.size()))
        return end_unseen(std::move(*refined), RefineStop::patch_limit);
      if (!look(std::move(*refined))) return end(RefineStop::stopped_by_user);
      ++cuts_;
    }
  }

 private:
  PatchSet end(RefineStop stop) {
    report_.stop = stop;
    report_.mesh_error = report_.levels.empty() ? 0.0 : report_.levels.back().mesh_error;
    if (stop == RefineStop::stopped_by_user) report_.light = mean_of(now_.answers);
    return std::move(now_.patches);
  }

  // Ends with a mesh on which no light is solved: its error is the prediction that it was cut by.
  PatchSet end_unseen(RefinedPatches refined, RefineStop stop) {
    estimate_.predict_cut(refined.parent);
    const auto sampling_error = report_.levels.back().sampling_error;
    report_.levels.push_back({refined.patches.size(), mesh_error(), sampling_error, 0});
    now_ = {std::move(refined.patches), {}, 0.0, 0};
    return end(stop);
  }

  double mesh_error() const { return excess_after(cuts_) * estimate_.error(); }

  // Estimates that a solve still confirms are believed until then.
  bool is_met() const {
    return (is_cost_bounded() ? report_.levels.back().mesh_error : estimate_.error()) <= options_.mesh_error;
  }

  // By how much estimates are too small that have decided about this number of cuts.
  double excess_after(std::size_t cuts) const {
    const auto excess = static_cast<double>(std::clamp<std::size_t>(cuts, 1, selected));
    return is_cost_bounded() ? unconfirmed * excess : excess;
  }

  // Where the cost has a bound, no solve confirms the last mesh: the rays for it are better spent on the
  // light itself. Meshes came out the same.
  bool is_cost_bounded() const { return options_.max_cost > 0.0; }

  // Returns whether the marked patches, which differ by more than noise, have enough of the error.
  bool is_worth_a_level(const std::vector<std::uint8_t>& marks) const {
    double marked = 0.0, all = 0.0;
    for (std::size_t p = 0; p < marks.size(); ++p) {
      all += std::max(0.0, estimate_.squared()[p]);
      if (marks[p] != 0) marked += estimate_.squared()[p];
    }
    return marked > min_gain * all;
  }

  // Bounds the rays of the refinement by those of a later solve, as the first level predicts them.
  void bound_cost() {
    if (!is_cost_bounded()) return;
    const auto& first = report_.levels.front();
    auto later = static_cast<double>(first.rays) *
                 std::pow(first.sampling_error / options_.light.error, 2.0 / rays_exponent);
    const auto budget = static_cast<double>(options_.light.ray_budget);
    if (budget > 0.0) later = std::min(later, budget);
    allowed_rays_ = std::max(options_.max_cost * later, static_cast<double>(options_.free_rays));
  }

  bool is_within_cost(std::uint64_t rays) const {
    return !is_cost_bounded() || static_cast<double>(rays_before_ + rays) <= allowed_rays_;
  }

  // How accurately to solve each mesh: a rough solution suffices while the error is large and another solve
  // follows. Where the cost has a bound, one light is the base of all cuts, and rough light hides what needs
  // cutting: smoothing is wide then.
  double light_error() const {
    if (is_cost_bounded()) return std::max(options_.light.error, options_.mesh_error);
    const auto poorest = options_.light.error_measure == ErrorMeasure::power ? poorest_power : poorest_seen;
    const auto known = report_.levels.empty() ? poorest : report_.levels.back().mesh_error;
    return std::max(options_.light.error,
                    std::min(poorest, std::max(known, light_fraction * options_.mesh_error)));
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  // The monitor of a solve that may take a budget of rays; 0: without a bound.
  Next tell_solve(const Progress& p, std::uint64_t budget) {
    return report_.levels.empty() ? progress_.report_first_mesh(seconds(), p, budget) : tell(p.rays);
  }

  // Reports the present level. rays: since the last answer. The number of levels is not known: always as many
  // rays are expected to follow as the first mesh took.
  Next tell(std::uint64_t rays) const {
    const auto first = static_cast<double>(report_.levels.front().rays);
    const auto all = static_cast<double>(rays_before_ + rays);
    const auto part = all > 0.0 ? (all - first) / all : 0.0;
    return progress_.report_later_mesh(seconds(), part, rays_before_ + rays,
                                       report_.levels.back().mesh_error);
  }
  // Between the steps of a level that trace no rays.
  bool is_stopped() const { return !report_.levels.empty() && tell(0) == Next::stop; }

  // Streams of the present level: 0 of its light, 1 of trial cuts.
  std::uint64_t seed_of(std::uint32_t stream) const {
    return stream_key(options_.light.seed, RandomPurpose::refinement,
                      2 * static_cast<std::uint32_t>(report_.levels.size()) + stream);
  }

  // The answers are the light of the two halves of one solve.
  bool solve(Level& level, const Tracer& tracer) {
    auto how = options_.light;
    how.error = light_error();
    if (is_cost_bounded()) {
      how.ray_budget = 0;
      how.rays =
          std::max(static_cast<std::uint64_t>(part_of_free_rays * static_cast<double>(options_.free_rays)),
                   rays_per_side * side_count(level.patches.size()));
    }
    how.seed = seed_of(0);
    const auto on_the_way = [&](const Progress& p) { return tell_solve(p, how.rays); };
    Solution whole;
    std::array<Solution, 2> halves;
    const auto solved = solve_sampled(level.patches, tracer, whole, how, {.halves = &halves},
                                      context_.with_monitor(on_the_way));
    level.rays += solved.rays;
    rays_before_ += solved.rays;
    if (solved.stop == StopReason::stopped_by_user) return false;
    level.sampling_error = how.error_measure == ErrorMeasure::seen && solved.seen_error > 0.0
                               ? solved.seen_error
                               : solved.predicted_error;
    for (std::size_t i = 0; i < halves.size(); ++i) {
      auto& [solution, smooth] = level.answers[i];
      solution = std::move(halves[i]);
      smooth = make_smooth_light(level.patches, solution, options_.smooth, context_);
    }
    return true;
  }

  // The light of a level that follows another: where patches were cut, rays find what falls on the parts
  // from a scene whose light is known.
  bool gather(Level& level, const Tracer& tracer, std::span<const std::uint32_t> parent) {
    const Cut cut{level.patches, tracer, parent};
    level.sampling_error = now_.sampling_error;
    const auto error = std::max(options_.mesh_error, estimate_.error());
    const auto on_the_way = [this](const Progress& p) { return tell(p.rays); };
    const auto rays = rays_of_parts(cut, inherited_light(mean_of(now_.answers), cut), estimate_.weights(),
                                    error * error / static_cast<double>(side_count(level.patches.size())));
    for (std::size_t i = 0; i < level.answers.size(); ++i)
      level.answers[i].solution = inherited_light(now_.answers[i].solution, cut);
    auto how = options_.light;
    how.seed = seed_of(0);
    const std::array lights = {&level.answers[0].solution, &level.answers[1].solution};
    const auto traced = gather_on_parts(cut, rays, how, lights, context_.with_monitor(on_the_way));
    if (!traced) return false;
    level.rays += *traced;
    rays_before_ += *traced;
    for (auto& [solution, smooth] : level.answers) {
      smooth = make_smooth_light(level.patches, solution, options_.smooth, context_);
      if (is_stopped()) return false;
    }
    return true;
  }

  // Continues with the finer mesh and estimates the error of the coarser one.
  bool look(RefinedPatches refined) {
    const auto& parent = refined.parent;
    const auto bands = refined.patches.band_count();
    Level next;
    next.patches = std::move(refined.patches);
    progress_.begin_mesh(next.patches.size());
    const Tracer tracer(next.patches, context_);
    if (report_.levels.empty() ? !solve(next, tracer) : !gather(next, tracer, parent)) return false;
    // The error estimate with the coarser mesh alone: the noise of both is the same then.
    Answers coarse;
    for (std::size_t i = 0; i < 2; ++i) {
      coarse[i].solution = light_of_wholes(now_.patches, next.patches, next.answers[i].solution, parent);
      coarse[i].smooth = make_smooth_light(now_.patches, coarse[i].solution, options_.smooth, context_);
      if (is_stopped()) return false;
    }
    auto change = difference_of_levels(now_.patches, coarse, next.patches, next.answers, parent, context_);
    estimate_.note_cut(std::move(change), parent, bands);
    now_ = std::move(next);
    estimate(tracer);
    return true;
  }

  // Cuts patches within which light varies as their means do not show. Returns false if the monitor stops the
  // work.
  bool cut_on_trial() {
    if (!is_within_cost(0)) return true;
    std::vector<double> density;
    if (options_.light.error_measure == ErrorMeasure::seen)
      density = seen_densities(now_.patches, Tracer(now_.patches, context_), context_);
    TrialCuts trial(now_.patches.size(), std::move(density));
    const auto context = context_.with_monitor([this](const Progress& p) { return tell(p.rays); });
    const auto target = options_.mesh_error * options_.mesh_error;
    auto max_rays = trial_part * static_cast<double>(report_.levels.front().rays);
    for (int i = 1; i <= max_trials; ++i) {
      auto how = options_.light;
      how.seed = seed_of(1);
      const auto rays = trial.try_out(now_.patches, now_.answers, max_rays, how, context);
      if (!rays) return false;
      rays_before_ += *rays;
      if (i == 1) max_rays *= later_trials;
      const auto squared = trial.squared();
      if (std::accumulate(squared.begin(), squared.end(), 0.0) < min_found * target) return true;
      // Each leaves half of the patches that may be added to those that follow.
      const auto size = now_.patches.size();
      const auto room = options_.usual_patches > size ? options_.usual_patches - size : 0;
      const auto marks = larger_than(target / static_cast<double>(size), squared);
      auto refined = cut_within_limit(now_.patches, marks, squared, size + room / 2, context_);
      if (!refined || refined->patches.size() == size) return true;
      trial.note_cut(refined->parent);
      if (!look(std::move(*refined))) return false;
    }
    return true;
  }

  // Solves the light of the present mesh anew. The estimates until here have decided about cuts: where noise
  // made them small they were kept, where it made them large they were replaced. The new ones have no part in
  // any decision.
  bool look_again() {
    Level again;
    again.patches = now_.patches;
    const Tracer tracer(again.patches, context_);
    if (!solve(again, tracer)) return false;
    cuts_ = 0;
    now_ = std::move(again);
    estimate(tracer);
    return true;
  }

  void estimate(const Tracer& tracer) {
    estimate_.look(now_.patches, now_.answers, tracer, options_.light.error_measure, context_);
    note_level();
  }

  void note_level() {
    report_.levels.push_back({now_.patches.size(), mesh_error(), now_.sampling_error, now_.rays});
  }

  // is_last: no light is found on the next mesh; only the few patches most above noise are cut then.
  std::vector<std::uint8_t> marked_by_difference(bool is_last) const {
    const auto target = options_.mesh_error / (is_cost_bounded() ? excess_after(cuts_ + 1) : 1.0);
    const auto size = static_cast<double>(now_.patches.size());
    const auto few = std::max(step_of_large_meshes * size, std::min(usual_step * size, double{large_step}));
    return estimate_.patches_to_cut(aim * target * target, is_last ? 1.0 : max_unrefined_fraction,
                                    static_cast<std::size_t>(few));
  }

  std::optional<RefinedPatches> cut_marked(std::span<const std::uint8_t> marks, std::size_t limit) const {
    return cut_within_limit(now_.patches, marks, estimate_.squared(), limit, context_);
  }

  RefineOptions options_;
  RefineReport& report_;
  const Context& context_;
  Level now_;
  MeshEstimate estimate_;  // of the present mesh
  std::uint64_t rays_before_ = 0;
  double allowed_rays_ = 0.0;  // see bound_cost(); 0: unknown, or without a bound
  RefineProgress progress_;
  Clock::time_point begin_ = Clock::now();
  std::size_t cuts_ = 0;  // decided by the present estimates
};

}  // namespace

PatchSet refine_to_light(PatchSet patches, const RefineOptions& options, RefineReport& report,
                         const Context& context) {
  check(options);
  report = {};
  return Refinement(std::move(patches), options, report, context).go();
}

}  // namespace luxel
