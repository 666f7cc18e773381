// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <variant>

#include "luxel/session/live_scene.h"

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

// Where the window, the solver's thread and the one beside it leave each other word.
struct Board {
  mutable std::mutex mutex;
  std::condition_variable changed;

  // The solver's.
  std::shared_ptr<const LiveMesh> mesh;
  std::shared_ptr<const LiveLight> light;
  LiveStatus status;
  bool is_open = false;  // the file was read, or could not be
  LightOptions current;  // of the solve that is, or was, or will be the first

  // The Sideline's.
  std::shared_ptr<const CheckReport> diagnostics;
  std::shared_ptr<const LiveDifference> difference;
  bool is_answering = false;
  std::optional<std::uint64_t> compared;  // light that was compared with the second solution; none: no such

  // The window's.
  bool is_paused = false, is_stepping = false;
  bool stops = false;   // ends the solve
  bool closes = false;  // ends everything
  std::optional<SolveOrder> solve;
  std::optional<double> error;
  std::optional<Lighting> lighting;
  std::optional<std::optional<int>> bounces;
  std::optional<std::optional<std::filesystem::path>> second;
  bool diagnostics_requested = false;
  std::deque<FileOrder> files;
  std::optional<std::filesystem::path> last_save;  // once everything has ended

  // ---- Call these with the mutex held ----

  // For the solver's thread.
  bool has_orders() const { return solve || error || lighting || bounces || !files.empty(); }
  // For the Sideline: what can be answered now, and all that was asked.
  bool compares_anew() const { return compared && light && light->number != *compared; }
  bool has_questions() const { return is_open && (diagnostics_requested || second || compares_anew()); }
  bool awaits_answers() const { return is_answering || diagnostics_requested || second || compares_anew(); }

  // Does it, without the mutex, and puts what it throws into the status. Says whether it went well. file:
  // that of the scene.
  bool attempt(const std::filesystem::path& file, const std::function<void()>& work);
};

}  // namespace luxel
