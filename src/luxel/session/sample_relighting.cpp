// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/sample_relighting.h"

#include <algorithm>
#include <utility>

#include "luxel/solution/sample_state.h"

namespace luxel {

void SampleRelighting::set_mesh(const SessionMesh& mesh) {
  forget_light();
  mesh_ = mesh;
}

void SampleRelighting::begin(const SampledOptions& options, bool continues) {
  forget_light();
  options_ = options;
  if (!continues) samples_.reset();
}

void SampleRelighting::set_samples(std::shared_ptr<const SampleState> samples) {
  samples_ = std::move(samples);
  relighter_.reset();
}

void SampleRelighting::forget_light() {
  relighter_.reset();
  bounces_.reset();
}

bool SampleRelighting::fits(const SampledOptions& other) const {
  const auto& own = options_;
  return own.seed == other.seed && own.replicates == other.replicates &&
         own.low_discrepancy == other.low_discrepancy && own.stratified == other.stratified &&
         own.importance == other.importance && own.control_variate == other.control_variate &&
         own.multiple_importance == other.multiple_importance && own.both_ways == other.both_ways &&
         own.smoothing == other.smoothing;
}

void SampleRelighting::find_group_light(const Monitor& monitor) {
  auto samples =
      with_group_light(*mesh_.patches, *mesh_.tracer, samples_, options_, context_.with_monitor(monitor));
  if (samples) samples_ = std::move(samples);
}

// Setting lamps or reflectances has a cost, so unchanged values are not set again. Empty values mean those of
// the scene.
SampleRelighting::Relit SampleRelighting::relight(const Lighting& lighting) {
  if (!relighter_) {
    lighting_ = {};
    relighter_ = std::make_unique<Relighter>(*mesh_.patches, *mesh_.tracer, samples_, options_, context_);
  }
  const auto& patches = *mesh_.patches;
  auto lamps = lighting.lamps;
  if (lamps.empty()) lamps.assign(patches.group_count() * patches.band_count(), 1.0f);
  auto reflectance = lighting.reflectance;
  if (reflectance.empty())
    for (const auto& material : patches.materials)
      reflectance.insert(reflectance.end(), material.reflectance.begin(), material.reflectance.end());
  if (lamps != lighting_.lamps) relighter_->set_lamps(lamps);
  if (reflectance != lighting_.reflectance) relighter_->set_reflectance(reflectance);
  lighting_ = {std::move(lamps), std::move(reflectance)};
  return {std::make_shared<const PatchSet>(relighter_->patches()), relighter_->light()};
}

SampleRelighting::AfterBounces SampleRelighting::after_bounces(int count) {
  if (!bounces_)
    bounces_ = std::make_unique<Bounces>(*mesh_.patches, *mesh_.tracer, *samples_, options_, context_);
  const auto before = count > 0 ? bounces_->light(count - 1) : Solution();
  AfterBounces after{bounces_->light(count), {}};
  const auto less = [](std::vector<float> values, const std::vector<float>& others) {
    for (std::size_t i = 0; i < others.size(); ++i) values[i] = std::max(0.0f, values[i] - others[i]);
    return values;
  };
  after.unshot.front = less(after.solution.radiosity.front, before.radiosity.front);
  after.unshot.back = less(after.solution.radiosity.back, before.radiosity.back);
  return after;
}

}  // namespace luxel
