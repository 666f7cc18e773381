// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/solid_marks.h"

#include <algorithm>
#include <map>

#include "luxel/photometry/luminaire_mesh.h"
#include "luxel/scene/band_colours.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

using Solid = PhotometricSolid;

constexpr double largest_radius = 0.5;    // m
constexpr double part_of_scene = 0.1;     // of the scene's size
constexpr std::size_t max_solids = 500;   // 1,100 segments each
constexpr std::size_t meridian_step = 2;  // columns: every 30 degrees
constexpr std::size_t parallel_step = 6;  // rows: every 15 degrees

// As bright as other lines, for any dimming of the lamp.
Vec3 ink_of(const Vec3& colour) {
  const auto largest = std::max({colour.r, colour.g, colour.b});
  return largest > 0.0f ? colour / largest * Vec3(1.0f, 0.85f, 0.55f) : Vec3(0.2f);
}

template <typename Place>
void add_wires(const Solid& solid, const Place& place, const Vec3& ink, Marks& marks) {
  const auto add = [&](std::size_t row, std::size_t column, std::size_t row2, std::size_t column2) {
    const auto from = solid.point(row, column), to = solid.point(row2, column2);
    if (from != to) marks.add_segment(place(from), place(to), ink);
  };
  for (std::size_t column = 0; column < Solid::columns; column += meridian_step)
    for (std::size_t row = 0; row + 1 < Solid::rows; ++row) add(row, column, row + 1, column);
  for (std::size_t row = parallel_step; row + 1 < Solid::rows; row += parallel_step)
    for (std::size_t column = 0; column < Solid::columns; ++column) add(row, column, row, column + 1);
}

}  // namespace

void add_photometric_solids(const PatchSet& patches, float scene_size, Marks& marks) {
  const auto radius = std::min(largest_radius, part_of_scene * static_cast<double>(scene_size));
  const auto colours = patches.colours();
  std::map<const Photometry*, Solid> solids;
  std::size_t count = 0;
  for (const auto& lamp : patches.point_lights) {
    if (lamp.light.kind != PointLightKind::luminaire) continue;
    if (count++ == max_solids) return;
    auto& solid = solids[lamp.light.photometry.get()];
    if (solid.radius.empty()) solid = photometric_solid(lamp.light.photometry->intensity);
    const auto place = [&](const Vec3d& at) { return Vec3(from_local_axes(lamp.light, radius * at)); };
    add_wires(solid, place, ink_of(in_gamut(colours.rgb(lamp.intensity))), marks);
  }
}

}  // namespace luxel
