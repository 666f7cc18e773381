// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "luxel/cli/accuracy_text.h"
#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/finish.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/quantity.h"
#include "luxel/solution/merge_solutions.h"
#include "luxel/solve/seen_measure.h"
#include "luxel/trace/tracer.h"
#include "luxel/version.h"

namespace luxel {
namespace {

// `merge`: combines independent solutions of a scene into one with a smaller error.
class Merge final : public Command {
 public:
  explicit Merge(OptionSet& options) : Command(options) {
    options.set_positionals("SOLUTION", files_, "two or more .vtkhdf files, each baked with its own --seed");
    look_.declare(options);
    picture_.declare(options);
    picture_.declare_gather(options);
    run_.declare(options, all_kinds);
    options.show_first({"output", "eye", "target", "width", "height", "exposure", "open"});
    options.set_examples({{"luxel merge a.vtkhdf b.vtkhdf -o ab.vtkhdf -o ab.png",
                           "One solution of two bakes with different --seed."}});
  }

  int run() override {
    check_before_work(run_, picture_, all_kinds);
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    std::vector<NamedSolution> solutions;
    record.stage("read", [&](auto&) {
      for (const auto& file : files_) solutions.push_back({file, read_solution(file)});
    });
    auto merged = record.stage("merge", [&](auto&) { return merge_solutions(std::move(solutions)); });
    merged.solution.provenance.program_version = LUXEL_VERSION;
    const Tracer tracer(merged.patches, context);
    record.stage("views", [&](auto&) {
      merged.solution.seen_error = seen_error_of(merged.patches, tracer, merged.solution, context);
      return 0;
    });
    const auto& provenance = merged.solution.provenance;
    console.say("merged",
                fmt::format("{} runs with {} rays", provenance.merged.size(), rough_count(provenance.rays)));
    console.say("error", accuracy_text(merged.solution));
    return write_and_finish(merged, &tracer, options(), {run_, look_, picture_}, {context, console, record});
  }

 private:
  std::vector<std::string> files_;
  LookSettings look_;
  PictureSettings picture_;
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_merge(CommandLine& line) {
  return std::make_unique<Merge>(
      line.command("merge", "merge independent solutions of one scene into one with a smaller error"));
}

}  // namespace luxel
