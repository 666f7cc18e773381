// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "luxel/classical/solve_report.h"
#include "luxel/runs/light_pages.h"
#include "luxel/runs/option_set.h"
#include "luxel/runs/run_record.h"
#include "luxel/runs/settings.h"
#include "luxel/scene/camera.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/refine_to_light.h"

namespace luxel {

// A picture that was traced path by path.
struct PictureRecord {
  std::uint64_t paths = 0;  // per pixel
  std::uint64_t rays = 0;
  double error = 0.0;  // of the reflected light, see PathPicture
  StopReason stop = StopReason::nothing_to_do;
};

// A run as JSON: the output of --json and --json-file. docs/json.md lists its keys. Parts that a command does
// not have are left out.
struct RunReport {
  std::string command;
  const Baked* baked = nullptr;
  const SolveReport* solve = nullptr;
  const RefineReport* refine = nullptr;
  bool ended_by_ray_budget = false;                 // the solve, before it met its error
  double mesh_error_target = 0.0;                   // of the refinement, a fraction
  std::optional<double> error_target = {};          // of the solve, a fraction; 0: no target was set
  ErrorMeasure error_measure = ErrorMeasure::seen;  // of that target
  std::optional<PictureRecord> picture = {};
  double picture_error = 0.0;  // seen in the picture; 0: not known, or no picture of the patches
  std::optional<PagesRecord> pages = {};
  std::optional<Camera> camera = {};
  Vec3d origin = Vec3d(0.0);  // that the camera counts from
  std::vector<std::string> outputs = {};
  const OptionSet* options = nullptr;
  const RunRecord* record = nullptr;

  std::string as_json() const;
};

// The solution and its patches as lines for a person.
std::string describe(const Baked& baked);
// Reports the work done, the balance of power, the reason for the end and the accuracy of the light, as lines
// of text.
std::string describe(const SolveReport& report);

}  // namespace luxel
