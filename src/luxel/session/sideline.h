// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "luxel/core/workers.h"
#include "luxel/session/board.h"
#include "luxel/solution/solution_file.h"

namespace luxel {

// What is answered beside the solver, in a thread of its own, so that light goes on meanwhile: the search for
// diagnostics, and the difference of each light to a second solution.
class Sideline {
 public:
  // Keeps a reference to the board. file: that of the scene. threads: that look for diagnostics.
  Sideline(Board& board, std::filesystem::path file, int threads);

  // Returns once the board says that everything is closed: a fraction of a second, and as long as a second
  // solution takes that is being read. Throws nothing.
  void go();

 private:
  void run_diagnostics(const LiveMesh* mesh);
  void read_second(const std::optional<std::filesystem::path>& file);
  void compare(const LiveLight& light);

  Board& board_;
  std::filesystem::path file_;
  Workers workers_;
  struct Second {
    std::filesystem::path file;
    Baked baked;
  };
  std::optional<Second> second_;
};

}  // namespace luxel
