// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "luxel/image/tone.h"
#include "luxel/session/session_settings.h"
#include "luxel/viewer/screen.h"
#include "luxel/viewer/script.h"

namespace luxel {

struct WindowSettings {
  std::filesystem::path file = {};  // scene or solution; empty: one is to be dropped on the window
  // Returns the settings of a session for a file: the one above, or a dropped one.
  std::function<SessionSettings(const std::filesystem::path&)> live = {};
  ScreenSize size = {};
  float pixel_ratio = 1.0f;                    // off screen: pixels per unit
  float text_scale = 0.0f;                     // of text and controls; 0: that of the display
  std::optional<Vec3d> eye = {}, target = {};  // m, in the file's coordinates; none: found
  float vertical_fov = 0.0f;                   // degrees; 0: found
  std::optional<Vec3> up = {};                 // none: found
  ToneOptions tone = {};
  std::optional<std::filesystem::path> compare = {};  // a second solution
  std::optional<std::filesystem::path> save = {};     // the light, when the window closes
  // File that stores the names of recent files; nothing: they are not stored.
  std::optional<std::filesystem::path> recent = {};

  // Runs without a window: the script, or else a picture when the light is solved.
  bool off_screen = false;
  std::optional<std::filesystem::path> snapshot = {};  // taken at the end
  std::optional<Script> script = {};                   // executed as user input, in a window too
  std::string version = {};                            // of the program, to be shown
  std::function<bool()> is_interrupted = {};           // polled between frames
};

// Times of the frames, for the benchmark.
struct WindowReport {
  std::vector<double> frame_seconds;          // each, from events to the finished picture
  std::vector<double> solving_frame_seconds;  // those of them while light was being solved
  std::string saved;  // a sentence about the file that was saved at the end; empty: none was
  bool interrupted = false;
};

// Opens the window, or draws off screen, and returns when it is closed, the script is done or the light is
// there. Throws DeviceError where nothing can be drawn; InputError where the script is wrong or, off screen,
// the scene; all in one sentence.
WindowReport run_window(const WindowSettings& settings);

}  // namespace luxel
