// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "luxel/session/session_commands.h"

namespace luxel {

// The commands that the solver's thread has taken and not yet carried out. Of commands that replace one
// another the latest stays. Used by that thread alone.
class PendingCommands {
 public:
  void add(std::vector<SolverCommand> commands);

  bool is_empty() const { return !solve && !error && !lighting && !bounces && files.empty(); }

  std::optional<command::Solve> solve;
  std::optional<double> error;
  std::optional<Lighting> lighting;
  std::optional<command::ShowBounces> bounces;
  std::deque<FileCommand> files;
  std::optional<std::filesystem::path> last_file;  // written once everything has ended
  bool stops = false;                              // the solve in progress
  bool begins_step = false;                        // a step was requested: from idle it begins a solve

  // Pause state of the solver's thread.
  bool is_paused = false, is_stepping = false;
};

}  // namespace luxel
