// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "luxel/cli/command_line.h"
#include "luxel/cli/written_files.h"
#include "luxel/core/ranks.h"
#include "luxel/scene/scene.h"

namespace luxel {

inline constexpr int exit_fine = 0;
inline constexpr int exit_failed = 1;
inline constexpr int exit_misused = 2;
inline constexpr int exit_stopped_early = 3;

// A command of the program. Constructed before the command line is read, so that it can declare its options;
// run afterwards.
class Command {
 public:
  virtual ~Command() = default;
  // Returns the exit code; throws the library's errors.
  virtual int run() = 0;
  const OptionSet& options() const { return options_; }
  OptionSet& options() { return options_; }
  // Returns whether its work can be divided among processes; and these processes, which must outlive the run.
  virtual bool takes_ranks() const { return false; }
  void set_ranks(const Ranks* ranks) { ranks_ = ranks; }

 protected:
  explicit Command(OptionSet& options) : options_(options) {}
  const Ranks* ranks() const { return ranks_; }
  // Throws UsageError where a file of the scene would be overwritten.
  void keep_files_of(const Scene& scene) const { keep_inputs(options_, scene.files); }

 private:
  OptionSet& options_;
  const Ranks* ranks_ = nullptr;
};

std::unique_ptr<Command> make_bake(CommandLine& line);
std::unique_ptr<Command> make_resume(CommandLine& line);
std::unique_ptr<Command> make_relight(CommandLine& line);
std::unique_ptr<Command> make_merge(CommandLine& line);
std::unique_ptr<Command> make_render(CommandLine& line);
std::unique_ptr<Command> make_export(CommandLine& line);
std::unique_ptr<Command> make_lightmap_command(CommandLine& line);
std::unique_ptr<Command> make_probe(CommandLine& line);
std::unique_ptr<Command> make_daylight(CommandLine& line);
std::unique_ptr<Command> make_measure(CommandLine& line);
std::unique_ptr<Command> make_ugr(CommandLine& line);
std::unique_ptr<Command> make_ugr_table(CommandLine& line);
std::unique_ptr<Command> make_report(CommandLine& line);
std::unique_ptr<Command> make_room(CommandLine& line);
std::unique_ptr<Command> make_reference(CommandLine& line);
std::unique_ptr<Command> make_compare(CommandLine& line);
std::unique_ptr<Command> make_info(CommandLine& line);
std::unique_ptr<Command> make_photometry(CommandLine& line);
std::unique_ptr<Command> make_sky(CommandLine& line);
std::unique_ptr<Command> make_weather(CommandLine& line);
std::unique_ptr<Command> make_viewfactors(CommandLine& line);
std::unique_ptr<Command> make_check(CommandLine& line);
std::unique_ptr<Command> make_completion(CommandLine& line);
std::unique_ptr<Command> make_manual(CommandLine& line);
std::unique_ptr<Command> make_view(CommandLine& line);

}  // namespace luxel
