// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "luxel/export/plan_axes.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// One material of a room.
struct RoomMaterial {
  std::string name;
  double area = 0.0;         // m², of all its patches, one side
  double reflectance = 0.0;  // luminous, of light with equal power in all bands; mean over the area, [0, 1)
  bool emits = false;
};

// The shape and the surfaces of a room, found from its patches. Points: plan coordinates in the coordinates
// of the scene's file, m.
struct RoomData {
  PlanAxes axes;
  Vec3d low{0.0}, high{0.0};                    // corners of the bounding box
  double floor_area = 0.0;                      // m²
  std::vector<std::vector<PlanPoint>> outline;  // closed loops around the floor, anticlockwise
  std::vector<RoomMaterial> materials;          // in the order of the file
  // Patches that do not emit: level at the lowest height; level at the largest; upright along the outline.
  std::vector<std::uint32_t> floor, ceiling, walls;
};

// up: of the scene, unit. Where nothing is level at the lowest height, floor and outline are the rectangle of
// the bounding box. Throws InputError where there are no patches, MismatchError where the bands have no
// luminance.
RoomData find_room_data(const PatchSet& patches, const Vec3d& up);

}  // namespace luxel
