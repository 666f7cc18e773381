// SPDX-License-Identifier: Apache-2.0
#include "luxel/apps/mesh_settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace luxel {

void MeshSettings::declare(OptionSet& set) {
  set.heading("Mesh (.glb)");
  set.add({"for", "PROGRAM",
           fmt::format("the program that a .glb is for: {}", fmt::join(mesh_program_names(), ", ")),
           [this](const std::string& text) {
             const auto found = mesh_program(text);
             if (!found)
               throw UsageError(fmt::format("--for: expected one of {}, not '{}'",
                                            fmt::join(mesh_program_names(), ", "), text));
             program = *found;
           },
           [this] { return std::string(name(program)); }});
  set.add_choice(
      "as", {"vertex", "lightmap", "emissive"}, as,
      "how a .glb has its light: at its vertices, in textures that light it, or in textures that shine");
  set.add_flag("keep-topology", keep_topology,
               "the triangles of the scene's file as they are: light is fitted to their vertices");
  set.only_with("as", "lightmap|emissive");
  pages.declare_layout(set);
  pages.declare_pages(set);
  pages.declare_texels(set);
  set.only_with();
}

void MeshSettings::check() const {
  if (keep_topology && on_pages())
    throw UsageError(
        fmt::format("--keep-topology goes with --as vertex: --as {} keeps triangles of itself", as));
}

}  // namespace luxel
