// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "luxel/core/workers.h"
#include "luxel/session/board.h"
#include "luxel/session/pace.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/bounces.h"
#include "luxel/solve/relight.h"

namespace luxel {

// What the thread of a live scene does, from opening the file to the word that ends it.
class LiveRun {
 public:
  // Keeps a reference to the board.
  LiveRun(Board& board, std::filesystem::path file, LiveSettings settings);

  // Returns once the board says so. Throws nothing.
  void go();

 private:
  // Does it, and puts what it throws on the board. Says whether it went well.
  bool attempt(const std::function<void()>& work);

  // ---- The file ----
  void open();
  void open_scene();
  void group_lamps(const Scene& scene, PatchSet& patches);
  void open_solution();
  void build_tracer();
  void show_mesh();

  // ---- Orders ----
  bool wait_for_orders();
  std::optional<SolveOrder> next_solve();
  void write_files();
  void write(const FileOrder& order);

  // ---- Light ----
  void solve(const SolveOrder& order);
  void refuse_too_much(const SolveOrder& order);
  bool goes_on_with_samples(const LightOptions& light) const;
  void begin_solve(const SolveOrder& order, SampleStorage& storage);
  void end_solve(Solution solution);
  Next watch(Progress progress);
  bool must_end(const Progress& progress) const;  // this and the next: call with the board's mutex held
  bool is_to_be_lit_anew() const;
  bool is_sampled() const { return light_.method == LightOptions::by_sampling; }
  void show(Solution solution, bool is_last);
  bool goes_by_bounces() const;
  void begin_bounces();
  void note_unshot(const Solution& light);
  void take_lighting();
  void relight(const Lighting& lighting);
  void set_lighting(const Lighting& lighting);
  void sign_relit(Solution& relit, const Lighting& lighting) const;
  void note_lighting(Provenance& provenance, const Lighting& lighting) const;
  void know_group_light();
  void show_bounces(std::optional<int> count);
  LiveLight light_of(LiveMesh mesh, Solution solution) const;
  std::shared_ptr<const LiveLight> publish(LiveLight light);
  bool is_closing() const;

  void begin_stage(const char* stage);
  LogSink log();
  Monitor closing_monitor();

  Board& board_;
  std::filesystem::path file_;
  LiveSettings settings_;
  Workers workers_;

  LiveMesh mesh_;
  LightOptions light_;                          // of the solve that is, or was
  std::shared_ptr<const SampleState> samples_;  // of the newest answer
  SampledOptions sampled_;                      // they were made with
  // The newest answer by the scene's own lamps and colours; where it was shown, as that.
  std::optional<Solution> own_;
  std::shared_ptr<const LiveLight> own_light_;
  Lighting lighting_;                     // as it is asked for
  LiveMesh lit_;                          // as the solve sees it: with the lighting, unless it is sampled
  std::unique_ptr<Relighter> relighter_;  // of samples_
  Lighting relit_;                        // as it is set there
  std::unique_ptr<Bounces> bounces_;      // likewise
  double mesh_error_ = 0.0;
  bool is_solving_ = false;
  bool is_out_of_time_ = false;  // which ended it

  // Of the newest picture, and what it has more than the one before, W/m²; empty where light does not go by
  // bounces.
  std::vector<float> radiosity_front_, radiosity_back_, unshot_front_, unshot_back_;

  Pace pace_;
  std::uint32_t step_ = 0;
  std::uint64_t lights_ = 0;
  std::chrono::steady_clock::duration cost_of_showing_{};
  std::chrono::steady_clock::time_point shown_;
};

}  // namespace luxel
