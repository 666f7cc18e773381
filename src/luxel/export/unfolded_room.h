// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/export/room_data.h"
#include "luxel/lighting/calculation_plane.h"

namespace luxel {

enum class RoomFaceKind { floor, ceiling, wall };

// A face of a room with a rectangular floor, as an area that can be measured.
struct RoomFace {
  RoomFaceKind kind = RoomFaceKind::floor;
  std::size_t edge = 0;  // of a wall: it stands on this edge of the outline
  CalculationArea area;  // 1 cm in front of the surface
};

// Floor, ceiling and the four walls of a room whose outline is one rectangle; of these, the faces that
// surfaces cover by half at least. Empty for other rooms.
std::vector<RoomFace> faces_of(const RoomData& room, const PatchSet& patches);

// Illuminance on the faces of a room.
struct MeasuredFace {
  RoomFace face;
  PlaneResult result;
};
using UnfoldedRoom = std::vector<MeasuredFace>;

// The room unfolded: the floor, the walls laid down around it, and the ceiling beyond the upper wall, in
// false colours with isolux lines and one scale for all. A whole <svg> element; faces: not empty.
std::string unfolded_svg(const UnfoldedRoom& faces, const RoomData& room);

}  // namespace luxel
