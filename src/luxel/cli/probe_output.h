// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "luxel/cli/probe_points.h"
#include "luxel/cli/probe_settings.h"
#include "luxel/cli/verdict_effort.h"
#include "luxel/lighting/grid_figures.h"
#include "luxel/render/probe_light.h"
#include "luxel/render/probe_sphere.h"

namespace luxel {

// Figures of the points of a grid, and verdicts on its requirements.
struct GridVerdicts {
  Figure mean, min, max;  // lx
  Figure min_over_mean, min_over_max;
  std::string maintenance;  // "initial", "maintenance factor of the luminaires 0.80"
  std::vector<Verdict> verdicts;
  std::vector<std::string> warnings;  // the effort that would decide open verdicts
};

// Points behind surfaces are left out. required: of the grid. Throws InputError where no point is left.
GridVerdicts judge_grid(const std::vector<ProbedLight>& light, const SolutionProbe& probe,
                        const Requirement& required);

// The result of `probe`.
struct ProbeReport {
  std::string solution;  // file
  std::vector<std::string> bands;
  PointList points = {};
  std::vector<ProbedLight> light = {};    // [point]
  std::vector<SphereLight> spheres = {};  // [point], where requested
  std::size_t harmonics = 0;              // 4 or 9, where requested
  SolutionErrors solution_errors = SolutionErrors::not_stated;
  std::optional<GridVerdicts> grid = {};  // where there are requirements
};

// A line of names, then one per point.
std::string csv_of(const ProbeReport& report);
std::string json_of(const ProbeReport& report, const ProbeSettings& settings,
                    const std::vector<std::string>& outputs);
// A few lines for a person: mean, minimum, maximum and uniformity, errors, and which points are special.
std::string summary_of(const ProbeReport& report);
// Warnings: points that miss the requested error, and points without light or behind surfaces.
std::vector<std::string> warnings_of(const ProbeReport& report);

}  // namespace luxel
