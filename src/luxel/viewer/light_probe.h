// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "luxel/session/probe.h"
#include "luxel/session/seen_luminaire.h"
#include "luxel/viewer/pose.h"

namespace luxel {

// What a person asks the light: what is under the cursor, and along a line.
class LightProbe {
 public:
  // Another scene: nothing is asked any more.
  void forget();

  // Looks at what the eye sees at a point of the screen, [-1, 1]; where it is pinned it stays the same point
  // of the world. Microseconds.
  void look_at(const SessionMesh& mesh, const SessionLight* light, const Pose& pose, const Space& space,
               float aspect, Vec2 at);
  void pin();
  void unpin() { pinned_.reset(); }
  bool is_pinned() const { return pinned_.has_value(); }
  const std::optional<Probe>& probe() const { return probe_; }
  // The luminaire at that point, if its opening is there.
  const std::optional<SeenLuminaire>& luminaire() const { return luminaire_; }

  // A line over the screen, from one point to another, [-1, 1].
  void draw_line(const Pose& pose, const Space& space, float aspect, Vec2 from, Vec2 to);
  void clear_line();
  // Once a frame: the profile is that of the newest light.
  void update_profile(const SessionMesh& mesh, const SessionLight* light);
  const std::vector<ProfilePoint>& profile() const { return profile_; }
  std::uint64_t line_version() const { return line_version_; }  // other where the line lies elsewhere

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
