// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/table_output.h"
#include "luxel/cli/ugr_output.h"
#include "luxel/cli/ugr_settings.h"
#include "luxel/render/solution_light.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/picture_camera.h"
#include "luxel/runs/run_record.h"
#include "luxel/runs/settings.h"

namespace luxel {
namespace {

constexpr const char* table_kinds = ".csv .json";

// `ugr`: the glare of observers in a solved scene.
class UgrCommand final : public Command {
 public:
  explicit UgrCommand(OptionSet& options) : Command(options) {
    options.set_positional("SOLUTION", file_, "a .vtkhdf file that 'luxel bake' wrote", ".vtkhdf");
    settings_.declare(options);
    options.heading("Scene");
    look_.declare_up(options);
    run_.declare(options, table_kinds);
    options.show_first(
        {"output", "observer", "observers", "grid", "view", "require-ugr", "areas", "error", "json"});
    options.set_examples(
        {{"luxel ugr office.vtkhdf --observer 3,0.2,1.2:0,1,0", "UGR of a person who looks along +y."},
         {"luxel ugr office.vtkhdf --observers seats.csv -o ugr.csv", "Many observers, as a table."}});
  }

  int run() override {
    settings_.check();
    if (!run_.outputs.empty()) check_before_work(run_, {}, table_kinds);
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    const auto stored = record.stage("read", [&](auto&) { return read_stored_run(file_); });
    const auto& patches = stored.baked.patches;
    check_has_lux(patches, file_);
    restore_up(stored.baked.solution.provenance, look_);

    const Vec3d up(up_of(look_, patches));
    const auto areas = areas_to_judge(up);
    UgrReport report{.solution = file_, .origin = patches.origin};
    report.observers = settings_.all();
    std::vector<GlareObserver> observers;
    for (std::size_t i = 0; i < report.observers.position.size(); ++i)
      observers.push_back(
          {Vec3(report.observers.position[i] - patches.origin), Vec3(report.observers.normal[i])});

    console.announce("hierarchy");
    const auto tracer = record.stage("hierarchy", [&](auto&) { return Tracer(patches, context); });
    const auto probe = record.stage("light", [&](auto&) {
      return std::make_unique<SolutionProbe>(patches, stored.baked.solution, tracer, stored.samples.get(),
                                             context);
    });
    const GlareMeter meter(*probe, up);
    report.lamps = meter.lamps();
    report.solution_errors = probe->solved().errors();
    report.glare = record.stage("observers", [&](auto& stage) {
      auto glare = observe_glare(meter, observers, settings_.glare, console.reporting(context));
      for (const auto& g : glare) stage.rays += g.rays;
      return glare;
    });
    if (report.glare.empty()) return stopped_before_light(console);
    judge(areas, up, report);
    console.clear_bar();
    write_table({.label = "ugr",
                 .summary = summary_of(report),
                 .warnings = warnings_of(report),
                 .csv = [&] { return csv_of(report); },
                 .json = [&](const auto& outputs) { return json_of(report, settings_, outputs); }},
                run_, console);
    console.say("time", record.summary());
    console.detail("stages", record.table());
    return exit_fine;
  }

 private:
  std::vector<CalculationArea> areas_to_judge(const Vec3d& up) const {
    if (settings_.areas.empty()) return {};
    RequirementTable table;
    for (const auto& more : settings_.requirements) table.add(read_toml(more));
    return read_areas(settings_.areas, table, up);
  }

  void judge(const std::vector<CalculationArea>& areas, const Vec3d& up, UgrReport& report) const {
    std::vector<NamedGlare> observers;
    for (std::size_t i = 0; i < report.glare.size(); ++i)
      observers.push_back({fmt::format("{}", i + 1), report.observers.position[i], report.glare[i]});
    if (settings_.require_ugr > 0.0)
      report.verdicts.push_back({"", judge_glare(observers, settings_.require_ugr)});
    for (const auto& area : areas)
      if (auto verdict = judge_glare(area, observers, up)) report.verdicts.push_back({area.name, *verdict});
  }

  std::string file_;
  UgrSettings settings_;
  LookSettings look_;
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_ugr(CommandLine& line) {
  return std::make_unique<UgrCommand>(
      line.command("ugr", "glare of observers in a solution: UGR with intervals and sources"));
}

}  // namespace luxel
