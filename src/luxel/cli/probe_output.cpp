// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/probe_output.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/verdict_json.h"
#include "luxel/core/error.h"
#include "luxel/lighting/calculation_plane.h"
#include "luxel/lighting/colour_rendering.h"
#include "luxel/lighting/judge_figures.h"
#include "luxel/lighting/maintenance.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

Json triple(const Vec3d& v) { return {v.x, v.y, v.z}; }

struct Totals {
  double mean = 0.0, min = 0.0, max = 0.0, mean_error = 0.0, max_sampling = 0.0;  // lx
  std::uint64_t rays = 0;
  std::size_t unreached = 0, behind = 0, dark = 0;
};

Totals totals_of(const ProbeReport& report) {
  Totals t;
  const auto n = static_cast<double>(report.light.size());
  t.min = report.light.front().illuminance;
  for (const auto& l : report.light) {
    t.mean += l.illuminance / n;
    t.mean_error += l.standard_error() / n;
    t.min = std::min(t.min, l.illuminance);
    t.max = std::max(t.max, l.illuminance);
    if (l.illuminance > 0.0) t.max_sampling = std::max(t.max_sampling, l.sampling_error / l.illuminance);
    t.rays += l.rays;
    t.unreached += l.reached ? 0 : 1;
    t.behind += l.place == ProbePlace::behind ? 1 : 0;
    t.dark += l.place == ProbePlace::dark ? 1 : 0;
  }
  for (const auto& s : report.spheres) t.rays += s.rays;
  return t;
}

Json grid_as_json(const GridVerdicts& grid) {
  Json json = {{"mean_lx", figure_json(grid.mean)},
               {"min_lx", figure_json(grid.min)},
               {"max_lx", figure_json(grid.max)},
               {"min_over_mean", figure_json(grid.min_over_mean)},
               {"min_over_max", figure_json(grid.min_over_max)},
               {"maintenance", grid.maintenance},
               {"verdict", name(*compliance_of(grid.verdicts))},
               {"verdicts", Json::array()}};
  for (const auto& v : grid.verdicts) json["verdicts"].push_back(verdict_json(v));
  return json;
}

Json point_as_json(const ProbeReport& report, std::size_t i) {
  const auto& light = report.light[i];
  Json point = {{"position_m", triple(report.points.position[i])},
                {"normal", triple(report.points.normal[i])},
                {"place", name(light.place)},
                {"illuminance_lx", light.illuminance},
                {"standard_error_lx", light.standard_error()},
                {"sampling_error_lx", light.sampling_error},
                {"solution_error_lx", light.solution_error},
                {"irradiance_W_per_m2", light.irradiance},
                {"rays", light.rays},
                {"reached", light.reached}};
  if (report.solution_errors == SolutionErrors::not_stated) point["solution_error_lx"] = nullptr;
  if (report.spheres.empty()) return point;
  const auto& sphere = report.spheres[i];
  Json bands = Json::array();
  for (std::size_t b = 0; b < report.bands.size(); ++b) {
    const auto first = sphere.coefficients.begin() + static_cast<std::ptrdiff_t>(b * report.harmonics);
    bands.push_back(std::vector<double>(first, first + static_cast<std::ptrdiff_t>(report.harmonics)));
  }
  point["sh_W_per_m2_sr"] = std::move(bands);
  point["sh_error"] = sphere.error;
  point["sh_rays"] = sphere.rays;
  point["sh_reached"] = sphere.reached;
  return point;
}

}  // namespace

GridVerdicts judge_grid(const std::vector<ProbedLight>& light, const SolutionProbe& probe,
                        const Requirement& required) {
  std::vector<ProbedLight> free;
  for (const auto& l : light)
    if (l.place != ProbePlace::behind) free.push_back(l);
  if (free.empty())
    throw InputError(
        "all points lie behind one-sided surfaces or inside of something, so that nothing can be judged");
  const auto samples = samples_of(free, probe.solved().error_degrees_of_freedom());
  const GridFigures figures(samples);
  GridVerdicts grid{.mean = figures.mean(),
                    .min = figures.min(),
                    .max = figures.max(),
                    .min_over_mean = figures.min_over_mean(),
                    .min_over_max = figures.min_over_max(),
                    .maintenance = AppliedMaintenance{luminaire_maintenance(probe.patches()), {}}.text(),
                    .verdicts = {},
                    .warnings = {}};
  const auto max_over_min = figures.max_over_min();
  grid.verdicts =
      judge_figures({grid.mean, grid.min, grid.min_over_mean, grid.min_over_max, max_over_min}, required);
  if (required.Ra) grid.verdicts.push_back(judge_colour_rendering(probe.patches(), *required.Ra));
  return grid;
}

