// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/lighting_report.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "luxel/export/floor_outline.h"

namespace luxel {
namespace {

// The middle of the outermost edge of the outline that faces outwards in this direction.
PlanPoint middle_of_wall(const RoomData& room, const PlanPoint& outwards) {
  constexpr double level = 0.9;  // cosine of the angle between an edge's outward normal and the direction
  const auto [low, high] = box_of(room.outline);
  PlanPoint best = 0.5 * (low + high) + 0.5 * outwards * glm::abs(high - low);
  double farthest = -std::numeric_limits<double>::infinity();
  for (const auto& loop : room.outline)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto a = loop[i], b = loop[(i + 1) % loop.size()];
      const auto along = glm::normalize(b - a);
      if (glm::dot(PlanPoint(along.y, -along.x), outwards) < level) continue;
      const auto middle = 0.5 * (a + b);
      if (!(glm::dot(middle, outwards) > farthest)) continue;
      farthest = glm::dot(middle, outwards);
      best = middle;
    }
  return best;
}

}  // namespace

std::optional<double> LightingReport::power_density() const {
  if (!luminaires.watts || !(room.floor_area > 0.0)) return std::nullopt;
  return *luminaires.watts / room.floor_area;
}

std::optional<Figure> LightingReport::power_density_per_100_lx() const {
  const auto density = power_density();
  if (!density || planes.empty() || !(planes[0].result.mean.low > 0.0)) return std::nullopt;
  const auto& mean = planes[0].result.mean;
  const auto per_100 = [&](double lux) { return 100.0 * *density / lux; };
  return Figure{per_100(mean.value), per_100(mean.high), per_100(mean.low)};
}

std::optional<double> LightingReport::energy() const {
  const auto density = power_density();
  if (!density || !(hours > 0.0)) return std::nullopt;
  return *density * hours / 1000.0;
}

std::vector<NamedGlare> LightingReport::named_glare() const {
  std::vector<NamedGlare> all;
  for (const auto& o : observers) all.push_back({o.place.name, room.axes.in_scene(o.place.eye), o.glare});
  return all;
}

std::optional<std::size_t> LightingReport::max_glare() const {
  std::optional<std::size_t> most;
  for (std::size_t i = 0; i < observers.size(); ++i)
    if (std::isfinite(observers[i].glare.ugr) &&
        (!most || observers[i].glare.ugr > observers[*most].glare.ugr))
      most = i;
  return most;
}

std::vector<CalculationArea> working_planes(const RoomData& room, double height, double border,
                                            const CalculationArea& like) {
  std::vector<CalculationArea> areas;
  for (const auto& loop : room.outline) {
    auto area = like;
    area.name = "working plane";
    if (room.outline.size() > 1) area.name += fmt::format(" {}", areas.size() + 1);
    for (const auto& corner : loop)
      area.polygon.push_back(room.axes.in_scene({corner.x, corner.y, room.low.z + height}));
    area.border = border;
    areas.push_back(std::move(area));
  }
  return areas;
}

std::vector<ReportObserver> wall_observers(const RoomData& room, double eye_height) {
  constexpr double from_wall = 0.1;  // m
  const auto height = room.low.z + eye_height;
  const auto observer = [&](const char* name, const char* description, const PlanPoint& view) {
    const auto at = middle_of_wall(room, -view) + from_wall * view;
    return ReportObserver{
        {name, {at.x, at.y, height}, view}, description, room.axes.in_scene({view.x, view.y, 0.0}), {}};
  };
  return {observer("A", "middle of the lower wall of the plan", {0.0, 1.0}),
          observer("B", "middle of the right wall", {-1.0, 0.0}),
          observer("C", "middle of the upper wall", {0.0, -1.0}),
          observer("D", "middle of the left wall", {1.0, 0.0})};
}

std::string observer_name(std::size_t index) {
  return index < 26 ? std::string(1, static_cast<char>('A' + index)) : fmt::format("{}", index + 1);
}

}  // namespace luxel
