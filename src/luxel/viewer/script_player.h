// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "luxel/viewer/script.h"
#include "luxel/viewer/viewer.h"

namespace luxel {

// Executes a script as user input: between frames, one command after another.
class ScriptPlayer {
 public:
  // Keeps references. Frames of a script are a sixtieth of a second, however long they take.
  static constexpr double frame_seconds = 1.0 / 60.0;
  ScriptPlayer(const Script& script, Viewer& viewer, Screen& screen)
      : script_(script), viewer_(viewer), screen_(screen) {}

  // Executes the actions before the next frame. Throws InputError, FILE:LINE: sentence, where something
  // cannot be done or is not as the script expects.
  void advance();
  bool is_done() const { return next_ == script_.actions.size() && !waits_; }
  // Returns whether the next frame is compared or saved: with smooth edges and all published data.
  bool wants_fine() const { return wants_fine_; }

 private:
  using Words = std::vector<std::string>;
  void act(const ScriptAction& action);
  void wait(const Words& words);
  void frames(int count);
  void expect(const Words& words);
  void expect_lamp(const Words& words) const;
  void expect_luminaire(const Words& words) const;
  void set_view(const Words& words);
  void change_lamp(const Words& words);
  void paint(const Words& words);
  void key(const std::string& name, bool down);
  void mouse(const Words& words);

  const Script& script_;
  Viewer& viewer_;
  Screen& screen_;
  std::size_t next_ = 0;
  std::function<bool()> waits_;  // until it returns true
  bool wants_fine_ = false, has_drawn_ = false;
};

}  // namespace luxel
