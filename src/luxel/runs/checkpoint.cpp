// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/checkpoint.h"

#include <filesystem>

#include <fmt/format.h>

#include "luxel/runs/settings.h"

namespace luxel {

SolveHooks Checkpoint::hooks(const Baked& baked, std::shared_ptr<const SampleState> from,
                             Reporter& reporter) {
  SolveHooks hooks;
  hooks.from = std::move(from);
  if (settings_.checkpoint.empty() && !settings_.transport) return hooks;
  hooks.keep = [this, &baked, &reporter](std::shared_ptr<const SampleState> state) {
    state_ = std::move(state);
    const auto now = std::chrono::steady_clock::now();
    const auto since = written_ ? std::chrono::duration<double>(now - *written_).count() : settings_.every;
    if (!writes_ || settings_.checkpoint.empty() || since < settings_.every) return;
    try {
      write(baked);
    } catch (const DeviceError& error) {
      reporter.clear_bar();
      warn(reporter.log(), fmt::format("{}; the run goes on without", error.what()));
    }
    written_ = std::chrono::steady_clock::now();
  };
  return hooks;
}

void Checkpoint::write(const Baked& baked) {
  write_solution(settings_.checkpoint, baked.patches, baked.solution, state_.get());
}

bool Checkpoint::finish(const Baked& baked) {
  if (settings_.checkpoint.empty() || !state_) return false;
  write(baked);
  return true;
}

std::optional<StoredRun> run_to_go_on(const StoreSettings& settings, std::uint64_t scene_fingerprint,
                                      const OptionSet& options) {
  const auto& file = settings.checkpoint;
  if (file.empty() || !std::filesystem::exists(file)) return {};
  auto run = read_stored_run(file);
  const auto& provenance = run.baked.solution.provenance;
  const auto refuse = [&](const std::string& what) {
    throw InputError(file, fmt::format("it holds {}, which this run would overwrite: continue it with 'luxel "
                                       "resume', name another file, or remove it",
                                       what));
  };
  if (!run.samples) refuse("a solution without samples, no checkpoint");
  if (provenance.scene_fingerprint != scene_fingerprint) refuse("a run of another scene");
  const auto mine = options.used_values(RunSettings::heading);
  for (std::size_t i = 0; i < std::max(mine.size(), provenance.options.size()); ++i)
    if (i >= mine.size() || i >= provenance.options.size() || mine[i] != provenance.options[i])
      refuse(fmt::format("a run with other options ({})", provenance.command_line));
  return run;
}

}  // namespace luxel
