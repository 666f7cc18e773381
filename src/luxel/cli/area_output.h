// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "luxel/cli/area_settings.h"
#include "luxel/cli/verdict_effort.h"
#include "luxel/lighting/calculation_plane.h"
#include "luxel/lighting/plane_svg.h"

namespace luxel {

// The result of `probe --areas`.
struct AreaReport {
  MeasuredSolution solution;
  ProbeOptions probe;
  double seconds = 0.0;  // that the measurement took
  std::vector<PlaneResult> results;
  std::vector<PlaneDrawing> drawings;  // [result]
};

std::string csv_of(const AreaReport& report);
std::string json_of(const AreaReport& report, const std::vector<std::string>& outputs);
// Text: the sentences of all areas, and the effort that would decide open verdicts.
std::string summary_of(const AreaReport& report);
std::vector<std::string> warnings_of(const AreaReport& report);

// Writes one output by its extension and returns the names of the files: of several areas, an .svg is one
// file per area, with the area's name before the extension. Throws DeviceError.
std::vector<std::string> write_areas(const AreaReport& report, const std::string& output,
                                     const std::string& drawing);

}  // namespace luxel
