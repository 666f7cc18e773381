// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/lighting/areas.h"
#include "luxel/lighting/calculation_grid.h"
#include "luxel/lighting/grid_figures.h"
#include "luxel/lighting/maintenance.h"
#include "luxel/lighting/verdict.h"
#include "luxel/render/probe_cylinder.h"
#include "luxel/render/probe_light.h"

namespace luxel {

// The measurement of one area. All illuminances are maintained ones: the light of the solution, which
// contains the maintenance factors of its luminaires, times the maintenance factor of the area.
struct PlaneResult {
  CalculationArea area;
  CalculationGrid grid;                  // of the points that were measured
  std::vector<ProbedLight> light;        // [point], maintained
  std::vector<CylinderLight> cylinders;  // [point], maintained, at Ez_height; where requested
  Figure mean, min, max;                 // lx
  Figure min_over_mean, min_over_max, max_over_min;
  std::optional<Figure> cylindrical, semicylindrical;  // lx, means over the points
  std::optional<Figure> modelling;  // mean cylindrical over mean horizontal illuminance at the same points
  std::vector<Verdict> verdicts;    // on the area's requirements, except UGR, which observers measure
  LuminaireMaintenance luminaires;  // what the light of the solution contains
  SolutionErrors solution_errors = SolutionErrors::not_stated;
  std::size_t behind = 0;     // points left out: inside or behind something
  std::size_t dark = 0;       // points without light, which count
  std::size_t unreached = 0;  // points whose sampling error is larger than requested
  std::uint64_t rays = 0;

  // The verdict on all requirements together; nothing where there are none.
  std::optional<Compliance> compliance() const { return compliance_of(verdicts); }
  AppliedMaintenance maintenance() const { return {luminaires, area.maintenance}; }
};

// Measures the light on an area with rays of its own, which take no part in the light of the solution. Points
// behind one-sided surfaces are left out. Nothing where the monitor stopped the work. Throws InputError where
// the area has no points. The same bits on any number of threads.
std::optional<PlaneResult> measure_plane(const SolutionProbe& probe, const CalculationArea& area,
                                         const AreaScene& scene, const ProbeOptions& options,
                                         const Context& context);

// The values and errors of points for GridFigures. freedom: of the solution's errors, see SolutionLight.
GridSamples samples_of(const std::vector<ProbedLight>& light, double freedom);

// "U0 >= 0.6: met"; for an open verdict with the effort that would decide it.
std::string sentence_of(const Verdict& verdict);

// The sentences of a report about an area: figures with intervals, verdicts, and for open verdicts the effort
// that would decide them. Without line ends.
std::vector<std::string> sentences_of(const PlaneResult& result);

}  // namespace luxel