std::string csv_of(const ProbeReport& report) {
  std::string text =
      "x,y,z,nx,ny,nz,illuminance_lx,standard_error_lx,sampling_error_lx,solution_error_lx,rays,reached,"
      "place";
  for (const auto& band : report.bands) text += fmt::format(",irradiance {} W/m2", band);
  for (const auto& band : report.bands)
    for (std::size_t k = 0; k < report.harmonics; ++k) text += fmt::format(",sh {} {}", band, k);
  if (report.harmonics > 0) text += ",sh error,sh reached";
  text += "\n";
  for (std::size_t i = 0; i < report.light.size(); ++i) {
    const auto& l = report.light[i];
    const auto& at = report.points.position[i];
    const auto& n = report.points.normal[i];
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.6g},{:.6g},{:.6g},{:.6g},{:.3g},{:.3g},", at.x, at.y, at.z,
                        n.x, n.y, n.z, l.illuminance, l.standard_error(), l.sampling_error);
    if (report.solution_errors != SolutionErrors::not_stated) text += fmt::format("{:.3g}", l.solution_error);
    text += fmt::format(",{},{},{}", l.rays, l.reached ? 1 : 0, name(l.place));
    for (const auto h : l.irradiance) text += fmt::format(",{:.6g}", h);
    if (report.harmonics > 0) {
      for (const auto c : report.spheres[i].coefficients) text += fmt::format(",{:.6g}", c);
      text += fmt::format(",{:.3g},{}", report.spheres[i].error, report.spheres[i].reached ? 1 : 0);
    }
    text += "\n";
  }
  return text;
}

std::string json_of(const ProbeReport& report, const ProbeSettings& settings,
                    const std::vector<std::string>& outputs) {
  const auto totals = totals_of(report);
  Json json = {{"command", "probe"},
               {"solution", report.solution},
               {"bands", report.bands},
               {"error_target", settings.probe.error},
               {"error_floor_lx", settings.probe.floor},
               {"max_rays", settings.probe.max_rays},
               {"seed", settings.probe.seed},
               {"solution_errors", name(report.solution_errors)},
               {"mean_lx", totals.mean},
               {"min_lx", totals.min},
               {"max_lx", totals.max},
               {"rays", totals.rays},
               {"points_short_of_error", totals.unreached},
               {"points_behind", totals.behind},
               {"points_dark", totals.dark}};
  if (totals.mean > 0.0) json["min_over_mean"] = totals.min / totals.mean;
  if (report.points.columns > 0)
    json["grid"] = {{"columns", report.points.columns},
                    {"rows", report.points.position.size() / report.points.columns}};
  if (report.grid) json["figures"] = grid_as_json(*report.grid);
  json["points"] = Json::array();
  for (std::size_t i = 0; i < report.light.size(); ++i) json["points"].push_back(point_as_json(report, i));
  if (!outputs.empty()) json["outputs"] = outputs;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summary_of(const ProbeReport& report) {
  const auto t = totals_of(report);
  auto text = fmt::format("{} point{}: ", report.light.size(), report.light.size() == 1 ? "" : "s");
  if (report.light.size() == 1)
    text += fmt::format("{:.4g} lx, standard error {:.2g} lx", t.mean, t.mean_error);
  else
    text += fmt::format(
        "mean {:.4g} lx, min {:.4g} lx, max {:.4g} lx, min/mean {:.3g}; standard error {:.2g} lx on average",
        t.mean, t.min, t.max, t.mean > 0.0 ? t.min / t.mean : 0.0, t.mean_error);
  text += fmt::format("; {} rays\n", t.rays);
  if (report.grid) {
    const auto& g = *report.grid;
    text += fmt::format("95 % intervals, {}: mean {:.4g} to {:.4g} lx, U0 {:.3g} to {:.3g}\n", g.maintenance,
                        g.mean.low, g.mean.high, g.min_over_mean.low, g.min_over_mean.high);
    for (const auto& verdict : g.verdicts) text += sentence_of(verdict) + "\n";
  }
  switch (report.solution_errors) {
    case SolutionErrors::not_stated:
      return text + "the standard errors are those of the sampling alone: the solution states none";
    case SolutionErrors::patches:
      return text + "the standard errors include the solution's as an upper bound, from its patches";
    case SolutionErrors::replicates:
      return text + "the standard errors include the solution's, from its replicates";
  }
  return text;
}

std::vector<std::string> warnings_of(const ProbeReport& report) {
  const auto t = totals_of(report);
  const auto n = report.light.size();
  std::vector<std::string> warnings;
  if (report.grid) warnings = report.grid->warnings;
  if (t.unreached > 0)
    warnings.push_back(fmt::format(
        "{} of {} points have a larger error than requested (at most {:.2g} % of their light): more --rays "
        "reduce it",
        t.unreached, n, 100.0 * t.max_sampling));
  const auto spheres = std::count_if(report.spheres.begin(), report.spheres.end(),
                                     [](const SphereLight& s) { return !s.reached; });
  if (spheres > 0)
    warnings.push_back(
        fmt::format("the spherical harmonics of {} of {} points have a larger error than requested: more "
                    "--rays reduce it",
                    spheres, n));
  if (t.behind > 0)
    warnings.push_back(
        fmt::format("{} of {} points lie behind one-sided surfaces or inside of them: more than half of "
                    "their rays met backs",
                    t.behind, n));
  if (t.dark > 0)
    warnings.push_back(fmt::format(
        "{} of {} points receive no light: they lie inside something, or face a space without light", t.dark,
        n));
  return warnings;
}

}  // namespace luxel
