// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/outputs.h"
#include "luxel/cli/probe_output.h"
#include "luxel/cli/probe_settings.h"
#include "luxel/cli/run_record.h"
#include "luxel/cli/settings.h"
#include "luxel/cli/streams.h"
#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"

namespace luxel {
namespace {

constexpr const char* table_kinds = ".csv .json";

// `probe`: measures the light of a solution at points.
class ProbeCommand final : public Command {
 public:
  explicit ProbeCommand(OptionSet& options) : Command(options) {
    options.set_positional("SOLUTION", file_, "a .vtkhdf file that 'luxel bake' wrote");
    settings_.declare(options);
    options.heading("Scene");
    look_.declare_up(options);
    run_.declare(options, table_kinds);
  }

  int run() override {
    settings_.check();
    if (!run_.outputs.empty()) check_before_work(run_, {}, table_kinds);
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    const auto stored = record.stage("read", [&](auto&) { return read_stored_run(file_); });
    const auto& patches = stored.baked.patches;
    const auto& solution = stored.baked.solution;
    restore_up(solution.provenance);
    if (!patches.has_colours())
      throw InputError(file_,
                       "its bands are neither red, green and blue nor wavelengths, so that there are no lux");

    ProbeReport report{.solution = file_, .bands = patches.bands};
    report.points = settings_.points(patches, Vec3d(up_of(look_, patches)));
    std::vector<ProbePoint> points;
    for (std::size_t i = 0; i < report.points.position.size(); ++i)
      points.push_back({Vec3(report.points.position[i] - patches.origin), Vec3(report.points.normal[i])});

    console.announce("hierarchy");
    const auto tracer = record.stage("hierarchy", [&](auto&) { return Tracer(patches, context); });
    const auto probe = record.stage("light", [&](auto&) {
      return std::make_unique<SolutionProbe>(patches, solution, tracer, stored.samples.get(), context);
    });
    report.solution_errors = probe->solved().errors();
    report.light = record.stage("points", [&](auto& stage) {
      auto light = probe_light(*probe, points, settings_.probe, console.reporting(context));
      for (const auto& l : light) stage.rays += l.rays;
      return light;
    });
    if (report.light.empty()) return stopped_before_light(console);
    if (settings_.harmonics != "none") {
      report.harmonics = settings_.harmonics == "4" ? 4 : 9;
      report.spheres = record.stage("harmonics", [&](auto& stage) {
        auto spheres =
            probe_spheres(*probe, points, report.harmonics, settings_.probe, console.reporting(context));
        for (const auto& s : spheres) stage.rays += s.rays;
        return spheres;
      });
      if (report.spheres.empty()) return stopped_before_light(console);
    }
    console.clear_bar();
    write(report, console);
    console.say("time", record.summary());
    console.detail("stages", record.table());
    return exit_fine;
  }

 private:
  // The up axis was set when the solution was made and need not be repeated.
  void restore_up(const Provenance& provenance) {
    if (look_.up != "auto") return;
    for (const auto& [key, value] : provenance.options)
      if (key == "up" && (value == "y" || value == "z")) look_.up = value;
  }

  void write(const ProbeReport& report, Console& console) const {
    for (const auto& output : run_.outputs)
      write_file(output, ending_of(output) == ".csv" ? csv_of(report) : json_of(report, settings_, {}));
    if (!run_.report.empty()) write_file(run_.report, json_of(report, settings_, run_.outputs));
    console.say("probe", summary_of(report));
    for (const auto& warning : warnings_of(report)) warn(console.log(), warning);
    if (run_.json) return print_result(json_of(report, settings_, run_.outputs));
    for (const auto& output : run_.outputs) print_result(output + "\n");
    if (run_.outputs.empty()) print_result(csv_of(report));
  }

  std::string file_;
  ProbeSettings settings_;
  LookSettings look_;
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_probe(CommandLine& line) {
  return std::make_unique<ProbeCommand>(
      line.command("probe", "measure the light of a solution at points, in lux"));
}

}  // namespace luxel
