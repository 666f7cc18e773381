// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "luxel/session/probe.h"
#include "luxel/session/seen_luminaire.h"
#include "luxel/viewer/pose.h"

namespace luxel {

// Probes of the light: under the cursor, and along a line.
class LightProbe {
 public:
  // Removes all probes, for another scene.
  void forget();

  // Probes the surface at a point of the screen, [-1, 1]; a pinned probe stays at its point of the scene.
  // Cost: microseconds.
  void look_at(const SessionMesh& mesh, const SessionLight* light, const Pose& pose, const Space& space,
               float aspect, Vec2 at);
  void pin();
  void unpin() { pinned_.reset(); }
  bool is_pinned() const { return pinned_.has_value(); }
  const std::optional<Probe>& probe() const { return probe_; }
  // The luminaire whose opening is at that point, if any.
  const std::optional<SeenLuminaire>& luminaire() const { return luminaire_; }

  // A line over the screen, from one point to another, [-1, 1].
  void draw_line(const Pose& pose, const Space& space, float aspect, Vec2 from, Vec2 to);
  void clear_line();
  // Once per frame: updates the profile to the newest light.
  void update_profile(const SessionMesh& mesh, const SessionLight* light);
  const std::vector<ProfilePoint>& profile() const { return profile_; }
  std::uint64_t line_version() const { return line_version_; }  // changes with the line

 private:
  std::optional<Ray> pinned_;
  Ray last_{};
  std::optional<Probe> probe_;
  std::optional<SeenLuminaire> luminaire_;
  std::vector<Ray> sights_;
  std::uint64_t profiled_light_ = 0, line_version_ = 0;
  const void* profiled_tracer_ = nullptr;
  std::vector<ProfilePoint> profile_;
};

}  // namespace luxel
