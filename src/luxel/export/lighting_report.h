// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "luxel/export/daylight_page.h"
#include "luxel/export/luminaire_list.h"
#include "luxel/export/plan_svg.h"
#include "luxel/export/room_data.h"
#include "luxel/export/unfolded_room.h"
#include "luxel/lighting/calculation_plane.h"
#include "luxel/lighting/glare_verdict.h"
#include "luxel/lighting/maintenance.h"
#include "luxel/lighting/plane_svg.h"
#include "luxel/render/surface_measure.h"

namespace luxel {

// Origin of the numbers of a report.
struct ReportOrigin {
  std::string solution;        // file
  std::string version;         // of the program that writes the report
  std::string report_command;  // that makes the report again
  std::string solution_version, solution_command, method;
  std::uint64_t seed = 0, rays = 0;  // of the solution
  std::uint64_t measuring_seed = 1;  // of the rays that measure
  std::size_t patches = 0;
  double seen_error = 0.0;  // of the solution, a fraction; 0: not estimated
  SolutionErrors errors = SolutionErrors::not_stated;
};

struct ReportSurface {
  std::string name;  // "floor", "walls", "ceiling"
  SurfaceMeasure measure;
};

struct ReportObserver {
  PlanObserver place;
  std::string description;    // "middle of the left wall"
  Vec3d view{1.0, 0.0, 0.0};  // unit, in the scene
  ObservedGlare glare;
  Figure ugr() const { return {glare.ugr, glare.low, glare.high}; }
};

struct ReportPlane {
  PlaneResult result;
  PlaneDrawing drawing;
};

// Numbers and pictures of a report. Luminaires and observers may be absent.
struct LightingReport {
  std::string title, project, author, date;  // UTF-8; empty: left out
  std::string date_label = "Date";           // the event of the date
  ReportOrigin origin;
  RoomData room;
  LuminaireList luminaires;
  std::vector<ReportPlane> planes;  // at least one; the first is the working plane over the floor
  AppliedMaintenance maintenance;   // of the working plane and of the surfaces
  std::vector<ReportSurface> surfaces;
  UnfoldedRoom unfolded;  // may be empty
  std::vector<ReportObserver> observers;
  std::optional<Verdict> ugr_verdict;    // of the highest UGR, where the working plane has a requirement
  double hours = 0.0;                    // h per year at full power, for the estimate of energy; 0: none
  std::string picture;                   // bytes of a PNG file; empty: none
  std::vector<std::string> warnings;     // sentences
  std::optional<DaylightPage> daylight;  // its sections

  // W/m² of the floor, of the installed power; nothing where that is not known.
  std::optional<double> power_density() const;
  // W/m² per 100 lx of the mean of the first plane.
  std::optional<Figure> power_density_per_100_lx() const;
  // kWh/m² per year: installed power times hours over the floor area; nothing where one is not known.
  std::optional<double> energy() const;
  std::vector<NamedGlare> named_glare() const;
  // Index of the observer with the highest UGR; nothing where no observer has one.
  std::optional<std::size_t> max_glare() const;
};

// Level areas over each part of the floor: "working plane", numbered where there are several. height: m above
// the floor; border: strip along the walls without points, m. like: has requirement and maintenance.
std::vector<CalculationArea> working_planes(const RoomData& room, double height, double border,
                                            const CalculationArea& like);

// Four observers at the middles of the outermost walls in the four directions of the plan, who look level at
// right angles to the wall. eye_height: m above the floor. Their eyes are 0.1 m in front of the wall.
std::vector<ReportObserver> wall_observers(const RoomData& room, double eye_height);

// "A", "B", ... "Z", then "27", "28", ...
std::string observer_name(std::size_t index);

}  // namespace luxel
