// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/mesh_output.h"

#include <numeric>

#include <fmt/format.h>

#include "luxel/export/close_t_junctions.h"
#include "luxel/export/export_mesh.h"
#include "luxel/export/export_round_trip.h"
#include "luxel/export/lit_mesh.h"
#include "luxel/export/simplify_mesh.h"
#include "luxel/import/is_gltf.h"
#include "luxel/render/radiance_pages.h"
#include "luxel/runs/light_pages.h"
#include "luxel/surface/vertex_fit.h"

namespace luxel {
namespace {

constexpr double worth_saying =
    0.02;  // of the light that the file's own triangles cannot show; less is not reported

GlbDone write_on_pages(const std::string& output, const RoundTripInput& input, const MeshSettings& settings,
                       const RoundTripOptions& options, const Tracer* tracer, const RunPlace& place) {
  const auto& page_settings = settings.pages;
  const auto made =
      make_light_pages({input.patches, input.solution, &input.scene, options.metres_per_unit}, page_settings,
                       needs_rays(settings) ? tracer : nullptr, place.context, place.reporter, place.budget);
  if (!made) return {.is_written = false};
  const auto& [lightmap, record] = *made;
  const auto context = place.reporter.reporting(place.context, !place.reporter.is_interrupted());
  if (settings.as == "emissive") {
    const auto pages = radiance_pages(input.patches, lightmap, context);
    if (pages.empty() ||
        !export_round_trip_emissive(output, input, {lightmap.atlas, pages, 1.0f, record.as_file_has_it},
                                    options, context))
      return {.is_written = false};
  } else {
    const auto pages = irradiance_pages(lightmap);
    if (!export_round_trip_lightmap(
            output, input, {lightmap.atlas, pages, white_of(pages), record.as_file_has_it}, options, context))
      return {.is_written = false};
  }
  return {.pages = record};
}

// The mesh that is written: without the vertices that its light does not need, if the settings have it so,
// and without T-junctions. tone becomes that of the whole light: the mesh alone would be exposed otherwise.
SimplifiedMesh displayed_mesh(const Baked& baked, const SmoothLight& light, const MeshSettings& settings,
                              const SimplifyOptions& how, ToneOptions& tone) {
  const auto curve = curve_for(baked.patches, baked.solution, tone);
  tone.scale = curve.scale;
  tone.exposure = 0.0f;
  auto mesh = settings.simplify ? simplify_mesh(baked.patches, baked.solution, light, curve, how)
                                : SimplifiedMesh{baked.patches, baked.solution, light};
  close_t_junctions(mesh);
  return mesh;
}

void write_uncut(const std::string& output, const RoundTripInput& input, const SmoothLight& light,
                 const RoundTripOptions& options, Reporter& reporter) {
  const auto fit = fit_vertices(input.scene, input.patches, light);
  if (fit.difference > worth_saying)
    reporter.say(
        "note",
        fmt::format("{}: the file's triangles are too large to show {:.2g} % of the light (RMS); finer "
                    "ones, or --as lightmap, would",
                    output, 100.0 * fit.difference));
  export_round_trip_uncut(output, input, fit, options);
}

}  // namespace

bool needs_rays(const MeshSettings& settings) {
  return settings.on_pages() && settings.pages.lightmap.texels.error > 0.0;
}

bool is_simplified(const MeshSettings& settings) {
  return settings.simplify && !settings.keep_topology && !settings.on_pages();
}

GlbDone write_lit_glb(const std::string& output, const GlbInput& glb, const OutputSettings& settings,
                      const RunPlace& place) {
  const auto& baked = glb.baked;
  const auto& light = glb.light;
  const auto* tracer = glb.tracer;
  const auto& wish = settings.mesh;
  const auto& look = settings.look;
  auto mesh = wish.settings ? *wish.settings : MeshSettings{};
  mesh.pages.lightmap.crease_angle = look.smooth.crease_angle;
  if (mesh.keep_topology && !wish.scene)
    warn(place.reporter.log(),
         fmt::format("{}: its triangles are the patches; 'luxel export --preserve-topology --scene FILE' "
                     "has those of the scene's file",
                     output));
  const auto up = up_of(look, baked.patches);
  const auto hidden = glb.hidden_sides ? *glb.hidden_sides : FrontAndBack<std::uint8_t>{};
  const bool keeps =
      wish.scene && (mesh.keep_topology || is_gltf(wish.scene->source) || !wish.scene->textures.empty());
  if (!keeps && !mesh.on_pages()) {
    auto tone = look.tone;
    const auto shown =
        displayed_mesh(baked, *light, mesh, {.keeps_textured_patches = true, .hidden = hidden}, tone);
    export_glb(output, shown.patches, shown.solution, shown.light, up,
               {.tone = tone, .program = mesh.program, .compression = mesh.compression});
    return {};
  }
  RoundTripOptions options{.tone = look.tone,
                           .program = mesh.program,
                           .compression = mesh.compression,
                           .metres_per_unit = wish.metres_per_unit,
                           .up = up};
  const auto write = [&](const RoundTripInput& input) -> GlbDone {
    if (mesh.on_pages()) return write_on_pages(output, input, mesh, options, tracer, place);
    if (mesh.keep_topology) {
      write_uncut(output, input, *light, options, place.reporter);
      return {};
    }
    const auto shown = displayed_mesh(baked, *light, mesh, {.hidden = hidden}, options.tone);
    export_round_trip_cut(output, {input.scene, shown.patches, shown.solution}, shown.light, options);
    return {};
  };
  if (wish.scene) return write({*wish.scene, baked.patches, baked.solution});
  auto patches = baked.patches;
  std::iota(patches.triangle.begin(), patches.triangle.end(), 0u);
  const auto scene = scene_of(patches);
  return write({scene, patches, baked.solution});
}

}  // namespace luxel
