// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "luxel/runs/reporter.h"
#include "luxel/runs/store_settings.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/sampled.h"

namespace luxel {

// Writes the state of a run while it works. A failed write does not end the run: it is reported, and repeated
// with the next answer.
class Checkpoint {
 public:
  // writes: whether this process is the one that does; others take part in gathering what is written.
  explicit Checkpoint(const StoreSettings& settings, bool writes = true)
      : settings_(settings), writes_(writes) {}

  // For the solver. Keeps references to all three, and to this.
  SolveHooks hooks(const Baked& baked, std::shared_ptr<const SampleState> from, Reporter& reporter);

  // After the last answer, if it is not yet in the file. Throws DeviceError where it cannot be written.
  void finish(const Baked& baked);

  // The last state there was: none before the first answer.
  const std::shared_ptr<const SampleState>& state() const { return state_; }

 private:
  void write(const Baked& baked);

  const StoreSettings& settings_;
  bool writes_;
  std::shared_ptr<const SampleState> state_;
  std::optional<std::chrono::steady_clock::time_point> written_;
};

// The run that a checkpoint holds, to go on with: of the same scene and options. Nothing where there is no
// such file. Throws InputError where it holds another run, which must not be lost; FormatError where it is
// damaged or no solution at all.
std::optional<StoredRun> run_to_go_on(const StoreSettings& settings, std::uint64_t scene_fingerprint,
                                      const OptionSet& options);

}  // namespace luxel
