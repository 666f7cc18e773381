// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/bounds.h"
#include "luxel/core/matrix.h"
#include "luxel/core/vector.h"
#include "luxel/scene/camera.h"

namespace luxel {

// The up direction, and two horizontal directions from which angles are counted; all unit.
struct Space {
  explicit Space(const Vec3& its_up = Vec3(0.0f, 1.0f, 0.0f));
  Vec3 up, ahead, right;
};

// Position and direction of the eye, the horizon level.
struct Pose {
  Vec3 eye = Vec3(0.0f);       // m
  float turn = 0.0f;           // radians around up from Space::ahead to the right
  float pitch = 0.0f;          // radians, up is positive; within steepest
  float vertical_fov = 50.0f;  // degrees

  bool operator==(const Pose&) const = default;
};
inline constexpr float steepest = 1.55f;  // radians: just short of straight up

// The eye's own axes in the world, unit.
struct Axes {
  Vec3 right, up, ahead;
};
Axes axes(const Pose& pose, const Space& space);

// Pose of a camera, without its roll; and a camera of a pose, with its target at `distance` (m).
Pose pose_of(const Camera& camera, const Space& space);
Camera camera_of(const Pose& pose, const Space& space, float distance = 1.0f);

// Each movement gives the new pose.
Pose look(Pose pose, float turn, float pitch);                                      // radians
Pose fly(Pose pose, const Space& space, const Vec3& right_up_ahead, float metres);  // the way may be 0
// Turns around a point, which stays at its place on the screen.
Pose orbit(const Pose& pose, const Space& space, const Vec3& pivot, float turn, float pitch);
// Scales the distance to the point by this factor; the point stays where it is on the screen.
Pose approach(Pose pose, const Vec3& point, float factor);
// Looks at the point from `distance` (m), in the direction it has from here.
Pose focus(const Pose& pose, const Space& space, const Vec3& point, float distance);
// Shows all of a box from above a corner; the fallback for scenes without a better view.
Pose overview(const Bounds& box, const Space& space, float aspect, float vertical_fov = 50.0f);
// Interpolates between two poses, fraction 0 to 1, turning the shorter way.
Pose between(const Pose& from, const Pose& to, float fraction);

// The ray of a pixel: origin and unit direction. x, y: in [-1, 1] from the left and from the bottom.
struct Sight {
  Vec3 origin, direction;
};
Sight sight(const Pose& pose, const Space& space, float aspect, float x, float y);

// A part of the picture, in the same units: all of it, or a tile of a large one.
struct Tile {
  float left = -1.0f, right = 1.0f, bottom = -1.0f, top = 1.0f;
};

// From the world (m) to clip space. The near plane lies halfway to the box, or at 1e-4 of the far plane where
// that is more, or at a quarter of `empty`, but at most 1e-3 of the far plane; the far plane lies behind the
// box. empty: distance up to which nothing was found in the view, m.
Mat4 projection(const Pose& pose, const Space& space, const Bounds& box, float aspect, const Tile& tile = {},
                float empty = 0.0f);

}  // namespace luxel
