// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "luxel/cli/area_output.h"
#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/probe_output.h"
#include "luxel/cli/probe_settings.h"
#include "luxel/cli/solved_scene.h"
#include "luxel/cli/streams.h"
#include "luxel/cli/table_output.h"
#include "luxel/cli/workplace.h"
#include "luxel/core/output_file.h"
#include "luxel/render/solution_light.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/picture_camera.h"
#include "luxel/runs/run_record.h"
#include "luxel/runs/settings.h"

namespace luxel {
namespace {

constexpr const char* table_kinds = ".csv .json";
constexpr const char* area_kinds = ".csv .json .svg .vtp";

// `probe`: measures the light of a solution at points.
class ProbeCommand final : public Command {
 public:
  explicit ProbeCommand(OptionSet& options) : Command(options) {
    options.set_positional("SOLUTION", file_, "a .vtkhdf file that 'luxel bake' wrote");
    settings_.declare(options);
    options.heading("Scene");
    look_.declare_up(options);
    run_.declare(options, area_kinds);
    options.show_first({"output", "areas", "plane", "spacing", "line", "points", "requirement",
                        "require-mean", "require-uniformity", "list-requirements", "error", "direct",
                        "drawing"});
    options.set_examples({{"luxel probe room.vtkhdf --areas areas.toml -o room.svg -o room.json",
                           "Calculation areas with verdicts, isolux lines and values."},
                          {"luxel probe room.vtkhdf --plane 0.75 --requirement writing -o plane.csv",
                           "A horizontal grid over the whole scene, with verdicts."}});
  }

  int run() override {
    if (settings_.lists_requirements) {
      const auto table = settings_.required.table();
      print_result(run_.json ? json_of(table) : text_of(table));
      return exit_fine;
    }
    settings_.check();
    const auto required = settings_.required.requirement();
    if (!run_.outputs.empty())
      check_before_work(run_, {}, settings_.areas.is_given() ? area_kinds : table_kinds);
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    const auto stored = record.stage("read", [&](auto&) { return read_stored_run(file_); });
    const auto& patches = stored.baked.patches;
    const auto& solution = stored.baked.solution;
    restore_up(solution.provenance, look_);
    check_has_lux(patches, file_);

    const Vec3d up(up_of(look_, patches));
    if (settings_.areas.is_given()) return run_areas(stored, up, {context, console, record});
    ProbeReport report{.solution = file_, .bands = patches.bands};
    report.points = settings_.points(patches, up);
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
    if (settings_.required.is_given()) {
      report.grid = judge_grid(report.light, *probe, required);
      VerdictEffort effort(settings_.probe);
      effort.add(report.grid->verdicts, report.light);
      report.grid->warnings = effort.sentences(solution_of(stored), record.stages().back().seconds);
    }
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
    write_table({.label = "probe",
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
  MeasuredSolution solution_of(const StoredRun& stored) const {
    return {file_, stored.baked.solution.seen_error, stored.samples != nullptr};
  }

  int run_areas(const StoredRun& stored, const Vec3d& up, const Workplace& place) const {
    const auto& patches = stored.baked.patches;
    const auto& solution = stored.baked.solution;
    auto& console = place.console;
    const auto areas = settings_.areas.areas(settings_.required.table(), up);
    std::optional<SolvedScene> solved;
    if (!settings_.areas.scene.empty()) {
      solved = load_solved_scene(settings_.areas.scene, file_, stored.baked, console);
      if (!solved) return stopped_before_light(console);
      keep_files_of(solved->scene);
    }
    console.announce("hierarchy");
    const Tracer tracer(patches, place.context);
    const SolutionProbe probe(patches, solution, tracer, stored.samples.get(), place.context);
    const AreaScene scene{patches, solution, tracer, up, solved ? &solved->scene : nullptr};
    AreaReport report{
        .solution = solution_of(stored), .probe = settings_.probe, .results = {}, .drawings = {}};
    for (const auto& area : areas) {
      auto result = place.record.stage(area.name, [&](auto& stage) {
        auto measured = measure_plane(probe, area, scene, settings_.probe, console.reporting(place.context));
        if (measured) stage.rays = measured->rays;
        return measured;
      });
      if (!result) return stopped_before_light(console);
      report.seconds += place.record.stages().back().seconds;
      constexpr double lift = 0.02;  // m: above surfaces in the plane
      report.drawings.push_back({.plan = plan_of(patches, result->grid, lift), .title = {}});
      report.results.push_back(std::move(*result));
    }
    console.clear_bar();
    write(report, console);
    console.say("time", place.record.summary());
    console.detail("stages", place.record.table());
    return exit_fine;
  }

  void write(const AreaReport& report, Console& console) const {
    std::vector<std::string> files;
    for (const auto& output : run_.outputs)
      for (auto& file : write_areas(report, output, settings_.areas.drawing))
        files.push_back(std::move(file));
    if (!run_.report.empty()) write_file(run_.report, json_of(report, files));
    console.say("areas", summary_of(report));
    for (const auto& warning : warnings_of(report)) warn(console.log(), warning);
    if (run_.json) return print_result(json_of(report, files));
    for (const auto& file : files) print_result(file + "\n");
    if (files.empty()) print_result(csv_of(report));
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
