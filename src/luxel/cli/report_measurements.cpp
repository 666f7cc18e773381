// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/report_measurements.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "luxel/export/unfolded_room.h"
#include "luxel/lighting/areas.h"
#include "luxel/render/solution_light.h"
#include "luxel/render/surface_measure.h"

namespace luxel {

bool ReportMeasurements::add_planes(const Scene* scene_of_file, LightingReport& report) {
  constexpr double drawing_height = 195.0;  // pixels of 720 in width: two drawings fit on a page
  constexpr double lift = 0.02;  // m: height above the plane at which the plan of the drawings is cut
  const AreaScene scene{probe_.patches(), stored_.baked.solution, probe_.tracer(), report.room.axes.up,
                        scene_of_file};
  for (const auto& area : areas_of(report)) {
    auto result = place_.record.stage(area.name, [&](auto&) {
      return measure_plane(probe_, area, scene, settings_.probe, place_.console.reporting(place_.context));
    });
    if (!result) return false;
    seconds_of_planes_ += place_.record.stages().back().seconds;
    PlaneDrawing drawing{
        .plan = plan_of(probe_.patches(), result->grid, lift), .max_height = drawing_height, .title = {}};
    if (!add_finer(*result, scene, drawing)) return false;
    report.planes.push_back({std::move(*result), std::move(drawing)});
  }
  return true;
}

std::vector<CalculationArea> ReportMeasurements::areas_of(LightingReport& report) const {
  CalculationArea like;
  like.requirement = settings_.required.requirement();
  if (like.requirement.Ez || like.requirement.modelling_min) {
    like.has_cylinders = true;
    like.Ez_height = report.room.low.z + settings_.eye_height;
  }
  std::vector<CalculationArea> of_file;
  if (!settings_.areas.empty()) {
    const auto toml = read_area_file(settings_.areas);
    auto table = settings_.required.table();
    table.add(toml);
    of_file = luxel::areas_of(toml, table, report.room.axes.up);
    like.maintenance = maintenance_of(toml).value_or(MaintenanceFactor{});
  }
  if (settings_.maintenance > 0.0) {
    like.maintenance = MaintenanceFactor{};
    like.maintenance.factor = settings_.maintenance;
  }
  report.maintenance.area = like.maintenance;
  auto areas = working_planes(report.room, settings_.plane_height, settings_.border, like);
  for (auto& area : of_file) areas.push_back(std::move(area));
  return areas;
}

// Points three times as close for isolux lines, of planes that these do not make slow. Returns false where
// the user stopped the work.
bool ReportMeasurements::add_finer(const PlaneResult& result, const AreaScene& scene,
                                   PlaneDrawing& drawing) const {
  constexpr std::size_t max_points = 4000;
  const auto& grid = result.grid;
  if (!(grid.height > 0.0) || 9 * grid.points() > max_points) return true;
  // Isolux lines of nearly even light show errors that are invisible in uneven light.
  const auto contrast = (result.max.value - result.min.value) / std::max(result.mean.value, 1e-9);
  auto finer = measure_finer(
      result.area,
      std::max(grid.width / static_cast<double>(grid.columns), grid.height / static_cast<double>(grid.rows)),
      std::clamp(0.01 * contrast, 0.001, 0.02), scene);
  if (!finer) return false;
  drawing.finer_grid = finer->grid;
  for (const auto& light : finer->light) drawing.finer_values.push_back(light.illuminance);
  return true;
}

// The light of an area at points a third of the spacing apart, without verdicts. error: of the sampling.
std::optional<PlaneResult> ReportMeasurements::measure_finer(CalculationArea area, double spacing,
                                                             double error, const AreaScene& scene) const {
  area.spacing = spacing / 3.0;
  area.requirement = {};
  area.has_cylinders = false;
  auto options = settings_.probe;
  options.error = error;
  return place_.record.stage("drawing of " + area.name, [&](auto&) {
    return measure_plane(probe_, area, scene, options, place_.console.reporting(place_.context));
  });
}

bool ReportMeasurements::add_faces(LightingReport& report) const {
  const AreaScene scene{probe_.patches(), stored_.baked.solution, probe_.tracer(), report.room.axes.up,
                        nullptr};
  for (auto& face : faces_of(report.room, probe_.patches())) {
    face.area.maintenance = report.maintenance.area;
    const auto size = report.room.high - report.room.low;
    auto result = measure_finer(face.area, std::max({size.x, size.y, size.z}) / 12.0, 0.01, scene);
    if (!result) return false;
    report.unfolded.push_back({std::move(face), std::move(*result)});
  }
  return true;
}

void ReportMeasurements::add_surfaces(LightingReport& report) const {
  const auto& patches = stored_.baked.patches;
  std::vector<std::vector<float>> replicates;
  if (stored_.samples) replicates = replicate_illuminance(patches, *stored_.samples, place_.context);
  const SurfaceMeter meter(patches, stored_.baked.solution, std::move(replicates));
  const auto add = [&](const char* name, const std::vector<std::uint32_t>& among) {
    if (!among.empty()) report.surfaces.push_back({name, meter.measure(among, SurfaceSide::automatic)});
  };
  add("floor", report.room.floor);
  add("walls", report.room.walls);
  add("ceiling", report.room.ceiling);
}

}  // namespace luxel
