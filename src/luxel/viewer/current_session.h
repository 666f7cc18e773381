// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/session/progressive_session.h"

namespace luxel {

// The displayed scene, and the one that will replace it: if a file cannot be read, the old scene
// stays.
class CurrentSession {
 public:
  using SettingsOf = std::function<SessionSettings(const std::filesystem::path& file)>;

  explicit CurrentSession(SettingsOf settings) : settings_(std::move(settings)) {}
  // Closes what is open; saves nothing.
  ~CurrentSession();
  CurrentSession(const CurrentSession&) = delete;
  CurrentSession& operator=(const CurrentSession&) = delete;

  // Begins to read the file; returns at once.
  void open(const std::filesystem::path& file);

  // Once per frame: takes what the session has published.
  void update();
  bool has_scene() const { return shown_ != nullptr; }
  std::uint64_t number() const { return number_; }  // of the scene that is shown, from 1
  // The session of the scene that is shown: only where there is one.
  ProgressiveSession& operator*() { return *shown_; }
  ProgressiveSession* operator->() { return shown_.get(); }
  // Its state in this frame.
  const SessionSnapshot& snapshot() const { return snapshot_; }
  const std::shared_ptr<const SessionMesh>& mesh() const { return snapshot_.mesh; }
  const std::shared_ptr<const SessionLight>& light() const { return snapshot_.light; }
  const SessionStatus& status() const { return snapshot_.status; }
  // Title of the displayed scene, else of the coming one.
  std::string title() const;
  // Returns whether a scene is being read that will replace the displayed one.
  bool is_opening() const { return next_ != nullptr; }
  // Returns whether the solver works or a file is being read.
  bool is_busy() const;

  // Error sentences since the last call, in order.
  std::vector<std::string> take_errors();

  // Stops the solver, saves the light if a file is given, and waits.
  struct Ending {
    std::string error;  // a sentence; empty: no error
    std::string saved;  // a sentence about the file; empty: none
  };
  Ending close(const std::optional<std::filesystem::path>& save);

 private:
  void take_place();
  void retire(std::unique_ptr<ProgressiveSession> scene);

  SettingsOf settings_;
  std::unique_ptr<ProgressiveSession> shown_, next_;
  SessionSnapshot snapshot_;  // of the shown one
  std::uint64_t number_ = 0;
  std::uint64_t errors_seen_ = 0;
  std::vector<std::string> errors_;
  std::vector<std::future<void>> retiring_;  // scenes that close in threads of their own
};

}  // namespace luxel
