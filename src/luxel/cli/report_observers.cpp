// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/report_observers.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/cli/probe_points.h"
#include "luxel/core/error.h"
#include "luxel/lighting/glare.h"
#include "luxel/lighting/glare_verdict.h"

namespace luxel {
namespace {

void add_observers_of_file(const std::string& file, LightingReport& report) {
  const auto list = read_points(file, Vec3d(0.0));
  for (std::size_t i = 0; i < list.position.size(); ++i) {
    if (!(glm::length(list.normal[i]) > 0.0))
      throw InputError(file,
                       "expected where observers look: x,y,z,nx,ny,nz on each line, or columns nx, ny, nz");
    ReportObserver observer;
    observer.view = list.normal[i];
    observer.place.name = observer_name(report.observers.size());
    observer.place.eye = report.room.axes.in_plan(list.position[i]);
    const auto view = report.room.axes.in_plan(observer.view);
    const PlanPoint level(view.x, view.y);
    if (glm::length(level) > 0.0) observer.place.view = glm::normalize(level);
    const auto at = observer.place.eye - report.room.low;
    observer.description = fmt::format("{:.2f}, {:.2f} m, eyes at {:.2f} m", at.x, at.y, at.z);
    report.observers.push_back(std::move(observer));
  }
}

void judge_observers(LightingReport& report) {
  const auto named = report.named_glare();
  const auto is_working_plane = [&](std::size_t i) { return i < report.room.outline.size(); };
  for (std::size_t i = 0; i < report.planes.size(); ++i) {
    auto& result = report.planes[i].result;
    const auto verdict = judge_glare(result.area, named, report.room.axes.up);
    if (!verdict) continue;
    if (is_working_plane(i))
      report.ugr_verdict = judge_glare(named, *result.area.requirement.ugr);
    else
      result.verdicts.push_back(*verdict);
  }
}

}  // namespace

bool add_observers(const ReportSettings& settings, const SolutionProbe& probe, const Workplace& place,
                   LightingReport& report) {
  const GlareMeter meter(probe, report.room.axes.up);
  if (meter.lamps() == 0) return true;
  report.observers = wall_observers(report.room, settings.eye_height);
  if (!settings.observers.empty()) add_observers_of_file(settings.observers, report);
  std::vector<GlareObserver> observers;
  for (const auto& o : report.observers)
    observers.push_back(
        {Vec3(report.room.axes.in_scene(o.place.eye) - probe.patches().origin), Vec3(o.view)});
  const auto glare = place.record.stage("observers", [&](auto&) {
    return observe_glare(meter, observers, settings.glare, place.console.reporting(place.context));
  });
  if (glare.empty()) return false;
  for (std::size_t i = 0; i < glare.size(); ++i) report.observers[i].glare = glare[i];
  judge_observers(report);
  return true;
}

}  // namespace luxel
