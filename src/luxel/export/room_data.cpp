// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/room_data.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/error.h"
#include "luxel/export/floor_outline.h"
#include "luxel/render/solution_light.h"

namespace luxel {
namespace {

constexpr double level = 0.99;      // cosine of the angle between a level surface's normal and up, at least
constexpr double thickness = 0.02;  // m: surfaces so near to the lowest height are the floor, and so on

double luminous_reflectance(const PatchSet& patches, std::size_t patch, const std::vector<double>& lux) {
  double reflected = 0.0, arriving = 0.0;
  for (std::size_t b = 0; b < lux.size(); ++b) {
    reflected += lux[b] * static_cast<double>(patches.reflectance(patch, b));
    arriving += lux[b];
  }
  return reflected / arriving;
}

std::vector<RoomMaterial> find_materials(const PatchSet& patches) {
  const auto lux = lux_of_bands(patches);
  std::vector<RoomMaterial> materials(patches.materials.size());
  for (std::size_t m = 0; m < materials.size(); ++m) {
    materials[m].name = patches.materials[m].name;
    materials[m].emits = patches.materials[m].is_lamp();
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    auto& material = materials[static_cast<std::size_t>(patches.material[p])];
    const auto area = static_cast<double>(patches.area[p]);
    material.area += area;
    material.reflectance += area * luminous_reflectance(patches, p, lux);
  }
  std::erase_if(materials, [](const auto& material) { return !(material.area > 0.0); });
  for (auto& material : materials) material.reflectance /= material.area;
  return materials;
}

void find_box(const PatchSet& patches, RoomData& room) {
  room.low = room.high = room.axes.in_plan(patches.in_file(patches.vertices[patches.corners[0][0]]));
  for (const auto& corners : patches.corners)
    for (const auto vertex : corners) {
      const auto place = room.axes.in_plan(patches.in_file(patches.vertices[vertex]));
      room.low = glm::min(room.low, place);
      room.high = glm::max(room.high, place);
    }
}

Vec3d middle(const PatchSet& patches, const RoomData& room, std::size_t patch) {
  return room.axes.in_plan(patches.in_file(patches.centroid(patch)));
}

void find_level(const PatchSet& patches, RoomData& room) {
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    if (std::abs(glm::dot(Vec3d(patches.normal[p]), room.axes.up)) < level) continue;
    if (patches.material_of(p).is_lamp()) continue;
    const auto height = middle(patches, room, p).z;
    if (height < room.low.z + thickness)
      room.floor.push_back(p);
    else if (height > room.high.z - thickness)
      room.ceiling.push_back(p);
  }
}

void find_walls(const PatchSet& patches, RoomData& room) {
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    if (std::abs(glm::dot(Vec3d(patches.normal[p]), room.axes.up)) > 1.0 - level) continue;
    const auto place = middle(patches, room, p);
    for (const auto& loop : room.outline)
      if (distance_from(loop, {place.x, place.y}) < thickness) {
        room.walls.push_back(p);
        break;
      }
  }
}

}  // namespace

RoomData find_room_data(const PatchSet& patches, const Vec3d& up) {
  if (patches.size() == 0) throw InputError("the solution has no patches");
  RoomData room;
  room.axes = plan_axes(up);
  room.materials = find_materials(patches);
  find_box(patches, room);
  find_level(patches, room);
  room.outline = floor_outline(patches, room.floor, room.axes);
  if (room.outline.empty())
    room.outline = {{{room.low.x, room.low.y},
                     {room.high.x, room.low.y},
                     {room.high.x, room.high.y},
                     {room.low.x, room.high.y}}};
  for (const auto& loop : room.outline) room.floor_area += area_of(loop);
  find_walls(patches, room);
  return room;
}

}  // namespace luxel
