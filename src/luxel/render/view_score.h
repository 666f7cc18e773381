// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/lit_sides.h"
#include "luxel/scene/camera.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The scene in which thumbnails are traced.
struct Subject {
  const PatchSet& patches;
  const LitSides& sides;
  const Tracer& tracer;
  Bounds box;             // of all patches
  float diagonal = 0.0f;  // of the box, m
  Vec3 up;
  float aspect;           // width / height
  double openness = 0.0;  // share of what leaves lit sides that meets nothing: 0 in a closed room
};

// Numbers of a thumbnail; shares are of its pixels.
struct ViewFacts {
  double bright = 0.0;    // mean brightness (LitSides); nothing seen counts as 0
  double lit = 0.0;       // share that shows lit surface
  double empty = 0.0;     // share that shows nothing
  double glare = 0.0;     // share that shows lamps from their front
  double near = 0.0;      // share that shows something steep, too near for the picture's depth
  double coverage = 0.0;  // share of the scene's lit area that is in view, roughly
  double variety = 0.0;   // of directions, depths and materials, 0 to 1
  double detail = 0.0;    // share of neighbouring pixels that show different surfaces
  double border = 0.0;    // share of the picture's border that shows something
  double gap = 0.0;       // share of the picture's outline that is black, where that counts
  double lopsided = 0.0;  // emptiness of the left half less that of the right, without sign
  double rise = 0.0;      // sine of the angle the view points above level
  float depth = 0.0f;     // geometric mean distance of what is seen, m; 0: nothing
};

// rows: height of the thumbnail in pixels. Cost: rows * rows * aspect rays.
ViewFacts look(const Subject& subject, const Camera& camera, int rows);

// Higher is better; only the order means anything. The more open the scene, the more emptiness is forgiven.
double score(const ViewFacts& facts, double openness);

}  // namespace luxel
