// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/light_run.h"
#include "luxel/runs/bake_settings.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/quantity.h"
#include "luxel/runs/resumed_options.h"
#include "luxel/session/words.h"

namespace luxel {
namespace {

// `resume`: continues a bake at its checkpoint, with its options.
class Resume final : public Command {
 public:
  explicit Resume(OptionSet& options) : Command(options) {
    options.set_positional("FILE", file_, "a .vtkhdf file of --checkpoint or --store-transport", ".vtkhdf");
    told_.light.declare_bounds(options);
    told_.look.declare(options);
    told_.mesh.declare(options);
    told_.picture.declare(options);
    told_.run.declare(options, all_kinds);
    told_.light.declare_memory(options);
    told_.keep.declare_every(options);
    options.show_first(
        {"output", "error", "time", "rays", "eye", "target", "width", "height", "exposure", "open"});
    options.set_examples(
        {{"luxel resume run.vtkhdf", "Continues a bake that was stopped, and updates its file."},
         {"luxel resume run.vtkhdf --error 1% -o finer.png", "Goes on to a smaller error."}});
  }

  bool takes_ranks() const override { return true; }

  int run() override {
    check_before_work(told_.run, told_.picture, all_kinds, {{"the checkpoint", file_}});
    Console console(told_.run);
    const Context context({.threads = told_.run.threads, .ranks = ranks()});
    RunRecord record;

    auto kept = record.stage("read", [&](auto&) { return read_stored_run(file_); });
    if (!kept.samples)
      throw InputError(
          file_, "it stores no samples to continue from: bake with --checkpoint FILE or --store-transport");
    auto& provenance = kept.baked.solution.provenance;
    BakeSettings settings;
    OptionSet all("bake", "");
    settings.declare(all);
    restore_options(options().given(), options().given_as_command(RunSettings::heading), all, provenance);
    settings.keep.checkpoint = file_;
    settings.check();
    console.say("resumes", fmt::format("{}: {} patches, after {} rays", file_,
                                       with_commas(kept.baked.patches.size()), rough_count(provenance.rays)));
    if (!options().is_given("ray-budget")) settings.light.sampled.ray_budget = 0;  // it resumes to continue
    BakeStart start{std::move(kept.baked), {}, std::move(kept.samples), {}};
    return LightRun(settings, file_, options(), {context, console, record}).run(start, nullptr);
  }

 private:
  std::string file_;
  BakeSettings told_;  // the options given on the command line
};

}  // namespace

std::unique_ptr<Command> make_resume(CommandLine& line) {
  return std::make_unique<Resume>(
      line.command("resume", "continue a stopped bake, or refine one to a smaller error"));
}

}  // namespace luxel
