// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <variant>

#include "luxel/live/live_scene.h"

namespace luxel {

struct SolveOrder {
  LightOptions light;
  bool force = false;
};
struct GlbOrder {
  std::filesystem::path file;
  Vec3 up{0.0f, 1.0f, 0.0f};
  ToneOptions tone;
};
using FileOrder = std::variant<std::filesystem::path, GlbOrder>;  // a path: the solution

// Where the window and the solver's thread leave each other word.
struct Board {
  mutable std::mutex mutex;
  std::condition_variable changed;

  // The solver's.
  std::shared_ptr<const LiveMesh> mesh;
  std::shared_ptr<const LiveLight> light;
  LiveStatus status;
  std::shared_ptr<const CheckReport> faults;
  std::shared_ptr<const LiveDifference> difference;
  LightOptions current;  // of the solve that is, or was, or will be the first

  // The window's.
  bool is_paused = false, is_stepping = false;
  bool stops = false;   // ends the solve
  bool closes = false;  // ends everything
  std::optional<SolveOrder> solve;
  std::optional<double> error;
  std::optional<Lighting> lighting;
  std::optional<std::optional<int>> bounces;
  std::optional<std::optional<std::filesystem::path>> second;
  bool asks_faults = false;
  std::deque<FileOrder> files;
  std::optional<std::filesystem::path> last_save;  // once everything has ended

  // Call with the mutex held.
  bool has_orders() const { return solve || error || lighting || bounces || has_questions(); }
  // What is answered while a solve is under way.
  bool has_questions() const { return second || asks_faults || !files.empty(); }
};

}  // namespace luxel
