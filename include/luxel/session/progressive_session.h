// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "luxel/core/vector.h"
#include "luxel/image/tone.h"
#include "luxel/session/session_settings.h"
#include "luxel/session/session_snapshot.h"

namespace luxel {

/// A scene whose light is solved in a thread of its own, while other threads read its state.
///
/// Opened with a scene (OBJ, glTF) it reads, meshes and solves it; opened with a solution (.vtkhdf) it shows
/// that light. Once a solve has ended its light is, to the bit, that of a `luxel bake` with the same options
/// (--store-transport where stores_transport is set).
///
/// Commands return at once and throw nothing: they wait in a queue until the solver's thread takes them,
/// within a fraction of a second. A failure is reported in the status; earlier results stay visible.
/// Any one thread at a time may call these functions. The destructor closes.
class ProgressiveSession {
 public:
  ProgressiveSession(std::filesystem::path file, SessionSettings settings);
  ~ProgressiveSession();
  ProgressiveSession(const ProgressiveSession&) = delete;
  ProgressiveSession& operator=(const ProgressiveSession&) = delete;

  const std::filesystem::path& file() const;

  /// Returns the current state, including the pending effects of commands: is_idle is false while a command
  /// waits. Cost: copying the status.
  SessionSnapshot snapshot() const;

  // ---- The solver ----

  /// Pauses and continues, within a fraction of a second.
  void pause();
  void resume();
  /// Pauses after every light: a bounce of the iterations, a doubling of the sampled method. step() continues
  /// to the next, and begins a new solve where none is in progress.
  void set_stepping(bool on);
  void step();
  /// Ends the solve and keeps its latest light. Afterwards solve() can continue; resume() has no effect.
  void stop();
  /// Solves by that method and its options, with the latest lamps and colours. A sampled run continues from
  /// its samples; with another seed, number of replicates or switch, and with any other method, the light
  /// starts again. A solve that would take more than an hour or more than the available memory fails with a
  /// sentence, unless force is set.
  void solve(const LightOptions& light, bool force = false);
  /// Solves to another target error, a fraction. No samples are lost.
  void set_error(double error);

  // ---- The light ----

  /// Sets lamp weights and reflectances. The latest call wins and persists across solves, whatever the
  /// method. A light with stored samples is relit from the newest of them without rays; a sampled solve in
  /// progress waits, and each of its answers is relit too. Cost: that of Relighter; where a solve
  /// continues, that of each group's light per answer. Other light is solved again with these lamps and
  /// colours, by its method.
  void relight(const Lighting& lighting);

  /// Shows the light after this number of bounces, at least 0, from the newest samples without tracing (see
  /// Bounces): with the scene's own lamps and colours, once no solve is in progress. Empty, or after a new
  /// solve: all bounces.
  void show_bounces(std::optional<int> bounces);

  // ---- Queries, answered in another thread while the solver continues ----

  /// Searches for defects of the scene, as `luxel check` does. A solution has no scene to check. Takes
  /// seconds for a large scene, on a quarter of the cores. The result is computed once and stays.
  void request_diagnostics();

  /// Compares each further light with a solution on the same patches; an empty value ends this. Lights that
  /// arrive faster than they can be compared are skipped.
  void compare_with(const std::optional<std::filesystem::path>& solution);

  // ---- Files: written whole or not at all; the status reports the result ----

  /// Saves the newest light as a solution, with its samples where they are stored and not relit.
  void save_solution(const std::filesystem::path& file);
  /// up: unit.
  void export_glb(const std::filesystem::path& file, const Vec3& up, const ToneOptions& tone);

  // ---- The end ----

  /// Stops all work, saves the newest light if requested, and waits for the threads: a fraction of a second,
  /// and as long as the file takes. Afterwards only the snapshot may be read.
  void close(const std::optional<std::filesystem::path>& save = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
