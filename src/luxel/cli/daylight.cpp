// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/daylight_drawings.h"
#include "luxel/cli/daylight_input.h"
#include "luxel/cli/daylight_report.h"
#include "luxel/cli/file_date.h"
#include "luxel/cli/probe_settings.h"
#include "luxel/cli/table_output.h"
#include "luxel/cli/workplace.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/daylight_page.h"
#include "luxel/export/room_data.h"
#include "luxel/lighting/year_file.h"
#include "luxel/runs/daylight_run.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/picture_camera.h"
#include "luxel/runs/run_record.h"
#include "luxel/runs/settings.h"
#include "luxel/scene/up_axis.h"

namespace luxel {
namespace {

constexpr const char* kinds = ".csv .json .h5 .svg .html .vtkhdf";

bool is_year_file(const std::string& output) { return output.ends_with(".h5"); }
bool is_drawing(const std::string& output) { return output.ends_with(".svg"); }

// `daylight`: daylight factors, and a year of daylight, from one solve.
class DaylightCommand final : public Command {
 public:
  explicit DaylightCommand(OptionSet& options) : Command(options) {
    scene_.declare(options, "the mesh (OBJ with MTL, glTF), or a run that -o run.vtkhdf stored");
    places_.declare_points(options);
    options.heading("Sky");
    input_.declare_sky(options);
    input_.year.declare(options);
    drawings_.declare(options);
    options.heading("Light");
    options.add_fraction(
        "error", error_,
        "standard error of the light that the sky's patches together give, seen from 95 % of "
        "viewpoints, such as 2% or 0.02");
    options.add_number("rays", "count", coefficients_.rays, 64u, 1u << 24,
                       "cosine rays per point, and as many towards windows");
    options.add_count("seed", coefficients_.seed,
                      "seed of the random numbers; other seeds give independent errors");
    options.heading("Scene");
    look_.declare_up(options);
    options.heading("Changes of a stored run");
    changes_.declare(options);
    run_.declare(options, kinds);
    options.show_first(
        {"output", "weather", "plane", "spacing", "border", "north", "occupied", "heat-map", "error"});
    options.set_examples(
        {{"luxel daylight room.obj -o factors.csv",
          "Daylight factors on a plane at 0.85 m, 0.5 m from the walls."},
         {"luxel daylight room.obj --weather chicago.epw -o year.h5 -o points.csv",
          "Also a year hour by hour, with DA, sDA, UDI, ASE and EN 17037."},
         {"luxel daylight room.obj --weather chicago.epw -o plan.svg --heat-map year.svg",
          "Plans over the room, and the hours of the year as a picture."},
         {"luxel daylight run.vtkhdf --weather chicago.epw --reflectance wall=0.7 -o other.csv",
          "Another wall, by the rays of a run that -o run.vtkhdf stored."},
         {"luxel daylight room.obj --weather chicago.epw -o daylight.html",
          "A report: requirements with verdicts, plans, figures, assumptions."}});
  }

  int run() override {
    check();
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    auto log = noting(console, context).log();
    PointList points;
    const auto answer = is_run() ? from_run(points, {context, console, record})
                                 : from_scene(points, {context, console, record});
    if (!answer) return stopped_before_light(console);
    console.clear_bar();
    const auto report = input_.report_of(*answer, scene_.file, std::move(points));
    DrawnDaylight drawn{report, *answer, {}};
    drawn.ground = DaylightDrawings::ground_of(places_, *answer);
    write(drawn, console);
    console.say("time", record.summary());
    console.detail("stages", record.table());
    return exit_fine;
  }

 private:
  bool is_run() const { return scene_.file.ends_with(".vtkhdf"); }

  // The question; a stored run replaces its sky.
  DaylightQuestion question(const Vec3d& up, const Workplace& place) {
    auto question = input_.question(up, noting(place.console, place.context).log());
    question.solve = {scene_.patches, error_, coefficients_.seed};
    question.coefficients = coefficients_;
    return question;
  }

  PointsOfPatches points_to(PointList& points, const Vec3d& up) const {
    return [this, &points, up](const PatchSet& patches) {
      points = places_.points(patches, up);
      drawings_.check_point(points.position.size());
      return probe_points(patches, points);
    };
  }

  std::unique_ptr<DaylightAnswer> from_scene(PointList& points, const Workplace& place) {
    auto asked = question({0.0, 0.0, 1.0}, place);
    auto scene = place.record.stage("load", [&](auto&) {
      return load_scene(scene_.file, scene_.load, noting(place.console, place.context));
    });
    if (interrupted()) return nullptr;
    keep_files_of(scene);
    const auto up = asked.up = up_of(scene);
    return study_daylight(std::move(scene), scene_.file, std::move(asked), points_to(points, up), place);
  }

