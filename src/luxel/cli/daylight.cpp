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
#include "luxel/cli/daylight_report.h"
#include "luxel/cli/file_date.h"
#include "luxel/cli/probe_settings.h"
#include "luxel/cli/table_output.h"
#include "luxel/cli/year_settings.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/daylight/daylight_scene.h"
#include "luxel/daylight/year_file.h"
#include "luxel/import/set_daylight.h"
#include "luxel/report/daylight_page.h"
#include "luxel/report/room_data.h"
#include "luxel/runs/daylight_transport.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/picture_camera.h"
#include "luxel/runs/run_record.h"
#include "luxel/runs/settings.h"
#include "luxel/scene/up_axis.h"
#include "luxel/sky/sky_integrals.h"
#include "luxel/version.h"

namespace luxel {
namespace {

constexpr const char* kinds = ".csv .json .h5 .svg .html";
constexpr double en_17037_height = 0.85, en_17037_border = 0.5;  // m

bool is_year_file(const std::string& output) { return output.ends_with(".h5"); }
bool is_drawing(const std::string& output) { return output.ends_with(".svg"); }

// `daylight`: daylight factors, and a year of daylight, from one solve.
class DaylightCommand final : public Command {
 public:
  explicit DaylightCommand(OptionSet& options) : Command(options) {
    scene_.declare(options);
    places_.declare_points(options);
    declare_sky(options);
    year_.declare(options);
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
    run_.declare(options, kinds);
    options.show_first(
        {"output", "weather", "plane", "spacing", "border", "north", "occupied", "heat-map", "error"});
    options.set_examples({{"luxel daylight room.obj -o factors.csv",
                           "Daylight factors on a plane at 0.85 m, 0.5 m from the walls."},
                          {"luxel daylight room.obj --weather chicago.epw -o year.h5 -o points.csv",
                           "Also a year hour by hour, with DA, sDA, UDI, ASE and EN 17037."},
                          {"luxel daylight room.obj --weather chicago.epw -o plan.svg --heat-map year.svg",
                           "Plans over the room, and the hours of the year as a picture."},
                          {"luxel daylight room.obj --weather chicago.epw -o daylight.html",
                           "A report: requirements with verdicts, plans, figures, assumptions."}});
  }

