// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "luxel/core/context.h"
#include "luxel/core/log.h"
#include "luxel/core/progress.h"
#include "luxel/session/session_settings.h"
#include "luxel/session/session_snapshot.h"

namespace luxel {

// Reads the file of a session and prepares its mesh for solving.
class SceneOpener {
 public:
  // Called in the opening thread with each newer mesh.
  using Show = std::function<void(const SessionMesh&)>;

  // Keeps a reference to settings. After the monitor's stop results are incomplete.
  SceneOpener(std::filesystem::path file, const SessionSettings& settings, Context context, Show show);

  // A scene with its mesh. Throws InputError.
  struct OpenedScene {
    SessionMesh mesh;  // without its tracer where the monitor stopped it, else with it
    double mesh_error = 0.0;
    std::vector<std::uint32_t> faces = {};  // of each patch, where patches of one face have one value
  };
  OpenedScene open_scene() const;

  // A solution with its mesh, which is not traced yet. Throws what read_stored_run() throws.
  struct OpenedSolution {
    SessionMesh mesh;
    Solution solution;
    std::shared_ptr<const SampleState> samples;
  };
  OpenedSolution open_solution() const;

  // Builds the tracer and the hierarchy of the mesh, and finds the portals of its scene.
  void build_tracer(SessionMesh& mesh) const;

 private:
  void group_lamps(const Scene& scene, PatchSet& patches) const;
  Next begin_stage(const char* stage) const { return context_.report({.stage = stage}); }

  std::filesystem::path file_;
  const SessionSettings& settings_;
  Context context_;
  Show show_;
};

}  // namespace luxel
