// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/lighting_report_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "luxel/cli/verdict_json.h"
#include "luxel/core/none.h"
#include "luxel/export/number_text.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

Json number(double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); }
Json number(const std::optional<double>& v) { return v ? number(*v) : Json(nullptr); }
Json triple(const Vec3d& v) { return {v.x, v.y, v.z}; }
Json as_json(const Figure& n) { return figure_json(n); }

// As verdict_json(), with the required number under the name of its relation.
Json as_json(const Verdict& v) {
  auto json = verdict_json(v);
  json[v.is_at_least ? "at_least" : "at_most"] = v.required;
  return json;
}

Json room_json(const RoomData& room) {
  Json json = {{"size_m", triple(room.high - room.low)},
               {"floor_area_m2", room.floor_area},
               {"outline_m", Json::array()},
               {"materials", Json::array()}};
  for (const auto& loop : room.outline) {
    auto points = Json::array();
    for (const auto& p : loop) points.push_back({p.x - room.low.x, p.y - room.low.y});
    json["outline_m"].push_back(std::move(points));
  }
  for (const auto& m : room.materials)
    json["materials"].push_back(
        {{"name", m.name}, {"area_m2", m.area}, {"reflectance", m.reflectance}, {"emits", m.emits}});
  return json;
}

Json table_json(const UgrValues& values) {
  auto rows = Json::array();
  for (const auto& row : values) {
    auto cells = Json::array();
    for (const auto v : row) cells.push_back(number(v));
    rows.push_back(std::move(cells));
  }
  return rows;
}

Json type_json(const LuminaireType& type) {
  const auto& p = *type.photometry;
  Json json = {{"file", p.file},
               {"format", p.format},
               {"luminaire", p.luminaire},
               {"catalogue", p.catalogue},
               {"maker", p.maker},
               {"count", type.count},
               {"flux_lm", type.flux()},
               {"flux_simulated_lm", p.intensity.linear_flux()},
               {"watts", number(type.watts())},
               {"opening_m", triple(p.opening.size)},
               {"dimming", type.dimming},
               {"maintenance_factor", type.maintenance},
               {"ugr_table", nullptr}};
  if (type.ugr)
    json["ugr_table"] = {{"crosswise", table_json(type.ugr->crosswise)},
                         {"endwise", table_json(type.ugr->endwise)}};
  return json;
}

Json luminaires_json(const LightingReport& report) {
  const auto& list = report.luminaires;
  Json json = {{"count", list.placed.size()},
               {"flux_lm", list.flux},
               {"watts", number(list.watts)},
               {"watts_per_m2", number(report.power_density())},
               {"watts_per_m2_per_100_lx", nullptr},
               {"kwh_per_m2_per_year", number(report.energy())},
               {"hours_per_year", report.hours},
               {"lamp_surfaces", list.lamp_surfaces},
               {"other_lights", list.other_lights},
               {"types", Json::array()},
               {"placed", Json::array()}};
  if (const auto density = report.power_density_per_100_lx())
    json["watts_per_m2_per_100_lx"] = as_json(*density);
  for (const auto& type : list.types) json["types"].push_back(type_json(type));
  for (const auto& p : list.placed)
    json["placed"].push_back(
        {{"type", p.type + 1}, {"position_m", triple(p.position - report.room.low)}, {"turn_deg", p.turn}});
  return json;
}

// [row][column]; null where there is no point.
Json values_json(const PlaneResult& plane) {
  const auto point = plane.grid.point_of_cells();
  auto rows = Json::array();
  for (std::size_t row = 0; row < plane.grid.rows; ++row) {
    auto values = Json::array();
    for (std::size_t column = 0; column < plane.grid.columns; ++column) {
      const auto i = point[row * plane.grid.columns + column];
      values.push_back(i == none ? Json(nullptr) : Json(plane.light[i].illuminance));
    }
    rows.push_back(std::move(values));
  }
  return rows;
}

