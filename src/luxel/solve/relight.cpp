// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/relight.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "luxel/random/address.h"
#include "luxel/report/error.h"
#include "luxel/solve/replicate_solve.h"

namespace luxel {
namespace {

constexpr double tolerance = 1e-6;   // of the iteration, as in the run
constexpr std::size_t grain = 4096;  // slots a chunk

std::size_t sky_index(const PatchSet& patches) {
  return patches.has_sky() ? patches.group_count() - 1 : patches.group_count();
}

// The direct light of one group: [replicate][slot * bands + band].
std::vector<std::vector<float>> of_group(std::span<const std::vector<float>> light, std::size_t group,
                                         std::size_t groups, std::size_t bands) {
  std::vector<float> alone(groups * bands, 0.0f);
  std::fill_n(alone.begin() + static_cast<std::ptrdiff_t>(group * bands), bands, 1.0f);
  return sum_of_groups(light, groups, bands, alone, Workers(1));
}

// The start of an iteration in which the sky shines as given and nothing else yet.
std::vector<float> dark_but_for_sky(const SampledOperator& transport, std::size_t bands,
                                    const std::vector<float>& sky_radiosity) {
  std::vector<float> radiosity(transport.elements() * bands, 0.0f);
  std::copy(sky_radiosity.begin(), sky_radiosity.end(),
            radiosity.begin() + static_cast<std::ptrdiff_t>(transport.escaped() * bands));
  return radiosity;
}

std::vector<float> sky_radiosity(const PatchSet& patches) {
  std::vector<float> radiosity;
  for (std::size_t b = 0; b < patches.band_count(); ++b)
    radiosity.push_back(static_cast<float>(patches.sky_radiosity(b)));
  return radiosity;
}

std::vector<std::vector<float>> solve_groups(const PatchSet& patches, const SampledOperator& transport,
                                             const SampleState& state, std::span<const float> reflectance,
                                             const Workers& workers) {
  const auto bands = patches.band_count();
  const auto groups = patches.group_count();
  const auto slots = transport.sides().size();
  std::vector<std::vector<float>> gathered(state.replicates, std::vector<float>(slots * groups * bands));
  for (std::size_t g = 0; g < groups; ++g) {
    const auto direct = of_group(state.direct, g, groups, bands);
    const bool has_sky = g == sky_index(patches) || (groups == 1 && patches.has_sky());
    auto radiosity = dark_but_for_sky(transport, bands,
                                      has_sky ? sky_radiosity(patches) : std::vector<float>(bands, 0.0f));
    const auto light = solve_replicates(transport, direct, reflectance, radiosity, tolerance, workers);
    for (std::size_t r = 0; r < gathered.size(); ++r)
      workers.for_chunks(slots, grain, [&](std::size_t begin, std::size_t end, int) {
        for (auto s = begin; s < end; ++s)
          std::copy_n(&light.gathered[r][s * bands], bands, &gathered[r][(s * groups + g) * bands]);
      });
  }
  return gathered;
}

std::uint64_t changed_fingerprint(std::uint64_t key, const PatchSet& patches) {
  const auto add = [&](const std::vector<float>& values) {
    for (const auto v : values) key = stream_key(key, 0, std::bit_cast<std::uint32_t>(v + 0.0f));
  };
  for (const auto& material : patches.materials) {
    add(material.reflectance);
    add(material.emittance);
  }
  add(patches.sky);
  return key;
}

}  // namespace

std::shared_ptr<const SampleState> with_group_light(const PatchSet& patches, const Tracer& tracer,
                                                    std::shared_ptr<const SampleState> state,
                                                    const SampledOptions& options, const Workers& workers) {
  Sampling sampling(patches, tracer, options, workers);
  sampling.take_up(*state);
  const SlotLight slots(patches, sampling.tree(), sampling.transport().sides(), false, workers);
  auto more = std::make_shared<SampleState>(*state);
  more->gathered = solve_groups(patches, sampling.transport(), *state, slots.reflectance(), workers);
  return more;
}

Relighter::Relighter(PatchSet patches, const Tracer& tracer, std::shared_ptr<const SampleState> state,
                     const SampledOptions& options, const Workers& workers)
    : patches_(std::move(patches)),
      sky_(patches_.sky),
      fingerprint_(patches_.scene_fingerprint),
      workers_(workers),
      state_(std::move(state)),
      options_(options),
      sampling_(patches_, tracer, options, workers),
      weight_(patches_.group_count() * patches_.band_count(), 1.0f) {
  for (const auto& material : patches_.materials) emittance_.push_back(material.emittance);
  sampling_.take_up(*state_);
  slots_.emplace(patches_, sampling_.tree(), sampling_.transport().sides(), options.share, workers);
  const auto& transport = sampling_.transport();
  gathered_ = state_->gathered.empty()
                  ? solve_groups(patches_, transport, *state_, slots_->reflectance(), workers)
                  : state_->gathered;
  const auto width = transport.sides().size() * weight_.size();
  for (const auto& light : gathered_)
    if (gathered_.size() != state_->replicates || light.size() != width)
      throw MismatchError("the kept light of the lamps' groups is not of these patches");
}

void Relighter::set_lamps(std::vector<float> weight) {
  if (weight.size() != weight_.size() ||
      !std::all_of(weight.begin(), weight.end(), [](float w) { return w >= 0.0f && std::isfinite(w); }))
    throw InputError(
        fmt::format("expected {} numbers, at least 0, one for each light group and band", weight_.size()));
  weight_ = std::move(weight);
  const auto bands = patches_.band_count();
  for (std::size_t m = 0; m < emittance_.size(); ++m) {
    auto& material = patches_.materials[m];
    for (std::size_t b = 0; b < bands; ++b)
      material.emittance[b] = weight_[material.light_group * bands + b] * emittance_[m][b];
  }
  for (std::size_t b = 0; b < patches_.sky.size(); ++b)
    patches_.sky[b] = weight_[(patches_.group_count() - 1) * bands + b] * sky_[b];
  patches_.scene_fingerprint = changed_fingerprint(fingerprint_, patches_);
}

void Relighter::set_reflectance(const std::vector<float>& reflectance) {
  const auto bands = patches_.band_count();
  if (reflectance.size() != patches_.materials.size() * bands ||
      !std::all_of(reflectance.begin(), reflectance.end(), [](float r) { return r >= 0.0f && r < 1.0f; }))
    throw InputError(fmt::format("expected {} reflectances from 0 to below 1, one for each material and band",
                                 patches_.materials.size() * bands));
  for (std::size_t m = 0; m < patches_.materials.size(); ++m)
    std::copy_n(&reflectance[m * bands], bands, patches_.materials[m].reflectance.begin());
  slots_.emplace(patches_, sampling_.tree(), sampling_.transport().sides(), options_.share, workers_);
  gathered_.clear();
  patches_.scene_fingerprint = changed_fingerprint(fingerprint_, patches_);
}

Solution Relighter::light() const {
  const auto bands = patches_.band_count();
  const auto groups = patches_.group_count();
  auto direct = sum_of_groups(state_->direct, groups, bands, weight_, workers_);
  std::vector<std::vector<float>> gathered;
  if (gathered_.empty()) {
    auto radiosity = dark_but_for_sky(sampling_.transport(), bands, sky_radiosity(patches_));
    gathered =
        solve_replicates(sampling_.transport(), direct, slots_->reflectance(), radiosity, tolerance, workers_)
            .gathered;
  } else {
    gathered = sum_of_groups(gathered_, groups, bands, weight_, workers_);
  }
  const auto answer = slots_->answer(direct, gathered, options_.error, workers_);
  Solution solution;
  slots_->write(answer, solution);
  solution.bands = patches_.bands;
  solution.stop = StopReason::error_reached;
  solution.provenance.method = "sampled";
  solution.provenance.seed = options_.seed;
  solution.provenance.rays = state_->rays + state_->first_rays;
  solution.provenance.scene_fingerprint = patches_.scene_fingerprint;
  return solution;
}

}  // namespace luxel
