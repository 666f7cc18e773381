// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/cli/console.h"
#include "luxel/cli/light_pages.h"
#include "luxel/cli/mesh_settings.h"
#include "luxel/cli/settings.h"
#include "luxel/core/workers.h"
#include "luxel/solution/solution_file.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Whether the mesh needs rays: texels may gather light anew.
bool needs_rays(const MeshSettings& settings);

// is_written: false where Ctrl-C came too early. pages: where it has light on pages.
struct GlbDone {
  bool is_written = true;
  std::optional<PagesRecord> pages = {};
};

// A GLB as it is wished for. light: there where light is at vertices. tracer: there where needs_rays() says
// so. Throws DeviceError, and MismatchError where the scene is not the solution's.
GlbDone write_lit_glb(const std::string& output, const Baked& baked, const std::optional<SmoothLight>& light,
                      const MeshWish& wish, const LookSettings& look, const Tracer* tracer,
                      const Workers& workers, Console& console);

}  // namespace luxel
