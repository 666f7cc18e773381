// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "luxel/core/context.h"
#include "luxel/session/pending_commands.h"
#include "luxel/session/sample_relighting.h"
#include "luxel/session/scene_opener.h"
#include "luxel/session/session_channels.h"
#include "luxel/session/solve_clock.h"
#include "luxel/session/unshot_light.h"

namespace luxel {

// The thread of a session that opens the file, solves, relights and writes: it takes commands from its queue
// and publishes its state. Only the channels are shared.
class SolverThread {
 public:
  // Keeps a reference to the channels.
  SolverThread(SessionChannels& channels, std::filesystem::path file, SessionSettings settings);

  // Returns once the queue of commands is closed and the last file is written. Throws nothing.
  void run();

 private:
  bool attempt(const std::function<void()>& work) { return channels_.failures.attempt(file_, work); }
  bool is_closing() const { return channels_.to_solver.is_closed(); }

  // ---- State: solver_thread.cpp ----
  void publish();
  void publish_stage(const char* stage);
  void set_options(const LightOptions& options);
  // Takes the commands that wait.
  void take_commands();
  // Returns once there is something to do; false: the session is closing.
  bool wait_for_commands();
  std::optional<command::Solve> next_solve();
  void open();
  void open_solution(const SceneOpener& opener);
  void write_files();
  void write(const FileCommand& order);

  // ---- Solving: solver_thread_solve.cpp ----
  bool is_sampled() const { return light_.method == Method::sampled; }
  bool goes_by_bounces() const;
  void refuse_long_solve(const command::Solve& order);
  void begin_solve(const command::Solve& order, SolveHooks& hooks);
  void solve(const command::Solve& order);
  void end_solve(Solution solution);
  Next on_progress(Progress progress);
  void wait_while_paused(const Progress& progress, bool has_light);
  bool must_end(const Progress& progress, bool has_light) const;
  bool needs_new_solve() const;

  // ---- Light: solver_thread_light.cpp ----
  SessionLight light_of(SessionMesh mesh, Solution solution) const;
  std::shared_ptr<const SessionLight> publish_light(SessionLight light);
  void show(Solution solution, bool is_last);
  void find_group_light();
  void take_lighting();
  void relight(const Lighting& lighting);
  void show_own_light();
  void show_bounces(std::optional<int> count);
  void describe_relit(Solution& relit, const Lighting& lighting) const;

  SessionChannels& channels_;
  std::filesystem::path file_;
  SessionSettings settings_;
  Context context_;
  SolverState state_;  // as it is published next
  PendingCommands pending_;

  SessionMesh mesh_;
  double mesh_error_ = 0.0;
  LightOptions light_;  // of the current or last solve, or of the first one to come
  Lighting lighting_;   // as it was last set
  SampleRelighting relighting_;

  // The newest light with the scene's own lamps and colours.
  struct OwnLight {
    std::optional<Solution> hidden;             // while a relit one is shown in its place
    std::shared_ptr<const SessionLight> shown;  // as it was published
  } own_;

  // The current or last solve.
  struct CurrentSolve {
    SessionMesh mesh;  // as the solve sees it: with the lighting, unless it is sampled
    UnshotLight unshot;
    SolveClock clock;
    std::uint32_t step = 0;
    bool is_running = false;
    bool is_out_of_time = false;
    const Solution* new_light = nullptr;  // published by the solver and not yet seen by on_progress()
    // When its newest light was shown, and how long that took.
    std::chrono::steady_clock::time_point shown;
    std::chrono::steady_clock::duration cost_of_showing{};
  } solve_;
};

}  // namespace luxel
