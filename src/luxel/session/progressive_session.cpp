// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/progressive_session.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "luxel/core/give_way.h"
#include "luxel/session/background_queries.h"
#include "luxel/session/session_channels.h"
#include "luxel/session/solver_thread.h"

namespace luxel {
namespace {

// The value that a command will have set, shown before the solver has taken the command.
struct Expected {
  std::uint64_t command = 0;
  bool value = false;

  bool at(std::uint64_t commands_done, bool now) const { return commands_done < command ? value : now; }
};

}  // namespace

struct ProgressiveSession::State {
  State(std::filesystem::path path, const SessionSettings& settings) : file(std::move(path)) {
    SolverState first;
    first.options = std::make_shared<const LightOptions>(settings.light);
    first.status.method = name(settings.light.method);
    channels.solver.publish(first);
    // The window draws first, at a higher thread priority.
    solver = std::thread([this, settings] {
      give_way();
      SolverThread(channels, file, settings).run();
    });
    background = std::thread([this] {
      give_way();
      BackgroundQueries(channels, file, std::max(1, Context().threads() / 4)).run();
    });
  }

  std::uint64_t send(SolverCommand command) { return channels.to_solver.push(std::move(command)); }
  void expect_paused(bool value, SolverCommand command) { is_paused = {send(std::move(command)), value}; }

  std::filesystem::path file;
  SessionChannels channels;
  Expected is_paused, is_stepping;
  std::thread solver, background;
};

ProgressiveSession::ProgressiveSession(std::filesystem::path file, SessionSettings settings)
    : state_(std::make_unique<State>(std::move(file), settings)) {}

ProgressiveSession::~ProgressiveSession() { close(); }

const std::filesystem::path& ProgressiveSession::file() const { return state_->file; }

SessionSnapshot ProgressiveSession::snapshot() const {
  const auto& channels = state_->channels;
  // The solver's state is read first: a light in it has already been passed to the background worker.
  const auto solver = channels.solver.get();
  const auto questions = channels.to_background.pushed();
  const auto answers = channels.answers.get();
  const auto failed = channels.failures.last();
  SessionSnapshot snapshot{solver->mesh,    solver->light,        solver->status,
                           solver->options, answers->diagnostics, answers->difference};
  auto& status = snapshot.status;
  const auto done = solver->commands_done;
  status.is_idle = status.is_idle && done == channels.to_solver.pushed();
  status.is_paused = state_->is_paused.at(done, status.is_paused);
  status.is_stepping = state_->is_stepping.at(done, status.is_stepping);
  status.is_answering = answers->is_busy || answers->commands_done < questions;
  status.error_message = failed.message;
  status.errors = failed.count;
  return snapshot;
}

void ProgressiveSession::pause() { state_->expect_paused(true, command::Pause{}); }

void ProgressiveSession::resume() { state_->expect_paused(false, command::Resume{}); }

void ProgressiveSession::set_stepping(bool on) {
  state_->is_stepping = {state_->send(command::SetStepping{on}), on};
}

void ProgressiveSession::step() { state_->expect_paused(false, command::Step{}); }

void ProgressiveSession::stop() { state_->expect_paused(false, command::Stop{}); }

void ProgressiveSession::solve(const LightOptions& light, bool force) {
  state_->send(command::Solve{light, force});
}

void ProgressiveSession::set_error(double error) { state_->send(command::SetError{error}); }

void ProgressiveSession::relight(const Lighting& lighting) { state_->send(command::Relight{lighting}); }

void ProgressiveSession::show_bounces(std::optional<int> bounces) {
  state_->send(command::ShowBounces{bounces});
}

void ProgressiveSession::request_diagnostics() { state_->channels.to_background.push(FindDiagnostics{}); }

void ProgressiveSession::compare_with(const std::optional<std::filesystem::path>& solution) {
  state_->channels.to_background.push(CompareWith{solution});
}

void ProgressiveSession::save_solution(const std::filesystem::path& file) {
  state_->send(command::SaveSolution{file});
}

void ProgressiveSession::export_glb(const std::filesystem::path& file, const Vec3& up,
                                    const ToneOptions& tone) {
  state_->send(command::ExportGlb{file, up, tone});
}

void ProgressiveSession::close(const std::optional<std::filesystem::path>& save) {
  if (!state_->solver.joinable()) return;
  if (save) state_->send(command::SaveAtTheEnd{*save});
  state_->channels.to_solver.close();
  state_->channels.to_background.close();
  state_->solver.join();
  state_->background.join();
}

}  // namespace luxel