  int run() override {
    check();
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    std::optional<Weather> weather;
    if (!weather_file_.empty()) weather = load_weather(weather_file_);
    MetricOptions metrics;
    if (weather) {
      for (const auto& oddity : weather->oddities) warn(noting(console, context).log(), oddity);
      metrics = year_.metrics(*weather);
    }

    auto scene = record.stage(
        "load", [&](auto&) { return load_scene(scene_.file, scene_.load, noting(console, context)); });
    if (interrupted()) return stopped_before_light(console);
    keep_files_of(scene);
    const auto up = up_of(scene);
    const SkyPatches sky(subdivision_, up, north_of(up, north_));
    YearSkies skies;
    if (weather)
      skies = record.stage("skies", [&](auto&) { return skies_of_year(*weather, sky, albedo_, context); });
    set_only_sky(sky, weather ? mean_sky(skies) : overcast_sky(sky, albedo_), scene);
    const auto groups = year_.groups();
    make_panes_of_groups(groups, scene);
    const auto transport = solve_daylight(
        scene, scene_.file, {scene_.patches, error_, coefficients_.seed},
        [&](const PatchSet& patches) { drawings_.check_point(points(patches, up).position.size()); },
        {context, console, record});
    if (!transport) return stopped_before_light(console);

    const auto& tracer = *transport->tracer;
    DaylightReport report;
    report.scene = scene_.file;
    report.points = points(transport->patches, up);
    const auto coefficients = record.stage("coefficients", [&](auto& stage) {
      auto found =
          find_coefficients(transport->run(), tracer, probe_points(transport->patches, report.points),
                            coefficients_, console.reporting(context));
      stage.rays = found.rays;
      return found;
    });
    if (coefficients.points == 0) return stopped_before_light(console);
    report.knows_openings = coefficients.knows_openings;
    report.sky_patches = sky.upper();
    report.solve_error = transport->error;
    for (const int type : {16, 1}) report.factors.push_back(daylight_factors(coefficients, type, albedo_));
    if (weather) {
      const auto figures = weather_figures(*weather);
      report.place = weather->place;
      report.median_diffuse = figures.bright_half_median;
    }
    if (median_diffuse_ > 0.0) report.median_diffuse = median_diffuse_;
    if (report.median_diffuse > 0.0)
      report.provision = factor_provision(report.factors.front(), report.median_diffuse);
    WindowLight windows;
    std::optional<DaylightYear> year;
    if (weather) {
      windows = record.stage("windows", [&](auto& stage) {
        if (groups.empty()) return all_windows(year_.transmittance());
        auto light =
            window_light(scene, *transport, coefficients, groups, coefficients_, console.reporting(context));
        for (const auto& without : light.without) stage.rays += without.rays + transport->samples->rays;
        return light;
      });
      if (windows.groups.empty()) return stopped_before_light(console);
      year.emplace(record.stage("sun", [&](auto&) {
        return DaylightYear({coefficients, windows}, skies, coefficients.origins,
                            {transport->patches, tracer}, console.reporting(context));
      }));
      if (year->is_stopped()) return stopped_before_light(console);
      report.year = record.stage("metrics", [&](auto&) { return metrics_of(*year, *weather, metrics); });
    }
    console.clear_bar();
    DrawnDaylight drawn{report, metrics, year ? &*year : nullptr, weather ? &*weather : nullptr, {}};
    drawn.ground =
        DaylightDrawings::ground_of(places_, up, {transport->patches, transport->openings, sky.north()});
    write(drawn, transport->patches, up, console);
    console.say("time", record.summary());
    console.detail("stages", record.table());
    return exit_fine;
  }

 private:
  void declare_sky(OptionSet& options) {
    options.heading("Sky");
    Declaration weather{
        "weather", "FILE",
        "weather of a year, EPW or WEA: hourly illuminances and the metrics of the year; without it "
        "daylight factors alone",
        [this](const std::string& text) { weather_file_ = text; }, [this] { return weather_file_; }};
    weather.endings = ".epw .wea";
    options.add(std::move(weather));
    options.add_number(
        "north", "degrees", north_, -360.0, 360.0,
        "where north is: clockwise seen from above, from +Y where Z is up, from -Z where Y is up");
    options.add_number("albedo", "0..1", albedo_, 0.0, 1.0, "diffuse reflectance of the ground outside");
    options.add(
        {"sky-patches", "145|577|2305", "patches of the sky: 577 are right to 1 % at points, 145 in the mean",
         [this](const std::string& text) {
           subdivision_ = text == "145" ? 1 : text == "577" ? 2 : text == "2305" ? 4 : 0;
           if (subdivision_ == 0)
             throw UsageError(fmt::format("--sky-patches: expected one of 145|577|2305, not '{}'", text));
         },
         [this] { return fmt::format("{}", 144 * subdivision_ * subdivision_ + 1); }});
    options.add_number("median-diffuse", "lx", median_diffuse_, 0.0, 1e6,
                       "median diffuse illuminance outside, for EN 17037 by daylight factors; 0: that of the "
                       "weather file");
  }

  void check() {
    const bool has_points = !places_.file.empty() || places_.line || places_.grid || places_.plane;
    if (!has_points) {
      places_.plane = en_17037_height;
      if (places_.border == ProbeSettings().border) places_.border = en_17037_border;
    }
    places_.check();
    drawings_.check(places_, run_.outputs, !weather_file_.empty());
    if (!run_.outputs.empty() || !drawings_.files().empty())
      check_before_work(run_, {}, kinds, drawings_.files());
    year_.check(!weather_file_.empty());
    if (weather_file_.empty() && std::any_of(run_.outputs.begin(), run_.outputs.end(), is_year_file))
      throw UsageError("-o FILE.h5 holds the hours of a year: give --weather FILE");
  }

