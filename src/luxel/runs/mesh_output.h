// SPDX-License-Identifier: Apache-2.0
#pragma once

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

// is_written: false after an early Ctrl-C. pages: present where the mesh has light on pages.
struct GlbDone {
  bool is_written = true;
  std::optional<PagesRecord> pages = {};
};

// Writes a GLB by the settings. light: present where light is at vertices. tracer: present where needs_rays()
// returns true. Throws DeviceError, and MismatchError where the scene is not the solution's.
GlbDone write_lit_glb(const std::string& output, const Baked& baked, const std::optional<SmoothLight>& light,
                      const OutputSettings& settings, const Tracer* tracer, const RunPlace& place);

}  // namespace luxel
