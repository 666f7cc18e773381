// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "luxel/session/command_queue.h"
#include "luxel/session/failure_log.h"
#include "luxel/session/latest.h"
#include "luxel/session/session_commands.h"
#include "luxel/session/session_snapshot.h"

namespace luxel {

// State that the solver's thread publishes.
struct SolverState {
  std::shared_ptr<const SessionMesh> mesh;
  std::shared_ptr<const SessionLight> light;
  SessionStatus status;
  std::shared_ptr<const LightOptions> options;  // never null once a session began
  bool is_open = false;                         // the file was read, or could not be
  std::uint64_t commands_done = 0;              // taken from the queue, and seen in this state or carried out
};

// State that the background thread publishes.
struct BackgroundAnswers {
  std::shared_ptr<const CheckReport> diagnostics;
  std::shared_ptr<const LightDifference> difference;
  bool is_busy = false;
  std::uint64_t commands_done = 0;
};

// Data shared by the threads of a session. Each member locks itself.
struct SessionChannels {
  CommandQueue<SolverCommand> to_solver;
  CommandQueue<BackgroundCommand> to_background;
  Latest<SolverState> solver;
  Latest<BackgroundAnswers> answers;
  FailureLog failures;
};

}  // namespace luxel