Json plane_json(const PlaneResult& plane) {
  Json json = {{"name", plane.area.name},
               {"kind", name(plane.area.kind)},
               {"border_m", plane.area.border},
               {"columns", plane.grid.columns},
               {"rows", plane.grid.rows},
               {"points", plane.grid.points()},
               {"points_behind", plane.behind},
               {"points_short_of_error", plane.unreached},
               {"maintenance_factor", plane.area.maintenance.factor},
               {"maintenance", plane.maintenance().text()},
               {"direct", plane.area.is_direct},
               {"requirement", plane.area.requirement.name},
               {"source", plane.area.requirement.source},
               {"mean_lx", as_json(plane.mean)},
               {"min_lx", as_json(plane.min)},
               {"max_lx", as_json(plane.max)},
               {"min_over_mean", as_json(plane.min_over_mean)},
               {"min_over_max", as_json(plane.min_over_max)},
               {"verdicts", Json::array()},
               {"values_lx", values_json(plane)}};
  for (const auto& verdict : plane.verdicts) json["verdicts"].push_back(as_json(verdict));
  return json;
}

Json glare_json(const LightingReport& report) {
  Json json = {{"observers", Json::array()},
               {"verdict", report.ugr_verdict ? as_json(*report.ugr_verdict) : Json(nullptr)}};
  for (const auto& o : report.observers)
    json["observers"].push_back({{"name", o.place.name},
                                 {"place", o.description},
                                 {"eye_m", triple(o.place.eye - report.room.low)},
                                 {"ugr", as_json(o.ugr())},
                                 {"background_cd_per_m2", o.glare.background},
                                 {"sources", o.glare.sources.size()},
                                 {"ignored", o.glare.ignored}});
  return json;
}

Json origin_json(const ReportOrigin& origin) {
  return {{"solution_version", origin.solution_version},
          {"version", origin.version},
          {"method", origin.method},
          {"patches", origin.patches},
          {"rays", origin.rays},
          {"seed", origin.seed},
          {"measuring_seed", origin.measuring_seed},
          {"seen_error", origin.seen_error},
          {"solution_errors", name(origin.errors)},
          {"solution_command", origin.solution_command},
          {"report_command", origin.report_command}};
}

}  // namespace

std::string json_of(const LightingReport& report, const DaylightReport* daylight,
                    const std::vector<std::string>& outputs) {
  Json json = {{"command", "report"},
               {"solution", report.origin.solution},
               {"title", report.title},
               {"project", report.project},
               {"author", report.author},
               {"date", report.date},
               {"date_of", report.date_label},
               {"maintenance", report.maintenance.text()},
               {"room", room_json(report.room)},
               {"luminaires", luminaires_json(report)},
               {"planes", Json::array()},
               {"surfaces", Json::array()},
               {"glare", glare_json(report)},
               {"warnings", report.warnings},
               {"origin", origin_json(report.origin)}};
  for (const auto& plane : report.planes) json["planes"].push_back(plane_json(plane.result));
  const auto maintained = [&](const MeasuredNumber& n) {
    const auto factor = report.maintenance.area.factor;
    return Figure{factor * n.value, factor * n.low, factor * n.high};
  };
  for (const auto& [name, m] : report.surfaces)
    json["surfaces"].push_back({{"name", name},
                                {"area_m2", m.area},
                                {"mean_lx", as_json(maintained(m.mean))},
                                {"min_lx", as_json(maintained(m.min))},
                                {"max_lx", as_json(maintained(m.max))},
                                {"min_over_mean", as_json(figure_of(m.min_over_mean))}});
  for (const auto& [face, result] : report.unfolded)
    json["faces"].push_back(
        {{"name", face.area.name}, {"points", result.grid.points()}, {"mean_lx", as_json(result.mean)}});
  if (daylight) json["daylight"] = json_of(*daylight);
  if (!outputs.empty()) json["outputs"] = outputs;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace luxel
