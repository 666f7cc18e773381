// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/orient_windings.h"

#include <utility>

#include <fmt/format.h>

#include "luxel/core/triangle.h"

namespace luxel {
namespace {

bool is_lamp(const Scene& scene, std::uint32_t triangle) {
  return scene.materials[static_cast<std::size_t>(scene.triangle_material[triangle])].is_lamp();
}

// Area of a component's lamps with the winding of its first triangle, and with the opposite one, m².
struct LampArea {
  double with = 0.0, against = 0.0;
};

LampArea lamp_area(const Scene& scene, std::span<const Vec3> places, std::span<const CleanTriangle> triangles,
                   const Components& components, std::size_t component) {
  LampArea area;
  for (auto i = components.begin[component]; i < components.begin[component + 1]; ++i) {
    const auto t = components.order[i];
    if (!is_lamp(scene, triangles[t].triangle)) continue;
    const auto& c = triangles[t].corners;
    (components.is_turned[t] != 0 ? area.against : area.with) +=
        triangle_area(places[c[0]], places[c[1]], places[c[2]]);
  }
  return area;
}

}  // namespace

WindingPlan plan_windings(const Scene& scene, std::span<const Vec3> places,
                          std::span<const CleanTriangle> triangles, const Components& components) {
  WindingPlan plan;
  plan.turn.assign(triangles.size(), 0);
  for (std::size_t p = 0; p < components.components.size(); ++p) {
    const auto& component = components.components[p];
    if (!component.is_orientable) {
      ++plan.not_orientable;
      continue;
    }
    const auto lamps = lamp_area(scene, places, triangles, components, p);
    const bool has_lamps = lamps.with + lamps.against > 0.0;
    // Whether to flip the triangles that face like the first one.
    const bool turns_first = has_lamps ? lamps.against > lamps.with
                             : component.is_closed
                                 ? component.volume < 0.0
                                 : component.area_turned > component.area - component.area_turned;
    std::size_t turned = 0;
    for (auto i = components.begin[p]; i < components.begin[p + 1]; ++i) {
      const auto t = components.order[i];
      if ((components.is_turned[t] == 0) != turns_first) continue;
      if (is_lamp(scene, triangles[t].triangle)) {
        ++plan.stubborn_lamps;
        continue;
      }
      plan.turn[t] = 1;
      ++turned;
    }
    if (turned == 0) continue;
    plan.turned += turned;
    ++plan.components;
    if (has_lamps)
      ++plan.lamps;
    else if (component.is_closed)
      ++plan.closed;
  }
  return plan;
}

OrientReport orient_windings(Scene& scene) {
  VertexWeld weld;
  const auto clean = clean_triangles(scene, weld);
  const auto components =
      find_components(weld.positions(), clean.kept, find_edges(clean.kept, weld.positions().size()));
  OrientReport report{plan_windings(scene, weld.positions(), clean.kept, components),
                      components.components.size()};
  for (std::size_t t = 0; t < clean.kept.size(); ++t)
    if (report.plan.turn[t] != 0) turn_triangle(scene, clean.kept[t].triangle);
  for (const auto& twin : clean.twins)
    if (report.plan.turn[twin.kept] != 0 && !is_lamp(scene, twin.triangle))
      turn_triangle(scene, twin.triangle);
  return report;
}

std::string OrientReport::as_text() const {
  auto text =
      plan.turned == 0
          ? fmt::format("orientation: {} connected components checked; nothing was flipped", all_components)
          : fmt::format(
                "orientation: {} triangles flipped in {} of {} connected components ({} closed, now "
                "facing outwards; {} that follow their lamps; {} by the greater area)",
                plan.turned, plan.components, all_components, plan.closed, plan.lamps,
                plan.components - plan.closed - plan.lamps);
  if (plan.not_orientable > 0)
    text +=
        fmt::format("; {} components cannot be oriented consistently and are unchanged", plan.not_orientable);
  if (plan.stubborn_lamps > 0)
    text += fmt::format("; {} lamp triangles face otherwise than the rest of their component",
                        plan.stubborn_lamps);
  return text;
}

}  // namespace luxel
