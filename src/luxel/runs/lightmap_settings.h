// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/export/target_application.h"
#include "luxel/render/make_lightmap.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// The options of `lightmap`.
struct LightmapSettings {
  static constexpr double automatic_white = 0.0;
  LightmapOptions lightmap;
  std::string layout = "file";     // layout of surfaces on pages: that of the scene's file, or a new one
  double white = automatic_white;  // W/m²: irradiance that a PNG shows as white
  std::string error_map, directional, preview, unwrapped;  // files; empty: none
  MeshCompression compression = MeshCompression::plain;    // of the unwrapped mesh, for further work
  void declare(OptionSet& set);
  // For outputs whose scene file may define a layout of surfaces on pages.
  void declare_layout(OptionSet& set);
  // Options for the layout of pages and the gathering of texels, for commands that put them into meshes.
  void declare_pages(OptionSet& set);
  void declare_texels(OptionSet& set);
  // Throws InputError where pages with this many texels per metre would be too large: call it before a solve.
  void check_texels(const PatchSet& patches) const;
};

// A sentence or two for a person.
std::string describe(const Lightmap& lightmap, const LightmapReport& report);

}  // namespace luxel
