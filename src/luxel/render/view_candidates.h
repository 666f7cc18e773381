// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/render/view_score.h"

namespace luxel {

// A camera that keeps its horizon level, as two angles.
struct View {
  Vec3 eye = Vec3(0.0f);       // m
  float turn = 0.0f;           // share of a full turn around up
  float pitch = 0.0f;          // share of a full turn, up is positive, within a quarter
  float vertical_fov = 50.0f;  // degrees
};

// distance: from the eye to the target, m.
Camera camera_of(const View& view, const Vec3& up, float distance);

// Computes Subject::openness by a few thousand rays.
double openness(const Subject& subject);

// Places to stand, each with views all around: above, below and before lit surfaces, about half way between
// floor and ceiling. One list per place.
std::vector<std::vector<View>> views_from_inside(const Subject& subject);

// Views of the whole scene from outside, one list per turn around it.
std::vector<std::vector<View>> views_from_outside(const Subject& subject);

}  // namespace luxel
