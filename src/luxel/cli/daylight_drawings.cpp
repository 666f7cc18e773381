// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/daylight_drawings.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/core/utf8.h"
#include "luxel/lighting/daylight_plans.h"
#include "luxel/lighting/heat_map.h"

namespace luxel {
namespace {

bool is_skewed(const PointGrid& grid) {
  const auto a = grid.first - grid.corner, b = grid.second - grid.corner;
  return std::abs(glm::dot(a, b)) > 1e-6 * glm::length(a) * glm::length(b);
}

std::vector<MetricPlan> plans_of(const DaylightReport& report) {
  std::vector<MetricPlan> plans = {plan_of(report.factors.front())};
  if (report.year)
    for (auto& plan : plans_of(report.year->metrics)) plans.push_back(std::move(plan));
  return plans;
}

}  // namespace

void DaylightDrawings::declare(OptionSet& set) {
  const auto add_file = [&set](const std::string& name, std::string& file, const std::string& help) {
    Declaration declaration{name, "FILE", help,
                            [name, &file](const std::string& text) {
                              if (!text.empty()) expect_ending("--" + name, text, ".svg");
                              file = text;
                            },
                            [&file] { return file; }};
    declaration.endings = ".svg";
    declaration.is_output = true;
    set.add(std::move(declaration));
  };
  add_file("heat-map", heat_map_, "SVG drawing of the illuminance of each hour of the year: hour over day");
  set.add({"heat-map-point", "N|mean",
           "--heat-map: a point, counted from 1 in the order of the table, or the mean over all points",
           [this](const std::string& text) {
             const auto number = parse_number(text);
             if (text != "mean" &&
                 (!number || !(*number >= 1.0f && *number <= 1e7f) || std::floor(*number) != *number))
               throw UsageError(fmt::format(
                   "--heat-map-point: expected mean or the number of a point from 1 on, not '{}'", text));
             point_ = text == "mean" ? 0 : static_cast<std::size_t>(*number);
           },
           [this] { return point_ == 0 ? std::string("mean") : fmt::format("{}", point_); }});
  add_file("day-plans", day_plans_, "SVG drawings of the illuminance in each hour of a day, over the plan");
  set.add({"day", "MM-DD", "--day-plans: the day",
           [this](const std::string& text) {
             const auto dash = text.find('-');
             const auto month = dash == std::string::npos ? std::nullopt : parse_number(text.substr(0, dash));
             const auto day = dash == std::string::npos ? std::nullopt : parse_number(text.substr(dash + 1));
             const auto is_count = [](const std::optional<float>& n, float most) {
               return n && *n >= 1.0f && *n <= most && std::floor(*n) == *n;
             };
             if (!is_count(month, 12.0f) || !is_count(day, 31.0f))
               throw UsageError(fmt::format("--day: expected month and day such as 06-21, not '{}'", text));
             day_ = {static_cast<unsigned>(*month), static_cast<unsigned>(*day)};
           },
           [this] { return fmt::format("{:02}-{:02}", day_.month, day_.day); }});
}

void DaylightDrawings::check(const ProbeSettings& places, const std::vector<std::string>& outputs,
                             bool has_weather) const {
  for (const auto& [option, file] : files())
    if (!has_weather)
      throw UsageError(fmt::format("{} draws the hours of a year: give --weather FILE", option));
  if (point_ > 0 && heat_map_.empty() &&
      std::none_of(outputs.begin(), outputs.end(), [](const auto& o) { return is_page(o); }))
    throw UsageError("--heat-map-point belongs to --heat-map FILE.svg and to -o FILE.html");
  const auto check_grid = [&places](const std::string& option, const std::string& file) {
    if (!places.file.empty() || places.line)
      throw UsageError(
          fmt::format("{} {}: a plan needs a grid of points: give --plane or --grid, not --points or --line",
                      option, file));
    if (places.grid && is_skewed(*places.grid))
      throw UsageError(fmt::format(
          "{} {}: a plan needs a rectangular --grid, whose edges are at right angles", option, file));
  };
  for (const auto& output : outputs)
    if (ending_of(output) == ".svg") check_grid("-o", output);
  if (!day_plans_.empty()) check_grid("--day-plans", day_plans_);
}

void DaylightDrawings::check_point(std::size_t points) const {
  if (point_ > points)
    throw InputError(fmt::format("--heat-map-point {}: expected a number from 1 to {}, the number of points",
                                 point_, points));
}

std::vector<NamedOutput> DaylightDrawings::files() const {
  std::vector<NamedOutput> files;
  if (!heat_map_.empty()) files.push_back({"--heat-map", heat_map_});
  if (!day_plans_.empty()) files.push_back({"--day-plans", day_plans_});
  return files;
}

std::optional<MetricGround> DaylightDrawings::ground_of(const ProbeSettings& places,
                                                        const DaylightAnswer& answer) {
  constexpr double lift = 0.02, beyond_border = 0.3;  // m
  const auto& patches = answer.transport->patches;
  const auto cells = places.cells(patches, answer.question.up);
  if (!cells || is_skewed(*cells)) return std::nullopt;
  MetricGround ground;
  ground.grid = rectangular_grid(cells->corner, cells->first, cells->second, cells->columns, cells->rows);
  ground.plan = plan_of(patches, ground.grid, lift);
  std::vector<Vec3d> corners;
  for (const auto& portal : patches.portals)
    for (const auto& corner : portal.corner) corners.push_back(patches.in_file(corner));
  ground.openings = openings_of(ground.grid, corners);
  const auto way = answer.sky.north();
  const Vec2d north(glm::dot(way, ground.grid.along), glm::dot(way, ground.grid.across));
  constexpr double level = 0.5;  // sine of the angle between north and the plane's normal
  if (glm::length(north) > level) ground.north = glm::normalize(north);
  if (places.plane) ground.around = places.border + beyond_border;
  return ground;
}

std::string DaylightDrawings::heat_map(const DrawnDaylight& drawn) const {
  const auto& points = drawn.report.points.position;
  std::optional<std::size_t> point;
  HeatMap map;
  map.title = "Illuminance, mean over the points";
  if (point_ > 0) {
    point = point_ - 1;
    const auto& at = points[*point];
    map.title = fmt::format("Illuminance at point {} ({:.4g}, {:.4g}, {:.4g} m)", point_, at.x, at.y, at.z);
  }
  map.figures = {valid_utf8(drawn.answer.question.weather->place) + "; by sky and sun, blinds open"};
  map.illuminance = hourly_illuminance(*drawn.answer.year, point);
  map.from = drawn.answer.question.metrics.from;
  map.to = drawn.answer.question.metrics.to;
  return heat_map_svg(map, *drawn.answer.year, *drawn.answer.question.weather);
}

std::string DaylightDrawings::day_plans(const DrawnDaylight& drawn) const {
  const auto plans = plans_of_day(*drawn.answer.year, *drawn.answer.question.weather, day_);
  if (plans.empty())
    throw InputError(fmt::format("--day {:02}-{:02}: the weather file has no hour with light on this day",
                                 day_.month, day_.day));
  return metric_plans_svg(*drawn.ground, plans);
}

void DaylightDrawings::write(const std::string& output, const DrawnDaylight& drawn) const {
  write_file(output, output == heat_map_    ? heat_map(drawn)
                     : output == day_plans_ ? day_plans(drawn)
                                            : metric_plans_svg(*drawn.ground, plans_of(drawn.report)));
}

void DaylightDrawings::add(const DrawnDaylight& drawn, DaylightPage& page) const {
  if (drawn.ground) {
    page.plans = metric_plan_svgs(*drawn.ground, plans_of(drawn.report));
    page.are_plans_wide = is_wide_plan(drawn.ground->grid);
  }
  if (drawn.answer.year) page.heat_map = heat_map(drawn);
}

}  // namespace luxel
