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

// Area of a piece's lamps: as its first triangle faces, and turned, m².
struct LampArea {
  double with = 0.0, against = 0.0;
};

LampArea lamp_area(const Scene& scene, std::span<const Vec3> places, std::span<const CleanTriangle> triangles,
                   const Pieces& pieces, std::size_t piece) {
  LampArea area;
  for (auto i = pieces.begin[piece]; i < pieces.begin[piece + 1]; ++i) {
    const auto t = pieces.order[i];
    if (!is_lamp(scene, triangles[t].triangle)) continue;
    const auto& c = triangles[t].corners;
    (pieces.is_turned[t] != 0 ? area.against : area.with) +=
        triangle_area(places[c[0]], places[c[1]], places[c[2]]);
  }
  return area;
}

}  // namespace

WindingPlan plan_windings(const Scene& scene, std::span<const Vec3> places,
                          std::span<const CleanTriangle> triangles, const Pieces& pieces) {
  WindingPlan plan;
  plan.turn.assign(triangles.size(), 0);
  for (std::size_t p = 0; p < pieces.pieces.size(); ++p) {
    const auto& piece = pieces.pieces[p];
    if (!piece.is_orientable) {
      ++plan.not_orientable;
      continue;
    }
    const auto lamps = lamp_area(scene, places, triangles, pieces, p);
    const bool has_lamps = lamps.with + lamps.against > 0.0;
    // Whether the triangles that face as the first one are those to turn.
    const bool turns_first = has_lamps         ? lamps.against > lamps.with
                             : piece.is_closed ? piece.volume < 0.0
                                               : piece.area_turned > piece.area - piece.area_turned;
    std::size_t turned = 0;
    for (auto i = pieces.begin[p]; i < pieces.begin[p + 1]; ++i) {
      const auto t = pieces.order[i];
      if ((pieces.is_turned[t] == 0) != turns_first) continue;
      if (is_lamp(scene, triangles[t].triangle)) {
        ++plan.stubborn_lamps;
        continue;
      }
      plan.turn[t] = 1;
      ++turned;
    }
    if (turned == 0) continue;
    plan.turned += turned;
    ++plan.pieces;
    if (has_lamps)
      ++plan.lamps;
    else if (piece.is_closed)
      ++plan.closed;
  }
  return plan;
}

OrientReport orient_windings(Scene& scene) {
  VertexWeld weld;
  const auto clean = clean_triangles(scene, weld);
  const auto pieces =
      find_pieces(weld.positions(), clean.kept, find_edges(clean.kept, weld.positions().size()));
  OrientReport report{plan_windings(scene, weld.positions(), clean.kept, pieces), pieces.pieces.size()};
  for (std::size_t t = 0; t < clean.kept.size(); ++t)
    if (report.plan.turn[t] != 0) turn_triangle(scene, clean.kept[t].triangle);
  for (const auto& twin : clean.twins)
    if (report.plan.turn[twin.kept] != 0 && !is_lamp(scene, twin.triangle))
      turn_triangle(scene, twin.triangle);
  return report;
}

std::string OrientReport::as_text() const {
  auto text = plan.turned == 0
                  ? fmt::format("--orient: {} connected pieces looked at; nothing was turned", all_pieces)
                  : fmt::format(
                        "--orient: {} triangles turned round in {} of {} connected pieces ({} closed, now "
                        "facing outwards; {} that follow their lamps; {} by the greater area)",
                        plan.turned, plan.pieces, all_pieces, plan.closed, plan.lamps,
                        plan.pieces - plan.closed - plan.lamps);
  if (plan.not_orientable > 0)
    text += fmt::format("; {} pieces have no consistent side and stay as they are", plan.not_orientable);
  if (plan.stubborn_lamps > 0)
    text += fmt::format("; {} lamp triangles keep their side against the rest of their piece",
                        plan.stubborn_lamps);
  return text;
}

}  // namespace luxel
