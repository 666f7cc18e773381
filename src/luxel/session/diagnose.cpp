// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/diagnose.h"

#include <algorithm>

#include "luxel/patch/make_patches.h"
#include "luxel/session/glass_diagnostics.h"
#include "luxel/session/light_diagnostics.h"
#include "luxel/session/mesh_diagnostics.h"

namespace luxel {
namespace {

void summarise(const ScannedMesh& mesh, CheckReport& report) {
  report.lit_triangles = mesh.clean.kept.size();
  report.components = mesh.components.components.size();
  for (const auto& component : mesh.components.components) {
    report.area += component.area;
    if (component.is_closed) ++report.closed_components;
  }
  report.box = mesh.box;
}

// The checks that trace rays. Returns false if stopped.
bool look_at_light(const ScannedMesh& mesh, const CheckOptions& options, const Context& context,
                   CheckReport& report) {
  const auto patches = make_patches(*mesh.scene, {.max_edge = no_max_edge}, context.quiet());
  if (context.report({.stage = "hierarchy"}) == Next::stop) return false;
  const Tracer tracer(patches, context);
  const auto views = view_from_lamps(patches, tracer, context);
  const auto paths = options.paths > 0 ? options.paths : std::max<std::size_t>(16'384, patches.size() / 4);
  report.walks = walk_light(patches, tracer, paths, options.seed, context);
  const auto openings = find_openings(mesh, report.walks.lost, context);
  find_bad_lamps(mesh, patches, views, report.walks, report.diagnostics);
  find_misplaced_luminaires(mesh, patches, tracer, options.places, report.diagnostics);
  find_lost_light(mesh, patches, report.walks, openings, options.places, report.diagnostics);
  report.rays = report.walks.rays + 2000 * views.size();
  if (views.empty() && !patches.has_sky()) return true;  // no light at all: a list is useless
  const auto unlit = find_unlit(
      patches, tracer,
      {.has_sky = patches.has_sky(), .seed = options.seed, .is_known_lit = report.walks.is_met}, context);
  report.rays += unlit.rays;
  report.dark_walks = unlit.walks;
  if (!unlit.is_whole) return false;
  find_dark_surfaces(mesh, patches, unlit, options.places, report.diagnostics);
  return true;
}

}  // namespace

std::size_t CheckReport::count(Severity severity) const {
  return static_cast<std::size_t>(std::count_if(diagnostics.begin(), diagnostics.end(),
                                                [&](const Diagnostic& f) { return f.severity == severity; }));
}

CheckReport diagnose(const Scene& scene, const CheckOptions& options, const Context& context) {
  CheckReport report;
  report.triangles = scene.triangles.size();
  const auto mesh = scan_mesh(scene, context, report.is_whole);
  if (!report.is_whole) return report;
  summarise(mesh, report);
  find_bad_triangles(mesh, context, options.places, report.diagnostics);
  find_bad_edges(mesh, options.places, report.diagnostics);
  find_bad_numbers(mesh, options.places, report.diagnostics);
  find_bad_glass(mesh, context, options.places, report.diagnostics);
  if (!mesh.clean.kept.empty()) report.is_whole = look_at_light(mesh, options, context, report);
  std::stable_sort(report.diagnostics.begin(), report.diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return a.severity != b.severity ? a.severity > b.severity : a.kind < b.kind;
                   });
  return report;
}

}  // namespace luxel
