// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/daylight_study.h"

#include <utility>

#include "luxel/import/set_daylight.h"
#include "luxel/lighting/daylight_scene.h"

namespace luxel {
namespace {

using PanesOfGroups = std::vector<std::vector<std::uint32_t>>;  // see panes_of_groups()

// Returns false where the run was interrupted.
bool add_year(const PanesOfGroups& panes, DaylightAnswer& a, const RunPlace& place) {
  const auto& q = a.question;
  const auto context = place.reporter.reporting(place.context);
  a.windows = place.record.stage("windows", [&](auto& stage) {
    if (q.blinds.empty()) return all_windows(q.transmittance);
    auto light = find_window_light({a.transport->run(), a.coefficients, a.coefficients.origins},
                                   *a.transport->tracer, q.blinds, panes, q.coefficients, context);
    for (const auto& without : light.without) stage.rays += without.rays + a.transport->samples->rays;
    return light;
  });
  if (a.windows.groups.empty()) return false;
  place.record.stage("sun", [&](auto&) {
    a.year.emplace(YearCoefficients{a.coefficients, a.windows}, a.skies, a.coefficients.origins,
                   SunSurroundings{a.transport->patches, *a.transport->tracer, q.coefficients.seed}, context);
  });
  if (a.year->is_stopped()) return false;
  a.report = place.record.stage("metrics", [&](auto&) { return metrics_of(*a.year, *q.weather, q.metrics); });
  return !place.reporter.is_interrupted();
}

void find_skies(DaylightAnswer& a, const RunPlace& place) {
  const auto& q = a.question;
  if (!q.weather) return;
  a.skies = place.record.stage(
      "skies", [&](auto&) { return skies_of_year(*q.weather, a.sky, q.albedo, place.context); });
}

// Computes the results of the transport. Returns false where the run was interrupted.
bool add_light(const PanesOfGroups& panes, std::span<const ProbePoint> points, DaylightAnswer& a,
               const RunPlace& place) {
  const auto& q = a.question;
  const auto& t = *a.transport;
  a.coefficients = place.record.stage("coefficients", [&](auto& stage) {
    auto found = find_coefficients(t.run(), *t.tracer, points, q.coefficients,
                                   place.reporter.reporting(place.context));
    stage.rays = found.rays;
    return found;
  });
  if (a.coefficients.points == 0) return false;
  for (const int type : {16, 1}) a.factors.push_back(daylight_factors(a.coefficients, type, q.albedo));
  return !q.weather || add_year(panes, a, place);
}

}  // namespace

std::unique_ptr<DaylightAnswer> study_daylight(Scene scene, const std::string& name,
                                               DaylightQuestion question, const PointsOfPatches& points,
                                               const RunPlace& place) {
  auto answer = std::make_unique<DaylightAnswer>();
  auto& a = *answer;
  a.question = std::move(question);
  const auto& q = a.question;
  a.sky = SkyPatches(q.subdivision, q.up, north_of(q.up, q.north));
  find_skies(a, place);
  set_only_sky(a.sky, q.weather ? mean_sky(a.skies) : overcast_sky(a.sky, q.albedo), scene);
  make_panes_of_groups(q.blinds, scene);
  std::vector<ProbePoint> at;
  a.transport = solve_daylight(
      scene, name, q.solve, [&](const PatchSet& patches) { at = points(patches); }, place);
  if (!a.transport) return nullptr;
  const auto panes =
      q.blinds.empty() ? PanesOfGroups{} : panes_of_groups(scene, a.transport->patches, q.blinds);
  if (!add_light(panes, at, a, place)) return nullptr;
  return answer;
}

std::unique_ptr<DaylightAnswer> study_daylight(DaylightTransport transport, DaylightQuestion question,
                                               const PointsOfPatches& points, const RunPlace& place) {
  auto answer = std::make_unique<DaylightAnswer>();
  auto& a = *answer;
  a.question = std::move(question);
  a.transport.emplace(std::move(transport));
  a.sky = a.transport->patches.sky_patches;
  const auto at = points(a.transport->patches);
  const auto panes = panes_of_groups(a.transport->patches, a.question.blinds);
  find_skies(a, place);
  if (!add_light(panes, at, a, place)) return nullptr;
  return answer;
}

}  // namespace luxel
