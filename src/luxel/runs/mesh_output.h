// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "luxel/runs/light_pages.h"
#include "luxel/runs/mesh_settings.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/settings.h"
#include "luxel/solution/solution_file.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Returns whether the mesh needs rays, as texels may be gathered.
bool needs_rays(const MeshSettings& settings);

// Returns whether vertices are removed that the light does not need, so that it needs the hidden sides.
bool is_simplified(const MeshSettings& settings);

// is_written: false after an early Ctrl-C. pages: present where the mesh has light on pages.
struct GlbDone {
  bool is_written = true;
  std::optional<PagesRecord> pages = {};
};

// The contents of a GLB. Those that its settings do not need may be absent.
struct GlbInput {
  const Baked& baked;
  const std::optional<SmoothLight>& light;         // at vertices
  const FrontAndBack<std::uint8_t>* hidden_sides;  // where is_simplified() returns true
  const Tracer* tracer;                            // where needs_rays() returns true
};

// Writes a GLB by the settings. Throws DeviceError, and MismatchError where the scene is not the solution's.
GlbDone write_lit_glb(const std::string& output, const GlbInput& input, const OutputSettings& settings,
                      const RunPlace& place);

}  // namespace luxel
