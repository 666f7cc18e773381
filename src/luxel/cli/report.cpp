// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/file_date.h"
#include "luxel/cli/lighting_report_json.h"
#include "luxel/cli/report_daylight.h"
#include "luxel/cli/report_measurements.h"
#include "luxel/cli/report_observers.h"
#include "luxel/cli/report_settings.h"
#include "luxel/cli/solved_scene.h"
#include "luxel/cli/streams.h"
#include "luxel/cli/verdict_effort.h"
#include "luxel/cli/workplace.h"
#include "luxel/cli/wrapped_text.h"
#include "luxel/core/output_file.h"
#include "luxel/export/number_text.h"
#include "luxel/export/report_page.h"
#include "luxel/image/image_file.h"
#include "luxel/render/solution_light.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/picture_camera.h"
#include "luxel/runs/run_record.h"
#include "luxel/runs/settings.h"
#include "luxel/version.h"

namespace luxel {
namespace {

constexpr const char* page_kinds = ".html .json";

// `report`: the report of a lighting design.
class ReportCommand final : public Command {
 public:
  explicit ReportCommand(OptionSet& options) : Command(options) {
    options.set_positional("SOLUTION", file_, "a .vtkhdf file that 'luxel bake' wrote", ".vtkhdf");
    settings_.declare(options);
    daylight_.declare(options);
    options.heading("Scene");
    look_.declare_up(options);
    run_.declare(options, page_kinds);
    options.show_first({"output", "title", "project", "author", "plane", "areas", "requirement",
                        "require-mean", "require-uniformity", "require-ugr", "maintenance", "json"});
    options.set_examples({{"luxel report office.vtkhdf -o office.html", "The report of a lighting design."},
                          {"luxel report office.vtkhdf --require-mean 500 --require-uniformity 0.6 "
                           "--require-ugr 19 -o office.html",
                           "With verdicts on what is required."},
                          {"luxel report office.vtkhdf --scene office.obj --weather city.epw -o office.html",
                           "With daylight factors and a year of daylight."}});
  }

  int run() override {
    settings_.settle(daylight_.is_wanted());
    daylight_.check(!settings_.scene.empty());
    if (run_.outputs.empty() && !run_.json && run_.report.empty())
      throw UsageError("no file to write: give -o report.html, or --json");
    if (!run_.outputs.empty()) check_before_work(run_, {}, page_kinds);
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    const auto stored = record.stage("read", [&](auto&) { return read_stored_run(file_); });
    check_has_lux(stored.baked.patches, file_);
    restore_up(stored.baked.solution.provenance, look_);
    console.announce("hierarchy");
    const auto tracer =
        record.stage("hierarchy", [&](auto&) { return Tracer(stored.baked.patches, context); });
    LightingReport report;
    const Workplace place{context, console, record};
    if (!fill(stored, tracer, place, report)) return stopped_before_light(console);
    console.clear_bar();
    write(report, console);
    console.say("time", record.summary());
    console.detail("stages", record.table());
    return exit_fine;
  }

 private:
  // Returns false where the user stopped the work.
  bool fill(const StoredRun& stored, const Tracer& tracer, const Workplace& place, LightingReport& report) {
    const auto& patches = stored.baked.patches;
    const auto probe = place.record.stage("light", [&](auto&) {
      return std::make_unique<SolutionProbe>(patches, stored.baked.solution, tracer, stored.samples.get(),
                                             place.context);
    });
    set_titles(report);
    set_origin(stored.baked, *probe, report);
    report.room = find_room_data(patches, Vec3d(up_of(look_, patches)));
    report.maintenance.luminaires = luminaire_maintenance(patches);
    report.luminaires =
        place.record.stage("luminaires", [&](auto&) { return list_luminaires(patches, report.room.axes); });
    std::optional<SolvedScene> solved;
    if (!settings_.scene.empty()) {
      solved = load_solved_scene(settings_.scene, file_, stored.baked, place.console);
      if (!solved) return false;
      keep_files_of(solved->scene);
    }
    ReportMeasurements measurements(settings_, stored, *probe, place);
    if (!measurements.add_planes(solved ? &solved->scene : nullptr, report)) return false;
    measurements.add_surfaces(report);
    if (settings_.has_unfolded && !measurements.add_faces(report)) return false;
    if (!add_observers(settings_, *probe, place, report)) return false;
    if (settings_.has_picture) report.picture = draw(stored.baked, tracer, place);
    if (daylight_.is_wanted() && !daylight_.add(solved->scene, settings_.scene, place, report)) return false;
    if (interrupted()) return false;
    add_warnings(stored, measurements.seconds_of_planes(), report);
    return true;
  }

  void set_titles(LightingReport& report) const {
    const std::filesystem::path path(file_);
    report.title = settings_.title.empty() ? "Lighting report: " + path.stem().string() : settings_.title;
    report.project = settings_.project;
    report.author = settings_.author;
    report.hours = settings_.hours;
    report.date = settings_.date;
    if (!report.date.empty()) return;
    report.date_label = "Solution file dated";
    report.date = day_of_file(path);
  }

