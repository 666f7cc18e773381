// SPDX-License-Identifier: Apache-2.0
#include "luxel/apps/mesh_output.h"

#include <numeric>

#include <fmt/format.h>

#include "luxel/apps/outputs.h"
#include "luxel/export/export_kept.h"
#include "luxel/export/export_mesh.h"
#include "luxel/lightmap/make_lightmap.h"
#include "luxel/lightmap/radiance_pages.h"
#include "luxel/surface/vertex_fit.h"

namespace luxel {
namespace {

constexpr double worth_saying = 0.02;  // of the light that the file's own triangles cannot show

void write_on_pages(const std::string& output, const KeptInput& input, const MeshSettings& settings,
                    const KeptOptions& options, const LookSettings& look, const Tracer* tracer,
                    const Workers& workers, Console& console) {
  auto lightmap_options = settings.pages.lightmap;
  lightmap_options.crease_angle = look.smooth.crease_angle;
  LightmapReport report;
  console.announce("charts");
  const auto lightmap = make_lightmap(input.patches, input.solution, needs_rays(settings) ? tracer : nullptr,
                                      lightmap_options, workers, &report, console.monitor());
  console.clear_bar();
  console.say(describe(lightmap, report));
  if (settings.as == "emissive") {
    const auto pages = radiance_pages(input.patches, lightmap, workers);
    return export_kept_emissive(output, input, {lightmap.atlas, pages}, options);
  }
  const auto pages = irradiance_pages(lightmap);
  export_kept_lightmap(output, input, {lightmap.atlas, pages, white_of(pages)}, options);
}

void write_kept(const std::string& output, const KeptInput& input, const std::optional<SmoothLight>& light,
                const MeshSettings& settings, const KeptOptions& options, const LookSettings& look,
                const Tracer* tracer, const Workers& workers, Console& console) {
  if (settings.on_pages())
    return write_on_pages(output, input, settings, options, look, tracer, workers, console);
  if (!settings.keep_topology) return export_kept_cut(output, input, *light, options);
  const auto fit = fit_vertices(input.scene, input.patches, *light);
  if (fit.difference > worth_saying)
    console.say(
        fmt::format("{}: the file's triangles are too large to show {:.2g} % of the light (RMS); finer "
                    "ones, or --as lightmap, would",
                    output, 100.0 * fit.difference));
  export_kept_uncut(output, input, fit, options);
}

}  // namespace

bool needs_rays(const MeshSettings& settings) {
  return settings.on_pages() && settings.pages.lightmap.texels.error > 0.0;
}

void write_lit_glb(const std::string& output, const Baked& baked, const std::optional<SmoothLight>& light,
                   const MeshWish& wish, const LookSettings& look, const Tracer* tracer,
                   const Workers& workers, Console& console) {
  const MeshSettings defaults;
  const auto& settings = wish.settings ? *wish.settings : defaults;
  if (settings.keep_topology && !wish.scene)
    warn(console.log(),
         fmt::format("{}: its triangles are the patches; 'luxel export --keep-topology --scene FILE' "
                     "has those of the scene's file",
                     output));
  const auto up = up_of(look, baked.patches);
  const bool keeps = wish.scene && (settings.keep_topology || is_gltf(*wish.scene));
  if (!keeps && !settings.on_pages())
    return export_glb(output, baked.patches, baked.solution, *light, up,
                      {.tone = look.tone, .program = settings.program});
  const KeptOptions options{
      .tone = look.tone, .program = settings.program, .metres_a_unit = wish.metres_a_unit, .up = up};
  if (wish.scene)
    return write_kept(output, {*wish.scene, baked.patches, baked.solution}, light, settings, options, look,
                      tracer, workers, console);
  auto patches = baked.patches;
  std::iota(patches.triangle.begin(), patches.triangle.end(), 0u);
  const auto scene = scene_of(patches);
  write_kept(output, {scene, patches, baked.solution}, light, settings, options, look, tracer, workers,
             console);
}

}  // namespace luxel
