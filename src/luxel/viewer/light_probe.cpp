// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/light_probe.h"

#include <limits>

namespace luxel {
namespace {

constexpr int profile_rays = 400;

Ray ray_of(const Pose& pose, const Space& space, float aspect, Vec2 at) {
  const auto seen = sight(pose, space, aspect, at.x, at.y);
  return {seen.origin, seen.direction};
}

}  // namespace

void LightProbe::forget() {
  pinned_.reset();
  probe_.reset();
  luminaire_.reset();
  clear_line();
}

void LightProbe::look_at(const SessionMesh& mesh, const SessionLight* light, const Pose& pose,
                         const Space& space, float aspect, Vec2 at) {
  last_ = ray_of(pose, space, aspect, at);
  const auto ray = pinned_.value_or(last_);
  probe_ = luxel::probe(mesh, light, ray);
  const bool is_lit = light != nullptr && light->mesh.geometry == mesh.geometry;
  luminaire_ = seen_luminaire(is_lit ? *light->mesh.patches : *mesh.patches, ray,
                              probe_ ? probe_->distance : std::numeric_limits<float>::infinity());
}

void LightProbe::pin() {
  if (probe_ || luminaire_) pinned_ = last_;
}

void LightProbe::draw_line(const Pose& pose, const Space& space, float aspect, Vec2 from, Vec2 to) {
  clear_line();
  for (int i = 0; i < profile_rays; ++i)
    sights_.push_back(
        ray_of(pose, space, aspect, glm::mix(from, to, static_cast<float>(i) / (profile_rays - 1))));
}

void LightProbe::clear_line() {
  sights_.clear();
  profile_.clear();
  ++line_version_;
}

void LightProbe::update_profile(const SessionMesh& mesh, const SessionLight* light) {
  if (sights_.empty()) return;
  const auto number = light == nullptr ? 0 : light->number;
  const void* const tracer = mesh.tracer.get();
  if (!profile_.empty() && profiled_light_ == number && profiled_tracer_ == tracer) return;
  profile_ = luxel::profile(mesh, light, sights_);
  if (profiled_tracer_ != tracer) ++line_version_;
  profiled_light_ = number;
  profiled_tracer_ = tracer;
}

}  // namespace luxel
