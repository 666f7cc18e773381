// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/report_daylight.h"

#include <utility>

#include "luxel/cli/daylight_drawings.h"
#include "luxel/core/error.h"

namespace luxel {

void ReportDaylight::declare(OptionSet& options) {
  options.heading("Daylight");
  input_.declare_sky(options);
  input_.year.declare(options);
}

void ReportDaylight::check(bool has_scene) const {
  input_.year.check(!input_.weather.empty());
  if (is_wanted() && !has_scene)
    throw UsageError(
        "the sections on daylight need the scene that was solved: give --scene FILE with --weather or "
        "--median-diffuse");
}

bool ReportDaylight::add(const Scene& scene, const std::string& file, const Workplace& place,
                         LightingReport& report) {
  auto question = input_.question(report.room.axes.up, place.console.log());
  ProbeSettings places;
  places.plane = report.room.low.z + en_17037_height;
  places.border = en_17037_border;
  const auto up = question.up;
  PointList points;
  const auto answer = study_daylight(
      scene, file, std::move(question),
      [&](const PatchSet& patches) {
        points = places.points(patches, up);
        return probe_points(patches, points);
      },
      place);
  if (!answer) return false;
  result_ = input_.report_of(*answer, file, std::move(points));
  auto page = input_.page_of(*result_, *answer, report.room);
  page.points_description = points_text(result_->points, places);
  DrawnDaylight drawn{*result_, *answer, DaylightDrawings::ground_of(places, *answer)};
  DaylightDrawings().add(drawn, page);
  report.daylight = std::move(page);
  return true;
}

}  // namespace luxel
