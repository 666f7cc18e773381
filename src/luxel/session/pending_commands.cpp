// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/pending_commands.h"

#include <utility>

namespace luxel {
namespace {

// Enters one command.
class Entry {
 public:
  explicit Entry(PendingCommands& pending) : pending_(pending) {}

  void operator()(command::Solve& solve) { pending_.solve = std::move(solve); }
  void operator()(const command::SetError& target) { pending_.error = target.error; }
  void operator()(command::Relight& relight) { pending_.lighting = std::move(relight.lighting); }
  void operator()(const command::ShowBounces& bounces) { pending_.bounces = bounces; }
  void operator()(const command::Pause& /*unused*/) { pending_.is_paused = true; }
  void operator()(const command::Resume& /*unused*/) { pending_.is_paused = false; }
  void operator()(const command::SetStepping& stepping) { pending_.is_stepping = stepping.on; }
  void operator()(const command::Step& /*unused*/) {
    pending_.is_paused = false;
    pending_.begins_step = true;
  }
  void operator()(const command::Stop& /*unused*/) {
    pending_.solve.reset();
    pending_.error.reset();
    pending_.stops = true;
    pending_.is_paused = false;
  }
  void operator()(command::SaveSolution& save) { pending_.files.emplace_back(std::move(save)); }
  void operator()(command::ExportGlb& glb) { pending_.files.emplace_back(std::move(glb)); }
  void operator()(command::SaveAtTheEnd& save) { pending_.last_file = std::move(save.file); }

 private:
  PendingCommands& pending_;
};

}  // namespace

void PendingCommands::add(std::vector<SolverCommand> commands) {
  for (auto& each : commands) std::visit(Entry(*this), each);
}

}  // namespace luxel
