// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "luxel/cli/report_settings.h"
#include "luxel/cli/workplace.h"
#include "luxel/export/lighting_report.h"
#include "luxel/lighting/calculation_plane.h"
#include "luxel/lighting/plane_svg.h"
#include "luxel/scene/scene.h"
#include "luxel/solution/solution_file.h"

namespace luxel {

// Measures the planes, surfaces and faces of a report whose room is known.
class ReportMeasurements {
 public:
  // Keeps references.
  ReportMeasurements(const ReportSettings& settings, const StoredRun& stored, const SolutionProbe& probe,
                     const Workplace& place)
      : settings_(settings), stored_(stored), probe_(probe), place_(place) {}

  // The working planes and the areas of the file. scene: the solved one; null: areas name materials alone.
  // Returns false where the user stopped the work.
  bool add_planes(const Scene* scene, LightingReport& report);
  // s, that the planes took.
  double seconds_of_planes() const { return seconds_of_planes_; }
  // Means of floor, walls and ceiling.
  void add_surfaces(LightingReport& report) const;
  // The unfolded room. Returns false where the user stopped the work.
  bool add_faces(LightingReport& report) const;

 private:
  std::vector<CalculationArea> areas_of(LightingReport& report) const;
  bool add_finer(const PlaneResult& result, const AreaScene& scene, PlaneDrawing& drawing) const;
  std::optional<PlaneResult> measure_finer(CalculationArea area, double spacing, double error,
                                           const AreaScene& scene) const;

  const ReportSettings& settings_;
  const StoredRun& stored_;
  const SolutionProbe& probe_;
  const Workplace& place_;
  double seconds_of_planes_ = 0.0;
};

}  // namespace luxel
