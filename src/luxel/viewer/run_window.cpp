// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/run_window.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/image/image_file.h"
#include "luxel/viewer/script_player.h"
#include "luxel/viewer/viewer.h"

namespace luxel {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// The default script of --picture: waits for the final light and hides the panel.
constexpr const char* picture_script = "set panel off\nwait finished\nwait 60 frames\n";

class WindowLoop {
 public:
  WindowLoop(const WindowSettings& settings, const Script* script)
      : settings_(settings), screen_(open()), viewer_(*screen_, settings) {
    if (script != nullptr) player_.emplace(*script, viewer_, *screen_);
  }

  WindowReport run() {
    while (!is_over()) {
      const auto events = screen_->poll(wait_seconds());
      for (const auto& event : events) viewer_.handle(event);
      const auto begin = Clock::now();
      if (player_) player_->advance();
      if (screen_->size().empty() || (!screen_->is_shown() && !is_playing())) {
        hidden_ = true;
        continue;
      }
      if (events.empty() && !is_due()) continue;
      frame(!events.empty());
      const auto seconds = seconds_since(begin);
      viewer_.note_frame(seconds);
      note(seconds);
      refuse_what_failed();
    }
    end();
    return std::move(report_);
  }

 private:
  std::unique_ptr<Screen> open() const {
    const auto file = settings_.file.string();
    const auto* command = ending_of(file) == ".vtkhdf" ? "render" : "bake";
    try {
      if (settings_.off_screen)
        return open_off_screen(settings_.size, settings_.pixel_ratio, settings_.text_scale);
    } catch (const DeviceError& error) {
      throw DeviceError(fmt::format("{}: 'luxel {} {} -o out.png' makes a picture without OpenGL",
                                    error.what(), command, file));
    }
    try {
      return open_window("Luxel", settings_.size, settings_.text_scale);
    } catch (const DeviceError& error) {
      throw DeviceError(
          fmt::format("{}: 'luxel view {} --snapshot out.png' draws off screen, and "
                      "'luxel {} {} -o out.png' without OpenGL",
                      error.what(), file, command, file));
    }
  }

  bool is_playing() const { return player_ && !player_->is_done(); }

  // With nothing to draw, the solver gets the processor. The longest wait is for a signal that ends the
  // program.
  double wait_seconds() const {
    constexpr double longest = 0.25;
    if (is_playing()) return 0.0;
    if (hidden_) return longest;
    const auto next = viewer_.next_frame();
    return next ? std::clamp(*next - seconds_since(last_), 0.0, longest) : longest;
  }

  // Returns whether a frame would show something new without user input.
  bool is_due() const {
    if (is_playing() || hidden_) return true;
    const auto next = viewer_.next_frame();
    return next && seconds_since(last_) >= *next;
  }

  bool is_over() {
    if (settings_.is_interrupted && settings_.is_interrupted()) report_.interrupted = true;
    return report_.interrupted || viewer_.is_closing() ||
           (player_ && settings_.off_screen && player_->is_done());
  }

  // The camera's movements begin with an event; the time before it does not count.
  void frame(bool by_event) {
    const double since = std::min(seconds_since(last_), by_event ? 0.05 : 0.3);
    last_ = Clock::now();
    hidden_ = false;
    viewer_.frame(is_playing() ? ScriptPlayer::frame_seconds : since, player_ && player_->wants_fine());
    screen_->present();
  }

  void note(double seconds) {
    report_.frame_seconds.push_back(seconds);
    if (viewer_.session.status().stage == "light") report_.solving_frame_seconds.push_back(seconds);
  }

  // Off screen there is no user to read a dialog.
  void refuse_what_failed() const {
    const auto& session = viewer_.session;
    if (settings_.off_screen && !settings_.script && !session.mesh() && !viewer_.notices.errors().empty())
      throw InputError(viewer_.notices.errors().back());
  }

  void end() {
    if (!report_.interrupted) viewer_.continue_picture(true);
    if (settings_.snapshot && !report_.interrupted) {
      viewer_.frame(ScriptPlayer::frame_seconds, true);
      screen_->present();
      write_png(*settings_.snapshot, viewer_.snapshot());
    }
    auto ending = viewer_.session.close(settings_.save);
    if (!ending.error.empty()) throw DeviceError(ending.error);
    report_.saved = std::move(ending.saved);
  }

  const WindowSettings& settings_;
  std::unique_ptr<Screen> screen_;
  Viewer viewer_;
  std::optional<ScriptPlayer> player_;
  WindowReport report_;
  Clock::time_point last_ = Clock::now();
  bool hidden_ = false;
};

}  // namespace

WindowReport run_window(const WindowSettings& settings) {
  std::optional<Script> picture;
  if (settings.off_screen && !settings.script) picture = parse_script("the picture", picture_script);
  const Script* const script = settings.script ? &*settings.script : picture ? &*picture : nullptr;
  return WindowLoop(settings, script).run();
}

}  // namespace luxel
