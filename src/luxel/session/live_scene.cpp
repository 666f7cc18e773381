// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/live_scene.h"

#include <algorithm>
#include <thread>

#include "luxel/core/give_way.h"
#include "luxel/session/live_run.h"
#include "luxel/session/sideline.h"

namespace luxel {

struct LiveScene::State {
  State(std::filesystem::path path, LiveSettings how) : file(std::move(path)), settings(std::move(how)) {
    board.current = settings.light;
    board.status.method = settings.light.method;
    // Who looks must not wait: the window draws first.
    solver = std::thread([this] {
      give_way();
      LiveRun(board, file, settings).go();
    });
    sideline = std::thread([this] {
      give_way();
      Sideline(board, file, std::max(1, Workers().threads() / 4)).go();
    });
  }

  // Leaves word for the solver.
  template <typename Say>
  void order(Say say) {
    {
      const std::lock_guard lock(board.mutex);
      say(board);
      if (board.has_orders()) board.status.is_idle = false;
    }
    board.changed.notify_all();
  }

  std::filesystem::path file;
  LiveSettings settings;
  Board board;
  std::thread solver, sideline;
};

LiveScene::LiveScene(std::filesystem::path file, LiveSettings settings)
    : state_(std::make_unique<State>(std::move(file), std::move(settings))) {}

LiveScene::~LiveScene() { close(); }

const std::filesystem::path& LiveScene::file() const { return state_->file; }

std::shared_ptr<const LiveMesh> LiveScene::mesh() const {
  const std::lock_guard lock(state_->board.mutex);
  return state_->board.mesh;
}

std::shared_ptr<const LiveLight> LiveScene::light() const {
  const std::lock_guard lock(state_->board.mutex);
  return state_->board.light;
}

LiveStatus LiveScene::status() const {
  const auto& board = state_->board;
  const std::lock_guard lock(board.mutex);
  auto status = board.status;
  status.is_answering = board.awaits_answers();
  return status;
}

LightOptions LiveScene::options() const {
  const std::lock_guard lock(state_->board.mutex);
  return state_->board.current;
}

void LiveScene::pause() {
  state_->order([](Board& b) { b.status.is_paused = b.is_paused = true; });
}

void LiveScene::resume() {
  state_->order([](Board& b) { b.status.is_paused = b.is_paused = false; });
}

void LiveScene::set_stepping(bool on) {
  state_->order([&](Board& b) { b.status.is_stepping = b.is_stepping = on; });
}

void LiveScene::step() {
  state_->order([&](Board& b) {
    b.status.is_paused = b.is_paused = false;
    if (b.status.is_idle && !b.has_orders()) b.solve = SolveOrder{b.current};
  });
}

void LiveScene::stop() {
  state_->order([](Board& b) {
    b.stops = true;
    b.solve.reset();
    b.error.reset();
    b.status.is_paused = b.is_paused = false;
  });
}

void LiveScene::solve(const LightOptions& light, bool force) {
  state_->order([&](Board& b) { b.solve = SolveOrder{light, force}; });
}

void LiveScene::ask_error(double error) {
  state_->order([&](Board& b) { b.error = error; });
}

void LiveScene::relight(const Lighting& lighting) {
  state_->order([&](Board& b) { b.lighting = lighting; });
}

void LiveScene::show_bounces(std::optional<int> bounces) {
  state_->order([&](Board& b) { b.bounces = bounces; });
}

void LiveScene::request_diagnostics() {
  state_->order([](Board& b) { b.diagnostics_requested = true; });
}

std::shared_ptr<const CheckReport> LiveScene::diagnostics() const {
  const std::lock_guard lock(state_->board.mutex);
  return state_->board.diagnostics;
}

void LiveScene::compare_with(const std::optional<std::filesystem::path>& solution) {
  state_->order([&](Board& b) { b.second = solution; });
}

std::shared_ptr<const LiveDifference> LiveScene::difference() const {
  const std::lock_guard lock(state_->board.mutex);
  return state_->board.difference;
}

void LiveScene::save_solution(const std::filesystem::path& file) {
  state_->order([&](Board& b) { b.files.emplace_back(file); });
}

void LiveScene::export_glb(const std::filesystem::path& file, const Vec3& up, const ToneOptions& tone) {
  state_->order([&](Board& b) { b.files.emplace_back(GlbOrder{file, up, tone}); });
}

void LiveScene::close(const std::optional<std::filesystem::path>& save) {
  if (!state_->solver.joinable()) return;
  state_->order([&](Board& b) {
    b.last_save = save;
    b.closes = true;
  });
  state_->solver.join();
  state_->sideline.join();
}

}  // namespace luxel
