// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/sideline.h"

#include <utility>

#include "luxel/core/error.h"
#include "luxel/session/diagnose.h"
#include "luxel/session/live_answers.h"

namespace luxel {

Sideline::Sideline(Board& board, std::filesystem::path file, int threads)
    : board_(board), file_(std::move(file)), workers_(threads) {}

void Sideline::go() {
  std::unique_lock lock(board_.mutex);
  while (true) {
    board_.is_answering = false;
    board_.changed.wait(lock, [&] { return board_.closes || board_.has_questions(); });
    if (board_.closes) return;
    board_.is_answering = true;
    const bool diagnostics_requested = std::exchange(board_.diagnostics_requested, false);
    const auto second = std::exchange(board_.second, {});
    const auto mesh = board_.mesh;
    lock.unlock();
    // A comparison is the quicker one.
    if (second) board_.attempt(file_, [&] { read_second(*second); });
    lock.lock();
    const auto light = board_.compares_anew() ? board_.light : nullptr;
    lock.unlock();
    if (light && second_) board_.attempt(file_, [&] { compare(*light); });
    if (diagnostics_requested) board_.attempt(file_, [&] { run_diagnostics(mesh.get()); });
    lock.lock();
  }
}

void Sideline::run_diagnostics(const LiveMesh* mesh) {
  if (mesh == nullptr || !mesh->scene)
    throw InputError(file_.string(), "faults are looked for in a scene's file; this one has no scene");
  const auto closing = [this](const Progress&) {
    const std::lock_guard lock(board_.mutex);
    return board_.closes ? Next::stop : Next::go_on;
  };
  auto report = std::make_shared<const CheckReport>(diagnose(*mesh->scene, {}, workers_, closing));
  const std::lock_guard lock(board_.mutex);
  board_.diagnostics = std::move(report);
}

void Sideline::read_second(const std::optional<std::filesystem::path>& file) {
  second_.reset();
  {
    const std::lock_guard lock(board_.mutex);
    board_.difference.reset();
    board_.compared.reset();
  }
  if (!file) return;
  second_ = Second{*file, read_solution(*file)};
  const std::lock_guard lock(board_.mutex);
  board_.compared = 0;
}

void Sideline::compare(const LiveLight& light) {
  const Baked shown{*light.mesh.patches, light.solution};
  auto difference = std::make_shared<LiveDifference>();
  try {
    difference->comparison = compare_solutions(second_->baked, shown);
    difference->relative = relative_differences(second_->baked, shown);
  } catch (...) {
    second_.reset();  // else each light to come would say the same
    const std::lock_guard lock(board_.mutex);
    board_.compared.reset();
    throw;
  }
  difference->file = second_->file;
  difference->light = light.number;
  const std::lock_guard lock(board_.mutex);
  board_.difference = std::move(difference);
  board_.compared = light.number;
}

}  // namespace luxel
