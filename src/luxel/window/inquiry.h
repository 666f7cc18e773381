// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/live/probe.h"
#include "luxel/view/pose.h"
#include "luxel/window/background.h"

namespace luxel {

// What a person asks the light: what is under the cursor, along a line, and how far another solution is from
// it.
class Inquiry {
 public:
  // Another scene: nothing is asked any more.
  void forget();

  // Looks at what the eye sees at a point of the screen, [-1, 1]; where it is pinned it stays the same point
  // of the world. Microseconds.
  void look_at(const LiveMesh& mesh, const LiveLight* light, const Pose& pose, const Space& space,
               float aspect, Vec2 at);
  void pin();
  void unpin() { pinned_.reset(); }
  bool is_pinned() const { return pinned_.has_value(); }
  const std::optional<Probe>& probe() const { return probe_; }

  // A line over the screen, from one point to another, [-1, 1].
  void draw_line(const Pose& pose, const Space& space, float aspect, Vec2 from, Vec2 to);
  void clear_line() { sights_.clear(), profile_.clear(); }
  // Once a frame: the profile is that of the newest light.
  void update_profile(const LiveMesh& mesh, const LiveLight* light);
  const std::vector<ProfilePoint>& profile() const { return profile_; }

  // Reads a second solution, and compares the light with it whenever there is a newer one. What goes wrong
  // becomes a sentence.
  void compare(const std::filesystem::path& file) { compared_with_ = file, compared_light_ = 0; }
  void update_difference(const std::shared_ptr<const LiveLight>& light);
  const std::shared_ptr<const std::vector<float>>& difference() const { return difference_; }
  const std::filesystem::path& compared_with() const { return compared_with_; }
  std::optional<std::string> take_error();
  bool is_busy() const { return comparing_.is_busy(); }

 private:
  struct Compared {
    std::shared_ptr<const std::vector<float>> shares;
    std::string error;
  };

  std::optional<Ray> pinned_;
  Ray last_{};
  std::optional<Probe> probe_;
  std::vector<Ray> sights_;
  std::uint64_t profiled_light_ = 0;
  std::vector<ProfilePoint> profile_;

  std::filesystem::path compared_with_;
  std::uint64_t compared_light_ = 0;
  Background<Compared> comparing_;
  std::shared_ptr<const std::vector<float>> difference_;
  std::optional<std::string> error_;
};

}  // namespace luxel
