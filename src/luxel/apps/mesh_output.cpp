// SPDX-License-Identifier: Apache-2.0
#include "luxel/apps/mesh_output.h"

#include <numeric>

#include <fmt/format.h>

#include "luxel/apps/outputs.h"
#include "luxel/export/export_kept.h"
#include "luxel/export/export_mesh.h"
#include "luxel/export/kept_layout.h"
#include "luxel/lightmap/make_lightmap.h"
#include "luxel/lightmap/radiance_pages.h"
#include "luxel/surface/vertex_fit.h"

namespace luxel {
namespace {

constexpr double worth_saying = 0.02;  // of the light that the file's own triangles cannot show

// What the scene's file says of where its surfaces lie, where that is wanted and can be used.
std::optional<GivenLayout> layout_of_file(const KeptInput& input, const MeshSettings& settings,
                                          const KeptOptions& options, Console& console) {
  if (settings.layout == "new") return std::nullopt;
  std::string why;
  auto given = kept_layout(input.scene, input.patches, options.metres_a_unit, why);
  if (given)
    console.say(fmt::format("{} are used as the file has them, on {} page{}", lightmap_coordinates,
                            given->pages, given->pages == 1 ? "" : "s"));
  else if (!why.empty())
    warn(console.log(), fmt::format("{}: the file's {} are not used, charts are made: {}", input.scene.source,
                                    lightmap_coordinates, why));
  return given;
}

LaidOut laid_out(const KeptInput& input, const GivenLayout& given, const LightmapOptions& options,
                 const Workers& workers) {
  const auto texels = texels_per_metre(input.patches, input.solution, options);
  return lay_out(input.scene, input.patches, given, options.crease_angle,
                 page_size_for(input.scene, given, texels, options.page_size), options.margin, workers);
}

void write_on_pages(const std::string& output, const KeptInput& input, const MeshSettings& settings,
                    const KeptOptions& options, const LookSettings& look, const Tracer* tracer,
                    const Workers& workers, Console& console) {
  auto lightmap_options = settings.pages.lightmap;
  lightmap_options.crease_angle = look.smooth.crease_angle;
  LightmapReport report;
  console.announce("charts");
  const auto* rays = needs_rays(settings) ? tracer : nullptr;
  const auto given = layout_of_file(input, settings, options, console);
  const auto lightmap = given ? fill_lightmap(input.patches, input.solution, rays,
                                              laid_out(input, *given, lightmap_options, workers),
                                              lightmap_options, workers, &report, console.monitor())
                              : make_lightmap(input.patches, input.solution, rays, lightmap_options, workers,
                                              &report, console.monitor());
  console.clear_bar();
  console.say(describe(lightmap, report));
  if (settings.as == "emissive") {
    const auto pages = radiance_pages(input.patches, lightmap, workers);
    return export_kept_emissive(output, input, {lightmap.atlas, pages, 1.0f, given.has_value()}, options);
  }
  const auto pages = irradiance_pages(lightmap);
  export_kept_lightmap(output, input, {lightmap.atlas, pages, white_of(pages), given.has_value()}, options);
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
