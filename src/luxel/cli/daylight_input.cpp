// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/daylight_input.h"

#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/photometry/weather_figures.h"
#include "luxel/version.h"

namespace luxel {

void DaylightInput::declare_sky(OptionSet& options) {
  Declaration file{"weather", "FILE",
                   "weather of a year, EPW or WEA: hourly illuminances and the metrics of the year; without "
                   "it daylight factors alone",
                   [this](const std::string& text) { weather = text; }, [this] { return weather; }};
  file.endings = ".epw .wea";
  options.add(std::move(file));
  options.add_number(
      "north", "degrees", north, -360.0, 360.0,
      "where north is: clockwise seen from above, from +Y where Z is up, from -Z where Y is up");
  options.add_number("albedo", "0..1", albedo, 0.0, 1.0, "diffuse reflectance of the ground outside");
  options.add(
      {"sky-patches", "145|577|2305", "patches of the sky: 577 are right to 1 % at points, 145 in the mean",
       [this](const std::string& text) {
         subdivision = text == "145" ? 1 : text == "577" ? 2 : text == "2305" ? 4 : 0;
         if (subdivision == 0)
           throw UsageError(fmt::format("--sky-patches: expected one of 145|577|2305, not '{}'", text));
       },
       [this] { return fmt::format("{}", 144 * subdivision * subdivision + 1); }});
  options.add_number("median-diffuse", "lx", median_diffuse, 0.0, 1e6,
                     "median diffuse illuminance outside, for EN 17037 by daylight factors; 0: that of the "
                     "weather file");
}

DaylightQuestion DaylightInput::question(const Vec3d& up, const LogSink& log) const {
  DaylightQuestion q;
  if (!weather.empty()) {
    q.weather = load_weather(weather);
    for (const auto& oddity : q.weather->oddities) warn(log, oddity);
    q.metrics = year.metrics(*q.weather);
  }
  q.up = up;
  q.north = north;
  q.albedo = albedo;
  q.subdivision = subdivision;
  q.blinds = year.groups();
  q.transmittance = year.transmittance();
  return q;
}

DaylightReport DaylightInput::report_of(const DaylightAnswer& answer, const std::string& scene,
                                        PointList points) const {
  DaylightReport report;
  report.scene = scene;
  report.points = std::move(points);
  report.factors = answer.factors;
  report.knows_openings = answer.coefficients.knows_openings;
  report.sky_patches = answer.sky.upper();
  report.solve_error = answer.transport->error;
  if (const auto& of_year = answer.question.weather) {
    report.place = of_year->place;
    report.median_diffuse = weather_figures(*of_year).bright_half_median;
  }
  if (median_diffuse > 0.0) report.median_diffuse = median_diffuse;
  if (report.median_diffuse > 0.0)
    report.provision = factor_provision(report.factors.front(), report.median_diffuse);
  report.year = answer.report;
  return report;
}

DaylightPage DaylightInput::page_of(const DaylightReport& report, const DaylightAnswer& answer,
                                    RoomData room) const {
  DaylightPage page;
  page.scene = report.scene;
  page.version = LUXEL_VERSION;
  page.place = report.place;
  page.weather = weather;
  page.room = std::move(room);
  page.factors = report.factors;
  page.provision = report.provision;
  page.median_diffuse = report.median_diffuse;
  page.knows_openings = report.knows_openings;
  page.year = report.year;
  page.metrics = answer.question.metrics;
  page.sky_patches = report.sky_patches;
  page.albedo = answer.question.albedo;
  page.north = answer.question.north;
  page.solve_error = report.solve_error;
  page.seed = answer.question.coefficients.seed;
  return page;
}

std::string points_text(const PointList& points, const ProbeSettings& places) {
  const auto count = points.position.size();
  auto text = points.columns > 0 ? fmt::format("{} × {} points", points.columns, count / points.columns)
                                 : fmt::format("{} points", count);
  if (places.plane)
    text += fmt::format(" at a height of {:g} m, {:g} m from the walls", *places.plane, places.border);
  return text;
}

std::vector<ProbePoint> probe_points(const PatchSet& patches, const PointList& list) {
  std::vector<ProbePoint> points;
  for (std::size_t i = 0; i < list.position.size(); ++i)
    points.push_back({Vec3(list.position[i] - patches.origin), Vec3(list.normal[i])});
  return points;
}

}  // namespace luxel
