// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <variant>

#include "luxel/core/vector.h"
#include "luxel/image/tone.h"
#include "luxel/session/session_settings.h"
#include "luxel/session/session_snapshot.h"

namespace luxel {

// Commands of a ProgressiveSession to its solver's thread; its functions of the same names describe them.
namespace command {

struct Solve {
  LightOptions light;
  bool force = false;
};
struct SetError {
  double error;
};
struct Relight {
  Lighting lighting;
};
struct ShowBounces {
  std::optional<int> count;
};
struct Pause {};
struct Resume {};
struct SetStepping {
  bool on;
};
struct Step {};
struct Stop {};
struct SaveSolution {
  std::filesystem::path file;
};
struct ExportGlb {
  std::filesystem::path file;
  Vec3 up{0.0f, 1.0f, 0.0f};
  ToneOptions tone = {};
};
// The last command of a session: when all work has ended the light is saved.
struct SaveAtTheEnd {
  std::filesystem::path file;
};

}  // namespace command

using FileCommand = std::variant<command::SaveSolution, command::ExportGlb>;
using SolverCommand =
    std::variant<command::Solve, command::SetError, command::Relight, command::ShowBounces, command::Pause,
                 command::Resume, command::SetStepping, command::Step, command::Stop, command::SaveSolution,
                 command::ExportGlb, command::SaveAtTheEnd>;

// Commands to the background thread that answers queries.
struct FindDiagnostics {};
struct CompareWith {
  std::optional<std::filesystem::path> solution;  // nothing: the comparison ends
};
struct SolverPublished {};  // a mesh or a light that is newer than the last
using BackgroundCommand = std::variant<FindDiagnostics, CompareWith, SolverPublished>;

}  // namespace luxel
