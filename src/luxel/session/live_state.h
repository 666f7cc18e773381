// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/log.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/scene/scene.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/sampled.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// What a live scene shows. All of it is immutable once it is seen, so it may be read by any thread for as
// long as it is held.

// What light lies on.
struct LiveMesh {
  std::shared_ptr<const Scene> scene;  // as it was read; none where a solution was opened
  std::shared_ptr<const PatchSet> patches;
  // None yet where the mesh has only just come.
  std::shared_ptr<const Tracer> tracer;
  std::shared_ptr<const PatchTree> tree;
  // Meshes of the same number have the same vertices, corners, normals and contacts: only their materials
  // differ. From 1.
  std::uint64_t geometry = 0;
};

// A picture of the whole scene.
struct LiveLight {
  LiveMesh mesh;  // that it lies on, with the materials as they are lit here
  Solution solution;
  // Its vertices, normals and corners are the same in all lights of one geometry.
  std::shared_ptr<const SmoothLight> smooth;
  std::shared_ptr<const SampleState> samples;  // it was made from; none where they are not known
  SampledOptions sampled;                      // they were made with
  std::uint64_t number = 0;                    // from 1: the newest has the highest
  std::uint32_t step = 0;      // pictures of this solve before this one: bounces, or doublings of the samples
  bool is_relit = false;       // lamps or reflectances are not those of the scene
  std::optional<int> bounces;  // that brought it, where it is not all of it
  bool is_last = false;        // of its solve
  // What the last bounce brought and the next will send on, W/m², [patch][band]. Empty where light does not
  // come in bounces: of a sampled solve, a direct one, a file.
  std::vector<float> unshot_front, unshot_back;
};

struct ConvergencePoint {
  double seconds = 0.0;    // of solving, pauses apart
  std::uint64_t rays = 0;  // traced by then
  double error = 0.0;      // standard error by the measure that ends the solve, a share
};

// What is going on, and what went before.
struct LiveStatus {
  // What is being done: "load", "triangles", "patches", "refine" or "read", "hierarchy", "forecast",
  // "factors", "light", "light groups", "relight", "bounces", "write"; empty where there is nothing to do.
  std::string stage;
  double done = 0.0;          // share of the stage, 0 to 1
  bool is_idle = false;       // the solver has nothing to do, and no command waits
  bool is_answering = false;  // beside it diagnostics or a difference are looked for, or will be
  bool is_paused = false;     // or will be, as soon as the solver hears of it
  bool is_stepping = false;

  std::string method;                     // of the solve
  double error_asked = 0.0;               // sampled
  double error = 0.0;                     // of the newest light; 0: not known
  bool is_seen = false;                   // error and error_asked are the seen error, see ErrorMeasure
  std::uint64_t rays = 0;                 // traced so far
  double rays_per_second = 0.0;           // lately
  double seconds = 0.0;                   // of solving, pauses apart
  std::optional<double> seconds_left;     // a guess; nothing where none can be made
  std::vector<ConvergencePoint> history;  // of this solve, a point an answer
  std::optional<StopReason> stop;         // why the last solve ended; nothing before it did
  std::uint32_t steps = 0;                // pictures of this solve so far

  bool can_relight = false;  // the newest light knows its samples

  std::string error_message;      // of the last thing that failed, one sentence; empty: nothing did since
  std::uint64_t errors = 0;       // that there were: a new one has a new number
  std::vector<Message> messages;  // warnings, and files written, in order
};

}  // namespace luxel
