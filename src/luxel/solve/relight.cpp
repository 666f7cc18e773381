// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/relight.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "luxel/core/error.h"
#include "luxel/solve/own_lighting.h"
#include "luxel/solve/replicate_solve.h"
#include "luxel/solve/sampled_light.h"
#include "luxel/solve/sampling.h"
#include "luxel/solve/seen_measure.h"
#include "luxel/solve/survey_sides.h"

namespace luxel {
namespace {

constexpr double tolerance = 1e-5;   // of the iteration
constexpr std::size_t grain = 4096;  // receivers per chunk

std::size_t sky_index(const PatchSet& patches) {
  return patches.has_sky() ? patches.group_count() - 1 : patches.group_count();
}

// The direct light of one group: [replicate][receiver * bands + band].
std::vector<std::vector<float>> of_group(std::span<const std::vector<float>> light, std::size_t group,
                                         std::size_t groups, std::size_t bands, const Context& context) {
  std::vector<float> alone(groups * bands, 0.0f);
  std::fill_n(alone.begin() + static_cast<std::ptrdiff_t>(group * bands), bands, 1.0f);
  return sum_of_groups(light, groups, bands, alone, context);
}

// Returns nothing where the monitor stops the work.
std::vector<std::vector<float>> solve_groups(const PatchSet& patches, const SampledOperator& transport,
                                             const SampleState& state, const Scattering& scattering,
                                             const Context& context) {
  const auto bands = patches.band_count();
  const auto groups = patches.group_count();
  const auto receivers = transport.sides().size();
  std::vector<std::vector<float>> gathered(state.replicates, std::vector<float>(receivers * groups * bands));
  for (std::size_t g = 0; g < groups; ++g) {
    const auto direct = of_group(state.direct, g, groups, bands, context);
    const bool has_sky = g == sky_index(patches) || (groups == 1 && patches.has_sky());
    auto radiosity = has_sky ? dark_but_for_sky(transport.hits(), patches)
                             : std::vector<float>((receivers + transport.elements()) * bands, 0.0f);
    const auto told = [&](const Progress&) {
      return context.report({"light groups", static_cast<double>(g) / static_cast<double>(groups)});
    };
    const auto light =
        solve_replicates(transport, direct, scattering, radiosity, tolerance, context.with_monitor(told));
    if (light.is_stopped) return {};
    for (std::size_t r = 0; r < gathered.size(); ++r)
      context.for_chunks(receivers, grain, [&](std::size_t begin, std::size_t end, int) {
        for (auto s = begin; s < end; ++s)
          std::copy_n(&light.gathered[r][s * bands], bands, &gathered[r][(s * groups + g) * bands]);
      });
  }
  return gathered;
}

}  // namespace

std::shared_ptr<const SampleState> with_group_light(const PatchSet& patches, const Tracer& tracer,
                                                    std::shared_ptr<const SampleState> state,
                                                    const SampledOptions& options, const Context& context) {
  Sampling sampling(patches, tracer, options, context);
  sampling.restore(*state);
  const SampledLight receivers(patches, sampling.tree(), sampling.hits().sides(), false, context);
  const auto transport = sampling.transport();
  auto more = std::make_shared<SampleState>(*state);
  more->gathered = solve_groups(patches, *transport, *state, receivers.scattering(), context);
  if (more->gathered.empty()) return nullptr;
  return more;
}

struct Relighter::State {
  PatchSet patches;  // as they are now
  OwnLighting own;   // in the run
  Context context;   // reports nothing
  std::shared_ptr<const SampleState> samples;
  SampledOptions options;
  Sampling sampling;
  std::unique_ptr<const SampledOperator> transport;
  std::optional<SampledLight> receivers;
  std::optional<SkyNotFound> not_found;
  std::optional<SeenMeasure> seen;  // where it ended the run
  std::vector<float> weight;
  bool reflects_as_in_run = true;  // so that the light the samples know of each group holds

  State(PatchSet of_run, const Tracer& tracer, std::shared_ptr<const SampleState> kept,
        const SampledOptions& run_options, const Context& run_context)
      : patches(std::move(of_run)),
        own(patches),
        context(run_context.quiet()),
        samples(std::move(kept)),
        options(run_options),
        sampling(patches, tracer, run_options, context),
        weight(patches.group_count() * patches.band_count(), 1.0f) {
    sampling.restore(*samples);
    transport = sampling.transport();
    look_at_surfaces();
    if (options.error_measure == ErrorMeasure::seen && !samples->sides.empty())
      seen.emplace(patches, sampling.hits().sides(), sampling.units(), tracer, context);
    if (seen && !seen->has_views()) seen.reset();
    if (samples->gathered.empty()) {
      auto more = std::make_shared<SampleState>(*samples);
      more->gathered = solve_groups(patches, *transport, *samples, receivers->scattering(), context);
      samples = std::move(more);
    }
    const auto width = sampling.hits().sides().size() * weight.size();
    for (const auto& light : samples->gathered)
      if (samples->gathered.size() != samples->replicates || light.size() != width)
        throw MismatchError("the kept light of the lamps' groups is not of these patches");
  }

  void look_at_surfaces() {
    not_found.emplace(patches, sampling.hits(), sampling.units(), context);
    receivers.emplace(patches, sampling.tree(), sampling.hits().sides(), options.smoothing, context);
  }
};

Relighter::Relighter(PatchSet patches, const Tracer& tracer, std::shared_ptr<const SampleState> state,
                     const SampledOptions& options, const Context& context)
    : state_(std::make_unique<State>(std::move(patches), tracer, std::move(state), options, context)) {}

Relighter::~Relighter() = default;

const PatchSet& Relighter::patches() const { return state_->patches; }

void Relighter::set_lamps(std::vector<float> weight) {
  state_->own.set_lamps(weight, state_->patches);
  state_->weight = std::move(weight);
}

void Relighter::set_reflectance(const std::vector<float>& reflectance) {
  auto& s = *state_;
  s.own.set_reflectance(reflectance, s.patches);
  s.look_at_surfaces();
  s.reflects_as_in_run = reflectance == s.own.reflectance();
}

Solution Relighter::light() const {
  const auto& s = *state_;
  const auto bands = s.patches.band_count();
  const auto groups = s.patches.group_count();
  auto direct = sum_of_groups(s.samples->direct, groups, bands, s.weight, s.context);
  std::vector<std::vector<float>> gathered;
  if (!s.reflects_as_in_run) {
    auto radiosity = dark_but_for_sky(s.sampling.hits(), s.patches);
    gathered =
        solve_replicates(*s.transport, direct, s.receivers->scattering(), radiosity, tolerance, s.context)
            .gathered;
  } else {
    gathered = sum_of_groups(s.samples->gathered, groups, bands, s.weight, s.context);
  }
  const auto enough = [&](const Spread& own) {
    return (s.seen ? s.seen->error_of(own) : error_of(own)) <= s.options.error;
  };
  const auto answer = s.receivers->answer(direct, gathered, s.not_found->variance(), enough, s.context);
  Solution solution;
  s.receivers->write(answer, solution, s.context);
  if (s.seen) solution.seen_error = s.seen->error_of(answer);
  solution.bands = s.patches.bands;
  solution.stop = StopReason::error_reached;
  solution.provenance.method = "sampled";
  solution.provenance.seed = s.options.seed;
  solution.provenance.rays = s.samples->rays + s.samples->first_rays;
  solution.provenance.scene_fingerprint = s.patches.scene_fingerprint;
  return solution;
}

}  // namespace luxel
