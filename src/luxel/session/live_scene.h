// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/image/tone.h"
#include "luxel/session/live_settings.h"
#include "luxel/session/live_state.h"

namespace luxel {

struct CheckReport;
struct LiveDifference;

// Lamps and colours that differ from the scene's own.
struct Lighting {
  std::vector<float> lamps;        // how much brighter, at least 0, [light group * bands + band]; empty: 1
  std::vector<float> reflectance;  // [0, 1), [material * bands + band]; empty: the scene's own

  bool operator==(const Lighting&) const = default;
};

// A scene whose light is solved in a thread of its own, while others look at it.
//
// Opened with a scene (OBJ, glTF) it is read, cut and solved; opened with a solution (.vtkhdf) its light is
// shown as it is. Once a solve has ended its light is, to the bit, that of a `luxel bake` with the same
// options (--store-transport where stores_transport is set).
//
// No call throws, and none takes long: each leaves a word for the solver's thread, or takes what it has put
// out. The functions may be called by any one thread at a time. What goes wrong becomes a sentence in the
// status; what was there before stays to be seen. The destructor closes.
class LiveScene {
 public:
  LiveScene(std::filesystem::path file, LiveSettings settings);
  ~LiveScene();
  LiveScene(const LiveScene&) = delete;
  LiveScene& operator=(const LiveScene&) = delete;

  const std::filesystem::path& file() const;

  // What there is now: the mesh as soon as it is read and cut, first without its tracer; the newest light.
  // Nothing where there is none yet.
  std::shared_ptr<const LiveMesh> mesh() const;
  std::shared_ptr<const LiveLight> light() const;
  LiveStatus status() const;
  // Of the solve that is, or was, or will be the first.
  LightOptions options() const;

  // ---- The solver ----

  // Holds and goes on, between two components of work of a fraction of a second.
  void pause();
  void resume();
  // Pauses after every picture: a bounce of the iterations, a doubling of the sampled method. step() goes on
  // to the next, and, where no solve is under way, begins a new one.
  void set_stepping(bool on);
  void step();
  // Ends the solve: the light so far stays. resume() has nothing to go on with then; solve() has.
  void stop();
  // Solves by that method and its options, with the lamps and colours that were asked for. A sampled run goes
  // on where its samples are; with another seed, number of replicates or switch, and by any other method,
  // light begins anew. One that would take more than an hour or than the memory there is fails with a
  // sentence, unless force is set.
  void solve(const LightOptions& light, bool force = false);
  // The same with another error: a share. Samples are never lost by it.
  void ask_error(double error);

  // ---- The light ----

  // Other lamps and colours. The last word counts. It stays said, whatever the method.
  // Where the light knows its samples: without a ray, of the newest of these; a sampled solve that is under
  // way waits, and each of its answers is relit too. Cost: as that of Relighter; where a solve goes on, that
  // of each group's light an answer. Else it is solved anew with these lamps and colours, by the method that
  // the light is of.
  void relight(const Lighting& lighting);

  // The light after so many bounces, at least 0, of the newest samples and without a ray (see Bounces): the
  // scene's own lamps and colours, once no solve is under way. Nothing, or a new solve: all of it.
  void show_bounces(std::optional<int> bounces);

  // ---- Questions: answered beside the solver, in a thread of their own, while its work goes on ----

  // Looks for what is wrong with the scene as `luxel check` does; not of a solution's file, which has no
  // scene. Seconds for a large scene, on a quarter of the cores. The answer comes once, and stays.
  void request_diagnostics();
  std::shared_ptr<const CheckReport> diagnostics() const;

  // How each light that is shown from now on differs from a solution on the same patches; nothing: none.
  // Where light comes faster than it can be compared, some are left out.
  void compare_with(const std::optional<std::filesystem::path>& solution);
  std::shared_ptr<const LiveDifference> difference() const;

  // ---- Files: whole or not at all; what became of it is in the status ----

  // The newest light as a solution, with its samples where they are known and not relit.
  void save_solution(const std::filesystem::path& file);
  // up: unit.
  void export_glb(const std::filesystem::path& file, const Vec3& up, const ToneOptions& tone);

  // ---- The end ----

  // Stops whatever is being done, saves the newest light if asked to, and waits for the thread: a fraction of
  // a second, and as long as the file takes. Only what is still seen can be asked for afterwards.
  void close(const std::optional<std::filesystem::path>& save = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
