// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/calculation_plane.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/student.h"
#include "luxel/lighting/colour_rendering.h"
#include "luxel/lighting/judge_figures.h"
#include "luxel/render/doubled_samples.h"

namespace luxel {
namespace {

std::vector<ProbePoint> points_of(const CalculationGrid& grid, const Vec3d& origin) {
  std::vector<ProbePoint> points;
  for (std::size_t i = 0; i < grid.points(); ++i)
    points.push_back({Vec3(grid.position[i] - origin), Vec3(grid.direction(i))});
  return points;
}

// Leaves out points that lie behind something.
void drop_points_behind(PlaneResult& result) {
  CalculationGrid grid = result.grid;
  grid.cell.clear();
  grid.position.clear();
  std::vector<ProbedLight> light;
  for (std::size_t i = 0; i < result.light.size(); ++i) {
    if (result.light[i].place == ProbePlace::behind) {
      ++result.behind;
      continue;
    }
    grid.cell.push_back(result.grid.cell[i]);
    grid.position.push_back(result.grid.position[i]);
    light.push_back(std::move(result.light[i]));
  }
  result.grid = std::move(grid);
  result.light = std::move(light);
  if (result.light.empty())
    throw InputError(fmt::format(
        "area \"{}\": all of its points lie behind one-sided surfaces or inside of something; expected its "
        "normal to point into the room",
        result.area.name));
}

void maintain(double factor, double& lux, double& sampling, double& solution,
              std::vector<double>& replicates) {
  lux *= factor;
  sampling *= factor;
  solution *= factor;
  for (auto& r : replicates) r *= factor;
}

void maintain(double factor, ProbedLight& light) {
  maintain(factor, light.illuminance, light.sampling_error, light.solution_error, light.solution_replicates);
  for (auto& h : light.irradiance) h *= factor;
}

void maintain(double factor, CylinderLight& light) {
  for (auto* part : {&light.horizontal, &light.cylindrical, &light.semicylindrical})
    maintain(factor, part->illuminance, part->sampling_error, part->solution_error,
             part->solution_replicates);
}

// part: of an element of the list that has the fields of a ProbedLight. freedom: of the solution's errors.
template <typename List, typename Part>
GridSamples samples_of(const List& list, const Part& part, double freedom) {
  GridSamples samples;
  samples.sampling_freedom = gather_replicates - 1;
  samples.solution_freedom = freedom;
  const auto of_sampling = student_widening(samples.sampling_freedom);
  const auto of_solution = freedom > 0.0 ? student_widening(freedom) : 1.0;
  samples.replicates.resize(part(list.front()).solution_replicates.size());
  for (const auto& element : list) {
    const auto& light = part(element);
    samples.value.push_back(light.illuminance);
    samples.sampling_error.push_back(light.sampling_error / of_sampling);
    samples.solution_error.push_back(light.solution_error / of_solution);
    for (std::size_t r = 0; r < samples.replicates.size(); ++r)
      samples.replicates[r].push_back(light.solution_replicates[r]);
  }
  return samples;
}

void find_figures(double freedom, PlaneResult& result) {
  const auto samples = samples_of(result.light, freedom);
  const GridFigures figures(samples);
  result.mean = figures.mean();
  result.min = figures.min();
  result.max = figures.max();
  result.min_over_mean = figures.min_over_mean();
  result.min_over_max = figures.min_over_max();
  result.max_over_min = figures.max_over_min();
  if (result.cylinders.empty()) return;
  const auto mean_of = [&](IntegratedLight CylinderLight::*part) {
    const auto of_part = samples_of(
        result.cylinders, [&](const CylinderLight& light) -> const auto& { return light.*part; }, freedom);
    return GridFigures(of_part).mean();
  };
  result.cylindrical = mean_of(&CylinderLight::cylindrical);
  result.modelling = ratio_of(*result.cylindrical, mean_of(&CylinderLight::horizontal));
  if (result.area.semicylindrical) result.semicylindrical = mean_of(&CylinderLight::semicylindrical);
}

void judge_all(const PatchSet& patches, PlaneResult& result) {
  const auto& r = result.area.requirement;
  result.verdicts = judge_figures(
      {result.mean, result.min, result.min_over_mean, result.min_over_max, result.max_over_min}, r);
  const auto add = [&](const char* name, const Figure& figure, const std::optional<double>& required,
                       bool is_at_least = true) {
    if (required) result.verdicts.push_back(judge(name, figure, *required, is_at_least));
  };
  if (result.cylindrical) {
    add("Ez", *result.cylindrical, r.Ez);
    add("modelling", *result.modelling, r.modelling_min);
    add("modelling", *result.modelling, r.modelling_max, false);
  }
  if (r.Ra) result.verdicts.push_back(judge_colour_rendering(patches, *r.Ra));
}

std::string interval(const Figure& f, const char* unit) {
  return f.low < f.high ? fmt::format("{:.4g} ({:.4g} to {:.4g}){}", f.value, f.low, f.high, unit)
                        : fmt::format("{:.4g}{}", f.value, unit);
}

}  // namespace

GridSamples samples_of(const std::vector<ProbedLight>& light, double freedom) {
  return samples_of(
      light, [](const auto& l) -> const auto& { return l; }, freedom);
}

std::string sentence_of(const Verdict& v) {
  auto text =
      fmt::format("{} {} {:.4g}: {}", v.quantity, v.is_at_least ? "≥" : "≤", v.required, name(v.compliance));
  for (const auto& more : {v.note, remedy_of(v)})
    if (!more.empty()) text += "; " + more;
  return text;
}

std::optional<PlaneResult> measure_plane(const SolutionProbe& probe, const CalculationArea& area,
                                         const AreaScene& scene, const ProbeOptions& options,
                                         const Context& context) {
  PlaneResult result;
  result.area = area;
  result.grid = make_grid(area, scene);
  result.solution_errors = probe.solved().errors();
  result.luminaires = luminaire_maintenance(scene.patches);
  auto here = options;
  here.direct = area.is_direct || options.direct;
  const auto& origin = scene.patches.origin;
  result.light = probe_light(probe, points_of(result.grid, origin), here, context);
  if (result.light.empty()) return std::nullopt;
  drop_points_behind(result);
  if (area.has_cylinders) {
    auto raised = result.grid;
    raised.normal = scene.up;
    raised.facing.reset();
    for (auto& at : raised.position) at += (*area.Ez_height - glm::dot(at, scene.up)) * scene.up;
    CylinderOptions cylinder{.axis = Vec3(scene.up), .facing = {}};
    if (area.semicylindrical) cylinder.facing = Vec3(*area.semicylindrical);
    result.cylinders = probe_cylinders(probe, points_of(raised, origin), cylinder, options, context);
    if (result.cylinders.empty()) return std::nullopt;
  }
  for (auto& light : result.light) {
    result.rays += light.rays;
    result.dark += light.place == ProbePlace::dark ? 1 : 0;
    result.unreached += light.reached ? 0 : 1;
    maintain(area.maintenance.factor, light);
  }
  for (auto& light : result.cylinders) {
    result.rays += light.rays;
    maintain(area.maintenance.factor, light);
  }
  find_figures(probe.solved().error_degrees_of_freedom(), result);
  judge_all(scene.patches, result);
  return result;
}

std::vector<std::string> sentences_of(const PlaneResult& result) {
  const auto& grid = result.grid;
  std::vector<std::string> lines;
  lines.push_back(
      fmt::format("{} ({}{}): {} points, {:.3g} m apart{}{}", result.area.name, name(result.area.kind),
                  result.area.is_direct ? ", direct light only" : "", grid.points(),
                  grid.width / static_cast<double>(grid.columns), grid.is_by_rule ? " by EN 12464-1" : "",
                  ", " + result.maintenance().text() + (result.maintenance().is_initial() ? " light" : "")));
  lines.push_back(fmt::format("mean {}, min {}, max {}", interval(result.mean, " lx"),
                              interval(result.min, " lx"), interval(result.max, " lx")));
  lines.push_back(
      fmt::format("U0 {}, Ud {}", interval(result.min_over_mean, ""), interval(result.min_over_max, "")));
  if (result.cylindrical)
    lines.push_back(
        fmt::format("Ez {} at a height of {:.4g} m, modelling {}{}", interval(*result.cylindrical, " lx"),
                    *result.area.Ez_height, interval(*result.modelling, ""),
                    result.semicylindrical ? ", semi-cylindrical " + interval(*result.semicylindrical, " lx")
                                           : std::string()));
  for (const auto& verdict : result.verdicts) lines.push_back(sentence_of(verdict));
  if (result.behind > 0)
    lines.push_back(
        fmt::format("{} points lie behind or inside of something and are left out", result.behind));
  if (result.dark > 0 && !result.area.is_direct)
    lines.push_back(
        fmt::format("{} points receive no light: leave them out with a polygon if they are in "
                    "furniture",
                    result.dark));
  return lines;
}

}  // namespace luxel
