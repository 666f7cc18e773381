// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/area_output.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/verdict_json.h"
#include "luxel/core/csv_field.h"
#include "luxel/core/ending_of.h"
#include "luxel/core/output_file.h"
#include "luxel/lighting/plane_vtp.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

Json triple(const Vec3d& v) { return {v.x, v.y, v.z}; }

Json as_json(const MaintenanceFactor& m) {
  Json json = {{"factor", m.factor}};
  for (const auto& [key, part] : {std::pair{"LLMF", m.llmf}, {"LSF", m.lsf}, {"LMF", m.lmf}, {"RMF", m.rmf}})
    if (part) json[key] = *part;
  return json;
}

Json points_as_json(const PlaneResult& r) {
  auto points = Json::array();
  for (std::size_t i = 0; i < r.light.size(); ++i) {
    const auto& light = r.light[i];
    Json point = {{"position_m", triple(r.grid.position[i])},    {"column", r.grid.cell[i] % r.grid.columns},
                  {"row", r.grid.cell[i] / r.grid.columns},      {"illuminance_lx", light.illuminance},
                  {"standard_error_lx", light.standard_error()}, {"place", name(light.place)}};
    if (!r.cylinders.empty()) {
      point["cylindrical_lx"] = r.cylinders[i].cylindrical.illuminance;
      point["cylindrical_error_lx"] = r.cylinders[i].cylindrical.standard_error();
      if (r.area.semicylindrical) point["semicylindrical_lx"] = r.cylinders[i].semicylindrical.illuminance;
    }
    points.push_back(std::move(point));
  }
  return points;
}

Json as_json(const PlaneResult& r) {
  Json json = {{"name", r.area.name},
               {"kind", name(r.area.kind)},
               {"requirement", r.area.requirement.name},
               {"source", r.area.requirement.source},
               {"direct", r.area.is_direct},
               {"maintenance", as_json(r.area.maintenance)},
               {"luminaire_maintenance", {r.luminaires.low, r.luminaires.high}},
               {"grid",
                {{"columns", r.grid.columns},
                 {"rows", r.grid.rows},
                 {"corner_m", triple(r.grid.corner)},
                 {"along", triple(r.grid.along)},
                 {"across", triple(r.grid.across)},
                 {"normal", triple(r.grid.normal)},
                 {"width_m", r.grid.width},
                 {"height_m", r.grid.height},
                 {"by_en12464", r.grid.is_by_rule}}},
               {"mean_lx", figure_json(r.mean)},
               {"min_lx", figure_json(r.min)},
               {"max_lx", figure_json(r.max)},
               {"min_over_mean", figure_json(r.min_over_mean)},
               {"min_over_max", figure_json(r.min_over_max)},
               {"max_over_min", figure_json(r.max_over_min)}};
  if (r.grid.facing) json["grid"]["facing_m"] = triple(*r.grid.facing);
  if (r.cylindrical) {
    json["cylindrical_lx"] = figure_json(*r.cylindrical);
    json["modelling"] = figure_json(*r.modelling);
    json["cylinder_height_m"] = *r.area.Ez_height;
  }
  if (r.semicylindrical) json["semicylindrical_lx"] = figure_json(*r.semicylindrical);
  if (r.area.requirement.ugr) json["required_UGR"] = *r.area.requirement.ugr;
  if (r.area.requirement.Ra) json["required_Ra"] = *r.area.requirement.Ra;
  if (const auto compliance = r.compliance()) json["verdict"] = name(*compliance);
  json["verdicts"] = Json::array();
  for (const auto& verdict : r.verdicts) json["verdicts"].push_back(verdict_json(verdict));
  json["solution_errors"] = name(r.solution_errors);
  json["points_behind"] = r.behind;
  json["points_dark"] = r.dark;
  json["points_short_of_error"] = r.unreached;
  json["rays"] = r.rays;
  json["points"] = points_as_json(r);
  return json;
}

// The name as part of a file name.
std::string file_word(const std::string& name) {
  std::string word;
  for (const char c : name)
    word += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' ? c : '-';
  return word;
}

