// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/none.h"
#include "luxel/scene/scale_doubt.h"
#include "luxel/session/mesh_diagnostics.h"
#include "luxel/session/words.h"

namespace luxel {
namespace {

void find_reflectances(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  const auto& scene = *mesh.scene;
  Diagnostic diagnostic{DiagnosticKind::reflectance, Severity::note};
  std::vector<Candidate> candidates;
  std::vector<std::uint32_t> first(scene.materials.size(), none);
  std::vector<double> size(scene.materials.size(), 0.0);
  for (const auto& t : mesh.clean.kept) {
    const auto m = static_cast<std::size_t>(scene.triangle_material[t.triangle]);
    if (!scene.materials[m].stated_reflectance) continue;
    if (size[m] == 0.0) first[m] = t.triangle;
    size[m] += area(scene, t.triangle);
    diagnostic.triangles.push_back(t.triangle);
  }
  float highest = 0.0f;
  float lowered_to = 0.0f;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (size[m] == 0.0) continue;
    const auto& said = *scene.materials[m].stated_reflectance;
    const auto& taken = scene.materials[m].reflectance;
    highest = std::max({highest, said.r, said.g, said.b});
    lowered_to = std::max({lowered_to, taken.r, taken.g, taken.b});
    ++diagnostic.count;
    candidates.push_back({first[m], centroid(scene, first[m]), size[m], static_cast<std::uint32_t>(m)});
  }
  if (diagnostic.count == 0) return;
  if (highest >= 1.0f) diagnostic.severity = Severity::warning;
  const auto reflect = fmt::format("{} {}", counted_things(diagnostic.count, "material"),
                                   diagnostic.count == 1 ? "reflects" : "reflect");
  diagnostic.fact = highest >= 1.0f ? fmt::format("{} as much light as they receive, or more (up to {:.3g})",
                                                  reflect, highest)
                                    : fmt::format("{} nearly all light (up to {:.3g})", reflect, highest);
  diagnostic.consequence = fmt::format("lowers it to {:.3g} in each band that exceeds it", lowered_to);
  diagnostic.remedy = "the file's Kd is probably too bright; another bound can be set";
  diagnostic.hints = {{Setting::reflectance_limit}};
  tell_places(
      scene, candidates, places,
      [&](const Candidate& c) {
        const auto& said = *scene.materials[c.item].stated_reflectance;
        return fmt::format("the file says {:.3g} {:.3g} {:.3g}, on {:.3g} m²", said.r, said.g, said.b,
                           c.weight);
      },
      diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

void find_units(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  if (mesh.clean.kept.empty()) return;
  const auto size = mesh.box.size();
  const auto doubt = doubt_scale(*mesh.scene);
  if (!doubt) return;
  Diagnostic diagnostic{DiagnosticKind::units, Severity::warning, 1};
  diagnostic.fact = fmt::format("the scene is {} long: {}", in_metres(doubt->extent),
                                doubt->is_large ? "too large for a room" : "too small for a room");
  diagnostic.consequence =
      "takes coordinates as metres: lumens and the size of patches go by that, light per m² and pictures do "
      "not";
  diagnostic.remedy = fmt::format("if these are {}, a scale of {:g} makes it {} long", doubt->unit,
                                  doubt->metres, in_metres(doubt->extent * doubt->metres));
  diagnostic.hints = {{Setting::scale, fmt::format("{:g}", doubt->metres)}};
  tell_places(
      *mesh.scene, {{mesh.in_scene(0), mesh.box.center()}}, places,
      [&](const Candidate&) {
        return fmt::format("the middle of {} x {} x {}", in_metres(size.x), in_metres(size.y),
                           in_metres(size.z));
      },
      diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

}  // namespace

void find_bad_numbers(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  find_reflectances(mesh, places, diagnostics);
  find_units(mesh, places, diagnostics);
}

}  // namespace luxel