  Vec3d up_of(const Scene& scene) const {
    if (look_.up == "y") return {0.0, 1.0, 0.0};
    if (look_.up == "z") return {0.0, 0.0, 1.0};
    return Vec3d(up_of_scene(scene));
  }

  PointList points(const PatchSet& patches, const Vec3d& up) const { return places_.points(patches, up); }

  // Counted from the patches' origin.
  static std::vector<ProbePoint> probe_points(const PatchSet& patches, const PointList& list) {
    std::vector<ProbePoint> points;
    for (std::size_t i = 0; i < list.position.size(); ++i)
      points.push_back({Vec3(list.position[i] - patches.origin), Vec3(list.normal[i])});
    return points;
  }

  // Reports messages, and keeps them for the page.
  Context noting(Console& console, const Context& context) {
    return console.reporting(context).with_log([this, log = console.log()](const Message& message) {
      notes_.push_back(message.text);
      log(message);
    });
  }

  void write(const DrawnDaylight& drawn, const PatchSet& patches, const Vec3d& up, Console& console) {
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
                 .other = [&](const auto& output) { return write_other(output, drawn, patches, up); }},
                run, console);
  }

  bool write_other(const std::string& output, const DrawnDaylight& drawn, const PatchSet& patches,
                   const Vec3d& up) const {
    const auto& points = drawn.report.points;
    if (is_year_file(output))
      write_year(output, *drawn.year, *drawn.weather, {points.position, points.normal, points.columns},
                 *drawn.report.year);
    else if (is_drawing(output))
      drawings_.write(output, drawn);
    else if (is_page(output))
      write_file(output, daylight_page(page_of(drawn, patches, up)));
    else
      return false;
    return true;
  }

  DaylightPage page_of(const DrawnDaylight& drawn, const PatchSet& patches, const Vec3d& up) const {
    const auto& report = drawn.report;
    DaylightPage page;
    page.title = "Daylight: " + std::filesystem::path(scene_.file).stem().string();
    page.scene = scene_.file;
    page.scene_date = day_of_file(scene_.file);
    page.version = LUXEL_VERSION;
    page.command = options().given_as_command(RunSettings::heading);
    page.place = report.place;
    page.weather = weather_file_;
    page.points_description = points_text(report.points);
    page.room = find_room_data(patches, up);
    page.factors = report.factors;
    page.provision = report.provision;
    page.median_diffuse = report.median_diffuse;
    page.knows_openings = report.knows_openings;
    page.year = report.year;
    page.metrics = drawn.metrics;
    page.sky_patches = report.sky_patches;
    page.albedo = albedo_;
    page.north = north_;
    page.solve_error = report.solve_error;
    page.seed = coefficients_.seed;
    page.notes = notes_;
    drawings_.add(drawn, page);
    return page;
  }

  std::string points_text(const PointList& points) const {
    const auto count = points.position.size();
    auto text = points.columns > 0 ? fmt::format("{} × {} points", points.columns, count / points.columns)
                                   : fmt::format("{} points", count);
    if (places_.plane)
      text += fmt::format(" at a height of {:g} m, {:g} m from the walls", *places_.plane, places_.border);
    return text;
  }

  SceneSettings scene_;
  ProbeSettings places_;
  LookSettings look_;
  RunSettings run_;
  CoefficientOptions coefficients_;
  YearSettings year_;
  DaylightDrawings drawings_;
  std::vector<std::string> notes_;  // of reading the scene
  std::string weather_file_;
  double north_ = 0.0, albedo_ = Daylight().albedo, median_diffuse_ = 0.0, error_ = 0.05;
  int subdivision_ = 2;
};

}  // namespace

std::unique_ptr<Command> make_daylight(CommandLine& line) {
  return std::make_unique<DaylightCommand>(
      line.command("daylight", "daylight factors, and a year of daylight, at points"));
}

}  // namespace luxel