  void set_origin(const Baked& baked, const SolutionProbe& probe, LightingReport& report) const {
    const auto& provenance = baked.solution.provenance;
    report.origin = {.solution = file_,
                     .version = LUXEL_VERSION,
                     .report_command = options().given_as_command(RunSettings::heading),
                     .solution_version = provenance.program_version,
                     .solution_command = provenance.command_line,
                     .method = provenance.method,
                     .seed = provenance.seed,
                     .rays = provenance.rays,
                     .measuring_seed = settings_.probe.seed,
                     .patches = baked.patches.size(),
                     .seen_error = baked.solution.seen_error,
                     .errors = probe.solved().errors()};
  }

  std::string draw(const Baked& baked, const Tracer& tracer, const Workplace& place) const {
    constexpr int width = 960, height = 720;  // pixels
    return place.record.stage("picture", [&](auto&) {
      PictureSettings picture;
      picture.render.width = width;
      picture.render.height = height;
      const auto context = place.console.reporting(place.context);
      const auto camera = camera_of(picture, look_, baked, tracer, place.context);
      const auto light = make_smooth_light(baked.patches, baked.solution, look_.smooth, place.context);
      const auto drawn = render_picture(baked.patches, light, tracer, camera, picture.render, context);
      return png_of(tone_map(drawn.radiance, look_.tone, drawn.edges, drawn.sky), {}, context);
    });
  }

  // seconds_of_planes: s, that measuring them took.
  void add_warnings(const StoredRun& stored, double seconds_of_planes, LightingReport& report) const {
    VerdictEffort effort(settings_.probe);
    for (const auto& [result, drawing] : report.planes) {
      effort.add(result.verdicts, result.light);
      if (const auto twice = maintenance_warning(result.maintenance(), result.area.name); !twice.empty())
        report.warnings.push_back(sentence(twice));
    }
    if (report.ugr_verdict) effort.add(*report.ugr_verdict);
    for (const auto& text : effort.sentences(
             {file_, stored.baked.solution.seen_error, stored.samples != nullptr}, seconds_of_planes))
      report.warnings.push_back(sentence(text));
    if (report.luminaires.types.empty())
      report.warnings.push_back(
          "The solution has no luminaires with photometric files: bake it with --luminaires or "
          "--luminaire-grid to have a list of luminaires and their power.");
    for (const auto& [result, drawing] : report.planes)
      if (result.unreached > 0)
        report.warnings.push_back(
            fmt::format("{} of {} points of the {} have a larger error than requested: more --rays "
                        "reduce it.",
                        result.unreached, result.grid.points(), result.area.name));
    std::size_t large = 0;
    for (const auto& o : report.observers) large += o.glare.large > 0 ? 1 : 0;
    if (large > 0)
      report.warnings.push_back(
          fmt::format("{} of {} observers see a source above 0.1 sr, for which UGR is not made.", large,
                      report.observers.size()));
  }

  void write(const LightingReport& report, Console& console) const {
    const auto json = [&](const std::vector<std::string>& outputs) {
      return json_of(report, daylight_.result() ? &*daylight_.result() : nullptr, outputs);
    };
    for (const auto& output : run_.outputs)
      write_file(output, is_page(output) ? report_page(report) : json({}));
    if (!run_.report.empty()) write_file(run_.report, json(run_.outputs));
    console.say("report", summary_of(report));
    if (daylight_.result()) console.say("daylight", luxel::summary_of(*daylight_.result()));
    for (const auto& warning : report.warnings) warn(console.log(), warning);
    if (run_.json) return print_result(json(run_.outputs));
    for (const auto& output : run_.outputs) print_result(output + "\n");
  }

  static std::string sentence_of_report(const Verdict& verdict) {
    auto text = beginning_of(verdict) + name(verdict.compliance);
    for (const auto& more : {verdict.note, remedy_of(verdict)})
      if (!more.empty()) text += "; " + more;
    return text;
  }

  static std::string summary_of(const LightingReport& report) {
    std::string text;
    for (const auto& [result, drawing] : report.planes) {
      text += fmt::format("{}{}: mean {} lx, U0 {}", text.empty() ? "" : "\n", result.area.name,
                          lux_text(result.mean), ratio_text(result.min_over_mean));
      for (const auto& verdict : result.verdicts) text += "\n" + sentence_of_report(verdict);
    }
    if (const auto most = report.max_glare())
      text += fmt::format("\nhighest UGR {}", ugr_text(report.observers[*most].ugr()));
    if (report.ugr_verdict) text += "\n" + sentence_of_report(*report.ugr_verdict);
    if (const auto density = report.power_density())
      text += fmt::format("\ninstalled power {:.2f} W/m²", *density);
    return text;
  }

  std::string file_;
  ReportSettings settings_;
  ReportDaylight daylight_;
  LookSettings look_;
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_report(CommandLine& line) {
  return std::make_unique<ReportCommand>(line.command(
      "report", "report of a lighting design as an HTML page: luminaires, planes, glare, power"));
}

}  // namespace luxel
