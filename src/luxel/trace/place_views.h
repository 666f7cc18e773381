// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"
#include "luxel/trace/views.h"

namespace luxel {

struct ViewOptions {
  // Views of each of the two sets: at least min_views, more_per_place more for each place (a room, or the
  // outside) beyond the first, at most max_views. Measured in the Cornell box: the seen error of 260 views of
  // 512 directions is within 8 % of that of 626 views of 2,048.
  std::size_t min_views = 192;
  std::size_t more_per_place = 32;
  std::size_t max_views = 512;
  std::size_t grid = 16;  // directions of a view: 2 * grid², 512

  std::size_t scouts = 384;    // viewpoints by which the places are found
  std::size_t scout_grid = 8;  // directions of a scout: 128
};

// Two sets of views, each spread over the open space of the scene.
struct ViewSets {
  Views dealing;  // decide which sides need more rays
  Views stating;  // estimate the error: other viewpoints, so that the choice of `dealing` does not bias it
  double places = 0.0;  // rooms and the outside, estimated; 0: no open space was found

  bool empty() const { return dealing.size() == 0 || stating.size() == 0; }
};

// Places viewpoints in the open space of a scene, in equal numbers for every room and for the outside,
// whatever their size, and lets each look all around. Open space is where a lamp, a lit sky or an eye of
// PatchSet::eyes reaches (open_space.h); insides of solids and sealed cavities get no views.
//
// Scouts go out from surfaces, half by area and half by input triangle: a cosine ray, a random point along it
// (cut at half the extent of the scene). They are weighted so that each place counts alike (place_weights.h).
// Views start from surfaces that a scout sees, scouts taken by weight, in the same way. A viewpoint is at
// least 3 % of the extent of the scene away from any surface, or 0.3 m if that is less, and meets surfaces in
// at least a sixteenth of its directions. Each camera is two views as well, one all around from its eye and
// one of its picture; together they weigh as one place.
//
// PatchSet::focus: views start from surfaces in the focus, and only directions that meet those count.
//
// The result depends on patches alone: not on any seed, threads or ranks. Cost: about 0.1 us per ray in a
// simple scene, 1 us in one of a million patches; 0.3 to 0.6 million rays.
ViewSets place_views(const PatchSet& patches, const Tracer& tracer, const Context& context,
                     const ViewOptions& options = {});

// Returns the views of the cameras as both sets, for PatchSet::focus_cameras. Each camera is one view of
// about four thousand directions, evenly spread over the picture (Camera::aspect, else 4:3).
ViewSets camera_views(const PatchSet& patches, const Tracer& tracer, const Context& context);

// Returns the one view of a camera, with as many directions.
Views camera_view(const PatchSet& patches, const Tracer& tracer, const Camera& camera);

}  // namespace luxel
