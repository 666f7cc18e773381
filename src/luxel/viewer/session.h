// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/session/live_scene.h"

namespace luxel {

// The scene that is looked at, and the one that will take its place: a file that cannot be read leaves the
// old one where it is.
class Session {
 public:
  using SettingsOf = std::function<LiveSettings(const std::filesystem::path& file)>;

  explicit Session(SettingsOf settings) : settings_(std::move(settings)) {}
  // Closes what is open; saves nothing.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Begins to read it. Nothing waits.
  void open(const std::filesystem::path& file);

  // Once a frame: takes what the solver has put out.
  void update();
  bool has_scene() const { return live_ != nullptr; }
  std::uint64_t number() const { return number_; }  // of the scene that is shown, from 1
  LiveScene& live() { return *live_; }
  // What there is now; null where there is nothing yet.
  const std::shared_ptr<const LiveMesh>& mesh() const { return mesh_; }
  const std::shared_ptr<const LiveLight>& light() const { return light_; }
  const LiveStatus& status() const { return status_; }
  // Of the one that is shown, or else of the one that comes.
  std::string title() const;
  // Something is being done, or read.
  bool is_busy() const;

  // Sentences about what failed since the last call, in order.
  std::vector<std::string> take_errors();

  // Stops the solver, saves the light if a file is given, and waits.
  struct Ending {
    std::string error;  // a sentence; empty: nothing went wrong
    std::string saved;  // likewise, about the file
  };
  Ending close(const std::optional<std::filesystem::path>& save);

 private:
  void take_place();
  void retire(std::unique_ptr<LiveScene> scene);

  SettingsOf settings_;
  std::unique_ptr<LiveScene> live_, coming_;
  std::shared_ptr<const LiveMesh> mesh_;
  std::shared_ptr<const LiveLight> light_;
  LiveStatus status_;
  std::uint64_t number_ = 0;
  std::uint64_t errors_seen_ = 0;
  std::vector<std::string> errors_;
  std::vector<std::future<void>> retiring_;  // scenes that close in threads of their own
};

}  // namespace luxel
