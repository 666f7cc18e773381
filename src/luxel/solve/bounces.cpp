// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/bounces.h"

#include <cassert>
#include <memory>
#include <numeric>
#include <vector>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/solve/replicate_solve.h"
#include "luxel/solve/sampled_light.h"
#include "luxel/solve/sampling.h"

namespace luxel {
namespace {

constexpr std::size_t grain = 16384;  // numbers per chunk

}  // namespace

struct Bounces::State {
  const PatchSet& patches;
  const Context& context;
  SampledOptions options;
  std::uint64_t rays;
  Sampling sampling;
  std::unique_ptr<const SampledOperator> transport;
  std::vector<float> direct;      // D, [receiver * bands + band], W/m²
  std::vector<float> irradiance;  // H
  std::vector<float>
      reflected;  // what was sent on in the bounce before, and the sky, [row or sink of CrossedHalves][band]
  std::vector<float> area;
  ScatteringTable scattering;
  int bounces = 0;
  double unshot = 0.0;  // W

  State(const PatchSet& of_run, const Tracer& tracer, const SampleState& state,
        const SampledOptions& run_options, const Context& run_context)
      : patches(of_run),
        context(run_context),
        options(run_options),
        rays(state.rays + state.first_rays),
        sampling(of_run, tracer, run_options, run_context) {
    sampling.restore(state);
    transport = sampling.transport();
    direct = mean_of(sum_of_groups(state.direct, patches.group_count(), patches.band_count(), {}, context),
                     context);
    const SampledLight receivers(patches, sampling.tree(), sampling.hits().sides(), false, context);
    area.assign(receivers.area().begin(), receivers.area().end());
    scattering = scattering_of(patches, sampling.hits().sides(), context);
    begin();
  }

  void begin() {
    bounces = 0;
    unshot = 0.0;
    irradiance.assign(direct.size(), 0.0f);
    reflected = dark_but_for_sky(sampling.hits(), patches);
  }

  void bounce() {
    const auto bands = patches.band_count();
    const auto count = irradiance.size();
    std::vector<float> rows(2 * count);
    const CrossedHalves crossed(*transport, bands);
    crossed.apply(reflected, rows, 0, crossed.size(), context);
    context.for_chunks(count, grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) irradiance[i] = direct[i] + 0.5f * (rows[i] + rows[count + i]);
    });
    const auto sends = scattering.view();
    unshot = ordered_sum(context, count, [&](std::size_t i) {
      const auto before =
          0.5 * (static_cast<double>(reflected[i]) + static_cast<double>(reflected[count + i]));
      return static_cast<double>(area[i / bands]) *
             (static_cast<double>(sends.sent_on(irradiance, i, bands)) - before);
    });
    context.for_chunks(count, grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i)
        for (const auto row : {i, count + i}) rows[row] += direct[i];
    });
    context.for_chunks(count, grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i)
        for (const std::size_t half : {0, 1})
          reflected[half * count + i] =
              sends.sent_on(std::span<const float>(rows).subspan(half * count, count), i, bands);
    });
    ++bounces;
  }

  Solution solution() const {
    const auto bands = patches.band_count();
    Solution s;
    s.bands = patches.bands;
    for (auto* array : {&s.irradiance.front, &s.irradiance.back, &s.radiosity.front, &s.radiosity.back})
      array->assign(patches.size() * bands, 0.0f);
    for (std::size_t i = 0; i < s.radiosity.front.size(); ++i)
      s.radiosity.front[i] = patches.emittance(i / bands, i % bands);
    const auto& sides = sampling.hits().sides();
    for (std::size_t i = 0; i < irradiance.size(); ++i) {
      const auto side = sides.side[i / bands];
      const auto at = side.patch() * bands + i % bands;
      s.irradiance.of(side)[at] = irradiance[i];
      s.radiosity.of(side)[at] += scattering.view().sent_on(irradiance, i, bands);
    }
    const auto emitted = emitted_power(patches);
    const auto power = std::accumulate(emitted.begin(), emitted.end(), 0.0);
    if (power > 0.0 && !patches.has_sky()) s.unshot_fraction = bounces == 0 ? 1.0 : unshot / power;
    s.stop = StopReason::step_limit;
    s.provenance.method = "sampled";
    s.provenance.seed = options.seed;
    s.provenance.rays = rays;
    s.provenance.scene_fingerprint = patches.scene_fingerprint;
    return s;
  }
};

Bounces::Bounces(const PatchSet& patches, const Tracer& tracer, const SampleState& state,
                 const SampledOptions& options, const Context& context)
    : state_(std::make_unique<State>(patches, tracer, state, options, context)) {}

Bounces::~Bounces() = default;

Solution Bounces::light(int bounces) {
  assert(bounces >= 0);
  auto& s = *state_;
  if (bounces < s.bounces) s.begin();
  while (s.bounces < bounces) s.bounce();
  return s.solution();
}

}  // namespace luxel
