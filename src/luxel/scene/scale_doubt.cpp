// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/scale_doubt.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

struct Unit {
  const char* name;
  double metres;
};
constexpr Unit units[] = {{"kilometres", 1000.0},
                          {"feet", 0.3048},
                          {"inches", 0.0254},
                          {"centimetres", 0.01},
                          {"millimetres", 0.001}};
constexpr double room = 6.0;         // m, a typical extent
constexpr double small = 0.03;       // m, the longest side
constexpr double long_room = 150.0;  // m
constexpr double high_room = 60.0;   // m, the shortest side
constexpr double closed =
    1.2;  // of each side of the box, seen along its axis: terrain covers it once, a room twice

constexpr double bright = 5000.0;  // lm per m² of floor
constexpr double many_lumens = 1e6;
constexpr double lamp_part =
    0.2;  // of the surface of the box: above it, a lamp is a sky or a luminous ceiling

Vec3d area_vector(const Scene& scene, std::size_t triangle) {
  const auto& t = scene.triangles[triangle];
  const Vec3d a(scene.positions[t[0]]), b(scene.positions[t[1]]), c(scene.positions[t[2]]);
  return 0.5 * glm::cross(b - a, c - a);
}

bool is_closed(const Scene& scene) {
  Vec3d seen(0.0);  // along each axis
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) seen += glm::abs(area_vector(scene, t));
  const Vec3d size(bounds(scene).size());
  return seen.x >= closed * size.y * size.z && seen.y >= closed * size.z * size.x &&
         seen.z >= closed * size.x * size.y;
}

// Descending.
std::array<double, 3> sides_of(const Scene& scene) {
  const auto size = bounds(scene).size();
  std::array<double, 3> sides = {static_cast<double>(size.x), static_cast<double>(size.y),
                                 static_cast<double>(size.z)};
  std::sort(sides.rbegin(), sides.rend());
  return sides;
}

double surface_of_box(const std::array<double, 3>& sides) {
  return 2.0 * (sides[0] * sides[1] + sides[1] * sides[2] + sides[2] * sides[0]);
}

double away_from_a_room(double extent) { return std::max(extent / room, room / extent); }

// lm of light of this power, W per band.
double lumens(const Vec3& watts) {
  return luminous_efficacy * (0.2126 * static_cast<double>(watts.r) + 0.7152 * static_cast<double>(watts.g) +
                              0.0722 * static_cast<double>(watts.b));
}

}  // namespace

std::optional<ScaleDoubt> doubt_scale(const Scene& scene) {
  const auto sides = sides_of(scene);
  const auto extent = sides[0];
  if (!(extent > 0.0)) return std::nullopt;
  const bool is_large = extent >= long_room && sides[2] >= high_room;
  if (!is_large && extent >= small) return std::nullopt;
  if (is_large && !is_closed(scene)) return std::nullopt;
  const auto* likely = &units[0];
  for (const auto& unit : units)
    if (away_from_a_room(extent * unit.metres) < away_from_a_room(extent * likely->metres)) likely = &unit;
  return ScaleDoubt{extent, is_large, likely->name, likely->metres};
}

std::string doubt_lumens(const Scene& scene) {
  const auto sides = sides_of(scene);
  double flux = 0.0, lamps = 0.0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const auto& material = scene.materials[static_cast<std::size_t>(scene.triangle_material[t])];
    if (!material.is_lamp()) continue;
    const auto area = glm::length(area_vector(scene, t));
    lamps += area;
    flux += area * lumens(material.emittance);
  }
  const auto floor = sides[0] * sides[1];
  if (!(flux >= many_lumens && flux > bright * floor) || lamps > lamp_part * surface_of_box(sides)) return {};
  return fmt::format(
      "the lamps emit {:.2g} million lm, {:.2g} times as much per area as in a bright office; emission is "
      "read as "
      "W/(m² sr) in OBJ and cd/m² in glTF: check its unit in the file",
      flux / 1e6, flux / (1000.0 * floor));
}

}  // namespace luxel
