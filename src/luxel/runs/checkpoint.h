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
  // writes: whether this process writes the file; the others take part in gathering its data.
  explicit Checkpoint(const StoreSettings& settings, bool writes = true)
      : settings_(settings), writes_(writes) {}

  // Hooks for the solver. They keep references to all arguments and to this object.
  SolveHooks hooks(const Baked& baked, std::shared_ptr<const SampleState> from, Reporter& reporter);

  // Writes the last answer if it is not yet in the file. Returns whether the file has the light. Throws
  // DeviceError where it cannot be written.
  bool finish(const Baked& baked);

  // The latest state; null before the first answer.
  const std::shared_ptr<const SampleState>& state() const { return state_; }

 private:
  void write(const Baked& baked);

  const StoreSettings& settings_;
  bool writes_;
  std::shared_ptr<const SampleState> state_;
  std::optional<std::chrono::steady_clock::time_point> written_;
};

// Reads the run of a checkpoint, for resuming it with the same scene and options. Nothing where there is no
// such file. Throws InputError where it holds another run, which must not be lost; FormatError where it is
// damaged or is not a solution.
std::optional<StoredRun> run_to_go_on(const StoreSettings& settings, std::uint64_t scene_fingerprint,
                                      const OptionSet& options);

}  // namespace luxel