  std::unique_ptr<DaylightAnswer> from_run(PointList& points, const Workplace& place) {
    auto stored = place.record.stage(
        "read", [&](auto&) { return read_daylight_run(scene_.file, changes_, place.context); });
    auto asked = question(stored.up, place);
    asked.north = stored.north;
    asked.subdivision = stored.subdivision;
    place.console.say(
        "run", fmt::format("{}: {} patches, no new solve", scene_.file, stored.transport.patches.size()));
    return study_daylight(std::move(stored.transport), std::move(asked), points_to(points, stored.up), place);
  }

  void check_run() const {
    if (!is_run() && changes_.any())
      throw UsageError(
          "--reflectance and --transmittance change a stored run: store one with 'luxel daylight SCENE -o "
          "RUN.vtkhdf', and give it in place of the scene");
    for (const char* name : {"north", "sky-patches", "error", "max-edge"})
      if (is_run() && options().is_given(name))
        throw UsageError(
            fmt::format("--{} is that of the stored run: give the scene in place of the run to "
                        "have another one",
                        name));
  }

  void check() {
    check_run();
    const bool has_points = !places_.file.empty() || places_.line || places_.grid || places_.plane;
    if (!has_points) {
      places_.plane = en_17037_height;
      if (places_.border == ProbeSettings().border) places_.border = en_17037_border;
    }
    places_.check();
    drawings_.check(places_, run_.outputs, !input_.weather.empty());
    if (!run_.outputs.empty() || !drawings_.files().empty())
      check_before_work(run_, {}, kinds, drawings_.files());
    input_.year.check(!input_.weather.empty());
    if (input_.weather.empty() && std::any_of(run_.outputs.begin(), run_.outputs.end(), is_year_file))
      throw UsageError("-o FILE.h5 holds the hours of a year: give --weather FILE");
  }

  Vec3d up_of(const Scene& scene) const {
    if (look_.up == "y") return {0.0, 1.0, 0.0};
    if (look_.up == "z") return {0.0, 0.0, 1.0};
    return Vec3d(up_of_scene(scene));
  }

  // Reports messages, and keeps them for the page.
  Context noting(Console& console, const Context& context) {
    return console.reporting(context).with_log([this, log = console.log()](const Message& message) {
      notes_.push_back(message.text);
      log(message);
    });
  }

  void write(const DrawnDaylight& drawn, Console& console) {
    const auto& report = drawn.report;
    auto run = run_;
    for (const auto& [option, file] : drawings_.files()) run.outputs.push_back(file);
    std::vector<std::string> warnings;
    if (!report.knows_openings)
      warnings.emplace_back(
          "no windows or other openings were found, so externally and internally reflected light are not "
          "told apart");
    write_table({.label = "daylight",
                 .summary = summary_of(report),
                 .warnings = std::move(warnings),
                 .csv = [&] { return csv_of(report); },
                 .json = [&](const auto& outputs) { return json_of(report, outputs); },
                 .other = [&](const auto& output) { return write_other(output, drawn); }},
                run, console);
  }

  bool write_other(const std::string& output, const DrawnDaylight& drawn) const {
    const auto& points = drawn.report.points;
    if (is_year_file(output))
      write_year(output, *drawn.answer.year, *drawn.answer.question.weather,
                 {points.position, points.normal, points.columns}, *drawn.report.year);
    else if (is_drawing(output))
      drawings_.write(output, drawn);
    else if (output.ends_with(".vtkhdf"))
      write_daylight_run(output, drawn.answer, options().as_command(RunSettings::heading));
    else if (is_page(output))
      write_file(output, daylight_page(page_of(drawn)));
    else
      return false;
    return true;
  }

  DaylightPage page_of(const DrawnDaylight& drawn) const {
    const auto& answer = drawn.answer;
    auto page =
        input_.page_of(drawn.report, answer, find_room_data(answer.transport->patches, answer.question.up));
    page.title = "Daylight: " + std::filesystem::path(scene_.file).stem().string();
    page.scene_date = day_of_file(scene_.file);
    page.command = options().given_as_command(RunSettings::heading);
    page.points_description = points_text(drawn.report.points, places_);
    page.notes = notes_;
    drawings_.add(drawn, page);
    return page;
  }

  SceneSettings scene_;
  ProbeSettings places_;
  LookSettings look_;
  RunSettings run_;
  CoefficientOptions coefficients_;
  DaylightInput input_;
  DaylightDrawings drawings_;
  DaylightChanges changes_;
  std::vector<std::string> notes_;  // of reading the scene
  double error_ = 0.05;
};

}  // namespace

std::unique_ptr<Command> make_daylight(CommandLine& line) {
  return std::make_unique<DaylightCommand>(
      line.command("daylight", "daylight factors, and a year of daylight, at points"));
}

}  // namespace luxel