std::string drawing_of(const AreaReport& report, std::size_t i, const std::string& drawing) {
  auto settings = report.drawings[i];
  settings.has_values = drawing != "lines";
  return drawing == "values" ? value_grid_svg(report.results[i], settings)
                             : isolux_svg(report.results[i], settings);
}

}  // namespace

std::string csv_of(const AreaReport& report) {
  std::string text =
      "area,x,y,z,nx,ny,nz,illuminance_lx,standard_error_lx,sampling_error_lx,solution_error_lx,"
      "cylindrical_lx,cylindrical_error_lx,semicylindrical_lx,rays,place\n";
  for (const auto& r : report.results)
    for (std::size_t i = 0; i < r.light.size(); ++i) {
      const auto& l = r.light[i];
      const auto& at = r.grid.position[i];
      const auto n = r.grid.direction(i);
      text += fmt::format("{},{:.9g},{:.9g},{:.9g},{:.6g},{:.6g},{:.6g},{:.6g},{:.3g},{:.3g},",
                          csv_field(r.area.name), at.x, at.y, at.z, n.x, n.y, n.z, l.illuminance,
                          l.standard_error(), l.sampling_error);
      if (r.solution_errors != SolutionErrors::not_stated) text += fmt::format("{:.3g}", l.solution_error);
      if (r.cylinders.empty()) {
        text += ",,,";
      } else {
        const auto& c = r.cylinders[i];
        text += fmt::format(",{:.6g},{:.3g},", c.cylindrical.illuminance, c.cylindrical.standard_error());
        if (r.area.semicylindrical) text += fmt::format("{:.6g}", c.semicylindrical.illuminance);
      }
      text += fmt::format(",{},{}\n", l.rays, name(l.place));
    }
  return text;
}

std::string json_of(const AreaReport& report, const std::vector<std::string>& outputs) {
  Json json = {{"command", "probe"},
               {"solution", report.solution.file},
               {"error_target", report.probe.error},
               {"error_floor_lx", report.probe.floor},
               {"max_rays", report.probe.max_rays},
               {"seed", report.probe.seed},
               {"areas", Json::array()}};
  for (const auto& result : report.results) json["areas"].push_back(as_json(result));
  if (!outputs.empty()) json["outputs"] = outputs;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summary_of(const AreaReport& report) {
  std::string text;
  for (const auto& result : report.results) {
    for (const auto& line : sentences_of(result)) text += (text.empty() ? "" : "\n") + line;
    if (result.area.requirement.ugr)
      text += fmt::format("\nUGR ≤ {:g}: 'luxel ugr --areas' and 'luxel report --areas' judge it",
                          *result.area.requirement.ugr);
  }
  return text + "\nintervals are those of 95 %; they do not contain the size of the solution's patches";
}

std::vector<std::string> warnings_of(const AreaReport& report) {
  std::vector<std::string> warnings;
  VerdictEffort effort(report.probe);
  std::size_t unreached = 0;
  for (const auto& result : report.results) {
    unreached += result.unreached;
    effort.add(result.verdicts, result.light);
    if (auto twice = maintenance_warning(result.maintenance(), result.area.name); !twice.empty())
      warnings.push_back(std::move(twice));
  }
  if (unreached > 0)
    warnings.push_back(
        fmt::format("{} points have a larger error than requested: more --rays reduce it", unreached));
  for (auto& sentence : effort.sentences(report.solution, report.seconds))
    warnings.push_back(std::move(sentence));
  return warnings;
}

std::vector<std::string> write_areas(const AreaReport& report, const std::string& output,
                                     const std::string& drawing) {
  const auto ending = ending_of(output);
  if (ending != ".svg") {
    write_file(output, ending == ".csv"   ? csv_of(report)
                       : ending == ".vtp" ? vtp_of(report.results)
                                          : json_of(report, {}));
    return {output};
  }
  std::vector<std::string> files;
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    std::filesystem::path path(output);
    if (report.results.size() > 1)
      path.replace_filename(path.stem().string() + "-" + file_word(report.results[i].area.name) +
                            path.extension().string());
    write_file(path, drawing_of(report, i, drawing));
    files.push_back(path.string());
  }
  return files;
}

}  // namespace luxel
