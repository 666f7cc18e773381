// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

enum class RoomWall { south, east, north, west };  // at y = 0, x = length, y = width, x = 0

// A window in a wall: a hole, and a pane of glass in it.
struct RoomWindow {
  RoomWall wall = RoomWall::south;
  double along = 0.0;                // m, of its lower x (south, north) or y (east, west)
  double sill = 0.0;                 // m above the floor
  double width = 1.0, height = 1.0;  // m
};

// An empty box room. z is up, its corner at the origin: x runs along its length, y along its width.
struct RoomModel {
  Vec3d size{6.0, 4.0, 2.8};                                        // m: length, width, height
  std::array<double, 3> reflectance = {70.0, 50.0, 20.0};           // per cent: ceiling, walls, floor
  std::array<std::string, 3> names = {"ceiling", "wall", "floor"};  // of the materials
  std::vector<RoomWindow> windows;
};

// "6x4x2.8", m.
std::optional<Vec3d> parse_room_size(const std::string& text);
std::string text_of_size(const Vec3d& size);
// "south:1,0.9,2,1.2": wall, place along it, sill, width, height, m.
std::optional<RoomWindow> parse_room_window(const std::string& text);
std::string text_of(const RoomWindow& window);

// Throws UsageError: a window that leaves its wall, or overlaps another.
void check(const RoomModel& room);

// Wavefront OBJ and MTL. Surfaces face inwards; groups floor, ceiling, south_wall and so on, window_1 and so
// on. Every edge is shared by the two surfaces that meet there.
std::string obj_of(const RoomModel& room, const std::string& material_library);
std::string mtl_of(const RoomModel& room);

}  // namespace luxel
