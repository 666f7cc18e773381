// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/log.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/render/compare.h"
#include "luxel/scene/scene.h"
#include "luxel/session/session_settings.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/sampled.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct CheckReport;
struct PatchTree;
struct SampleState;

/// \file
/// Data that a session publishes. They are immutable once published: any thread may read them while it holds
/// a reference.

/// The surfaces that are lit.
struct SessionMesh {
  std::shared_ptr<const Scene> scene;  ///< as it was read; null where a solution was opened
  std::shared_ptr<const PatchSet> patches;
  /// Null until they are built.
  std::shared_ptr<const Tracer> tracer;
  std::shared_ptr<const PatchTree> tree;
  /// Meshes of the same number have the same vertices, corners, normals and contacts: only their materials
  /// differ. From 1.
  std::uint64_t geometry = 0;
};

/// The light on all surfaces at one moment.
struct SessionLight {
  SessionMesh mesh;  ///< that it lies on, with the materials as they are lit here
  Solution solution;
  /// Its vertices, normals and corners are the same in all lights of one geometry.
  std::shared_ptr<const SmoothLight> smooth;
  std::shared_ptr<const SampleState> samples;  ///< it was made from; null where they are not stored
  SampledOptions sampled;                      ///< of these samples
  std::uint64_t number = 0;                    ///< from 1: the newest has the highest
  std::uint32_t step = 0;      ///< lights of this solve before this one: bounces, or doublings of the samples
  bool is_relit = false;       ///< lamps or reflectances are not those of the scene
  std::optional<int> bounces;  ///< that brought it, where it is not all of it
  bool is_last = false;        ///< of its solve
  /// Light that the last bounce added and the next will reflect, W/m², [patch][band]. Empty where light does
  /// not come in bounces: for a sampled solve, a direct one, a file.
  SideValues unshot;
};

struct ConvergencePoint {
  double seconds = 0.0;    ///< of solving, pauses apart
  std::uint64_t rays = 0;  ///< traced by then
  double error = 0.0;      ///< standard error by the measure that ends the solve, a fraction
};

/// The work in progress and the work before it.
struct SessionStatus {
  /// Current stage: "load", "triangles", "patches", "refine" or "read", "hierarchy", "forecast", "factors",
  /// "light", "light groups", "relight", "bounces", "write"; empty when idle.
  std::string stage;
  double done = 0.0;          ///< fraction of the stage, 0 to 1
  bool is_idle = false;       ///< the solver has nothing to do, and no command waits
  bool is_answering = false;  ///< diagnostics or a difference are being computed, or will be
  bool is_paused = false;     ///< or will be, as soon as the solver takes the command
  bool is_stepping = false;   ///< by command

  std::string method;                     ///< of the solve, as in Provenance
  double error_asked = 0.0;               ///< sampled
  double error = 0.0;                     ///< of the newest light; 0: not known
  bool is_seen = false;                   ///< error and error_asked are the seen error, see ErrorMeasure
  std::uint64_t rays = 0;                 ///< traced so far
  double rays_per_second = 0.0;           ///< over the last seconds
  double seconds = 0.0;                   ///< of solving, pauses apart
  std::optional<double> seconds_left;     ///< an estimate; nothing where none can be made
  std::vector<ConvergencePoint> history;  ///< of this solve, a point for each light
  std::optional<StopReason> stop;         ///< why the last solve ended; nothing before it did
  std::uint32_t steps = 0;                ///< lights of this solve so far

  bool can_relight = false;  ///< the newest light has its samples

  std::string error_message;      ///< of the last failure, one sentence; empty: none
  std::uint64_t errors = 0;       ///< number of failures
  std::vector<Message> messages;  ///< warnings, and files written, in order
};

/// Difference of the newest light from a second solution on the same patches.
struct LightDifference {
  std::filesystem::path file;  ///< the second solution
  std::uint64_t light = 0;     ///< number of the light that was compared
  Comparison comparison;       ///< a: the second solution, b: the light of the session
  /// (b - a) / a of the mean over bands, [side], see SideId and relative_differences().
  std::vector<float> relative;
};

/// The state of a session at one moment.
struct SessionSnapshot {
  std::shared_ptr<const SessionMesh> mesh;    ///< null before it is read; at first without its tracer
  std::shared_ptr<const SessionLight> light;  ///< the newest; null before the first
  SessionStatus status;
  /// Options of the current or last solve, else of the first one to come. Never null.
  std::shared_ptr<const LightOptions> options;
  std::shared_ptr<const CheckReport> diagnostics;     ///< null until they are requested and found
  std::shared_ptr<const LightDifference> difference;  ///< null where nothing is compared
};

}  // namespace luxel
