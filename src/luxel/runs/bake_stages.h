// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "luxel/runs/light_stage.h"

namespace luxel {

// Input of the light stage of a bake.
struct BakeStart {
  Baked baked;                              // patches and provenance; for a resumed run, its light
  std::optional<RefineReport> refined;      // where patches were refined
  std::shared_ptr<const SampleState> from;  // where a run resumes from a checkpoint
  std::vector<std::uint32_t> faces;         // see uncut_faces(), where they count
};

// From a scene to the input of LightStage: the one order of stages of the command `luxel bake` and of the
// Python function bake(), so that the same options give the same bytes.
class BakeStages {
 public:
  // options: declared settings; the provenance of the solution lists them. Keeps references.
  BakeStages(const BakeSettings& settings, const OptionSet& options, const RunPlace& place)
      : settings_(settings), options_(options), place_(place) {}

  // The patches of the scene, refined where that is requested, or the run of a checkpoint. needs_view:
  // whether PatchSet::view is found where the scene has no camera. Nothing where the run was interrupted
  // before there was light.
  std::optional<BakeStart> begin(const Scene& scene, bool needs_view) const;

 private:
  bool refines() const;
  PatchSet cut(const Scene& scene) const;
  void refine(Baked& baked, RefineReport& report) const;
  void focus(const Scene& scene, PatchSet& patches) const;
  void set_groups(const Scene& scene, PatchSet& patches) const;
  void sign(Solution& solution) const;

  const BakeSettings& settings_;
  const OptionSet& options_;
  RunPlace place_;
};

}  // namespace luxel
