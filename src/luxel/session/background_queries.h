// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "luxel/core/context.h"
#include "luxel/session/session_channels.h"
#include "luxel/solution/solution_file.h"

namespace luxel {

// The thread of a session that answers questions while the solver continues: diagnostics, and the difference
// of each light from a second solution.
class BackgroundQueries {
 public:
  // Keeps a reference to the channels. file: of the scene. threads: that look for diagnostics.
  BackgroundQueries(SessionChannels& channels, std::filesystem::path file, int threads);

  // Returns once the queue of commands is closed: within a fraction of a second, and the time to finish
  // reading a second solution. Throws nothing.
  void run();

 private:
  bool is_closing() const { return channels_.to_background.is_closed(); }
  bool attempt(const std::function<void()>& work) { return channels_.failures.attempt(file_, work); }
  void take_commands();
  void read_second();
  void compare(const SessionLight& light);
  void find_diagnostics(const SessionMesh* mesh);

  SessionChannels& channels_;
  std::filesystem::path file_;
  Context context_;
  BackgroundAnswers answers_;  // as they are published next

  bool diagnostics_requested_ = false;
  std::optional<CompareWith> next_second_;  // to be read
  struct Second {
    std::filesystem::path file;
    Baked baked;
    std::uint64_t compared = 0;  // number of the light that was compared with it last; 0: none was
  };
  std::optional<Second> second_;
};

}  // namespace luxel
