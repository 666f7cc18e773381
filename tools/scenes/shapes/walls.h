// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// A flat face with holes: it extends from `origin` along two unit vectors, and its front is where
// along x up points. Lengths in metres.
struct Face {
  Vec3d origin, along, up;
  double length, height;
};

// A hole in a face: a rectangle by its distances along the face and up, and above it half an ellipse of this
// rise; 0: none. Arched holes of one face have the same `high` and `rise`, and no other hole begins or ends
// between these heights.
struct Hole {
  double left = 0.0, right = 0.0, low = 0.0, high = 0.0;
  double rise = 0.0;
};

// The face in cells of at most `cell`, without its holes. Cells meet corner to corner.
Mesh holed_face(const Face& face, const std::vector<Hole>& holes, double cell = 0.5);

// The sides of a hole that is `depth` deep, from the face backwards; they look into the hole. A hole that
// begins at the lower edge of the face has no sill unless `with_sill`.
Mesh reveals(const Face& face, const std::vector<Hole>& holes, double depth, bool with_sill = true);

// A wall with holes through it, `thickness` thick behind the face: front, back, reveals and ends; without a
// top and a bottom.
Mesh holed_wall(const Face& face, const std::vector<Hole>& holes, double thickness, double cell = 0.5);

// A room with walls, a floor and a roof of one thickness. Holes are measured seen from within, from the left
// lower corner; those of the ceiling from the corner of low x and z, along x and then along z.
enum Wall : std::size_t { back_wall, right_wall, front_wall, left_wall, ceiling_side, wall_count };
struct Room {
  Vec3d low, high;  // the inside
  double thickness = 0.30;
  std::array<std::vector<Hole>, wall_count> holes = {};
};

// One side of the room, seen from within.
Face inner_face(const Room& room, Wall wall);
Mesh inner_wall(const Room& room, Wall wall, double cell = 0.5);
Mesh room_floor(const Room& room, double cell_x, double cell_z);
Mesh all_reveals(const Room& room);
// The six outer faces, with the holes, looking outwards.
Mesh outside(const Room& room);

// A board along the foot of each wall, on the inside, interrupted at holes that begin at the floor.
Mesh skirting_boards(const Room& room, double height = 0.09, double thickness = 0.016);

}  // namespace luxel::scenes
