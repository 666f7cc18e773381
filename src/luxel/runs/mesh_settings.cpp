// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/mesh_settings.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/core/ending_of.h"
#include "luxel/runs/compression_setting.h"

namespace luxel {

void MeshSettings::declare(OptionSet& set) {
  set.heading("Mesh (.glb)");
  set.add({"for", fmt::format("{}", fmt::join(mesh_program_names(), "|")), "target application of a .glb",
           [this](const std::string& text) {
             const auto found = target_application(text);
             if (!found)
               throw UsageError(fmt::format("--for: expected one of {}, not '{}'",
                                            fmt::join(mesh_program_names(), ", "), text));
             program = *found;
           },
           [this] { return std::string(name(program)); }});
  set.add_choice("as", {"vertex", "lightmap", "emissive"}, as,
                 "how a .glb stores the light: vertex: vertex colours; lightmap: lightmap textures; "
                 "emissive: emissive textures");
  set.add_flag("preserve-topology", keep_topology,
               "preserve the triangles of the scene file, with the light fitted to their vertices");
  set.add_switch(
      "simplify", simplify,
      "with --as vertex: merge triangles of a .glb where the light displays the same without them, to "
      "within three quarters of an 8-bit code");
  declare_compression(set, compression, "a .glb");
  set.only_with("as", "lightmap|emissive");
  pages.declare_layout(set);
  pages.declare_pages(set);
  pages.declare_texels(set);
  set.only_with();
}

void MeshSettings::check() const {
  if (keep_topology && on_pages())
    throw UsageError(
        fmt::format("--preserve-topology needs --as vertex: --as {} preserves the triangles anyway", as));
  check_compression(compression, program);
}

void MeshSettings::check_outputs(const std::vector<std::string>& outputs) const {
  const auto is_glb = [](const std::string& output) { return ending_of(output) == ".glb"; };
  if (outputs.empty() || std::any_of(outputs.begin(), outputs.end(), is_glb)) return;
  for (const auto& [option, is_asked] :
       {std::pair(std::string("--preserve-topology"), keep_topology), std::pair("--as " + as, on_pages()),
        std::pair(fmt::format("--for {}", name(program)), program != TargetApplication::any),
        std::pair(fmt::format("--compress {}", name(compression)),
                  compression != MeshCompression::quantised)})
    if (is_asked) throw UsageError(option + " applies to a .glb: add -o FILE.glb, or remove it");
}

}  // namespace luxel
