// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenes/furniture/window.h"
#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// The reading room, 7 x 2.8 x 5 m round the y axis, floor at y = 0, and the corridor behind its left wall.
inline constexpr auto room_low = Vec3d(-3.5, 0.0, -2.5);
inline constexpr auto room_high = Vec3d(3.5, 2.8, 2.5);
inline constexpr auto corridor_low = Vec3d(-5.1, 0.0, -3.6);
inline constexpr auto corridor_high = Vec3d(-3.62, 2.5, -0.2);

// The window in the back wall, and the doorway in the left one, by their size and the middle of their hole.
inline constexpr auto window = Opening{.width = 1.9, .height = 1.5, .depth = 0.30};
inline constexpr auto window_middle = Vec3d(1.05, 1.60, room_low.z);
inline constexpr auto door = Opening{.width = 0.90, .height = 2.10, .depth = 0.12};
inline constexpr auto door_middle = Vec3d(room_low.x, 1.05, -1.70);

// Walls, floors and ceilings, each an open sheet that faces into its room.
std::vector<Object> shell();

// What is nailed to them, closed: skirting boards, beams, the door's casing, the window's frame.
std::vector<Object> woodwork();

}  // namespace luxel::scenes
