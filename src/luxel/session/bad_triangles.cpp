// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "luxel/patch/overlaps.h"
#include "luxel/patch/set_bands.h"
#include "luxel/scene/triangle_shape.h"
#include "luxel/session/mesh_diagnostics.h"
#include "luxel/session/words.h"

namespace luxel {
namespace {

constexpr double thin = 100.0;  // ratio of length to height above which a triangle is a sliver

// The longest edge represents a triangle without area.
std::array<Vec3, 2> longest_edge(const Scene& scene, std::uint32_t triangle) {
  const auto& t = scene.triangles[triangle];
  std::array<Vec3, 2> longest = {scene.positions[t[0]], scene.positions[t[1]]};
  for (std::size_t k = 1; k < 3; ++k) {
    const std::array<Vec3, 2> edge = {scene.positions[t[k]], scene.positions[t[(k + 1) % 3]]};
    if (glm::distance(Vec3d(edge[0]), Vec3d(edge[1])) > glm::distance(Vec3d(longest[0]), Vec3d(longest[1])))
      longest = edge;
  }
  return longest;
}

void find_no_area(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  const auto& scene = *mesh.scene;
  const auto& triangles = mesh.clean.without_area;
  if (triangles.empty()) return;
  Diagnostic diagnostic{DiagnosticKind::no_area, Severity::note, triangles.size()};
  std::vector<Candidate> candidates;
  for (const auto t : triangles) {
    const auto edge = longest_edge(scene, t);
    const auto length = glm::distance(Vec3d(edge[0]), Vec3d(edge[1]));
    diagnostic.edges.push_back(edge);
    candidates.push_back({t, 0.5f * (edge[0] + edge[1]), length});
  }
  diagnostic.triangles = triangles;
  diagnostic.fact =
      fmt::format("{} no area: {} corners lie on one line or in one place",
                  counted_have(triangles.size(), "triangle"), triangles.size() == 1 ? "its" : "their");
  diagnostic.consequence = "leaves them out; no light is lost, but the vertices they joined no longer meet";
  if (mesh.clean.kept.empty()) {
    diagnostic.severity = Severity::error;
    diagnostic.consequence = "refuses to bake: there is nothing else to light";
  }
  diagnostic.remedy =
      "nothing needs to change; if an open edge or a T-junction stays in their place, welding may close it";
  diagnostic.hints = {{Setting::weld, "DISTANCE"}};
  tell_places(
      scene, candidates, places, [](const Candidate& c) { return in_metres(c.weight) + " long"; },
      diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

void find_twins(const ScannedMesh& mesh, bool opposite, std::size_t places,
                std::vector<Diagnostic>& diagnostics) {
  const auto& scene = *mesh.scene;
  Diagnostic diagnostic{opposite ? DiagnosticKind::opposite : DiagnosticKind::duplicate, Severity::note};
  std::vector<Candidate> candidates;
  std::size_t other_material = 0;
  for (const auto& twin : mesh.clean.twins) {
    if (twin.is_opposite != opposite) continue;
    const auto kept = mesh.in_scene(twin.kept);
    diagnostic.triangles.push_back(twin.triangle);
    if (scene.triangle_material[twin.triangle] != scene.triangle_material[kept]) ++other_material;
    candidates.push_back({twin.triangle, centroid(scene, twin.triangle), area(scene, twin.triangle), kept});
  }
  if (diagnostic.triangles.empty()) return;
  diagnostic.count = diagnostic.triangles.size();
  diagnostic.fact =
      fmt::format("{} exactly on another one, facing {}", counted_lie(diagnostic.count, "triangle"),
                  opposite ? "the other way" : "the same way");
  if (other_material > 0) {
    diagnostic.severity = Severity::warning;
    diagnostic.fact +=
        fmt::format("; {} of another material than the one below", counted_are(other_material));
  }
  diagnostic.consequence =
      opposite ? "keeps one of each pile (the lamp, else the first of the file), lit on both sides"
               : "keeps one of each pile: the lamp, else the first of the file";
  diagnostic.remedy = "no setting changes that: delete the copies that are not wanted in the file";
  tell_places(
      scene, candidates, places, [&](const Candidate& c) { return lies_on(scene, c.item); }, diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

void find_overlapping(const ScannedMesh& mesh, const Context& context, std::size_t places,
                      std::vector<Diagnostic>& diagnostics) {
  const auto& scene = *mesh.scene;
  PatchSet bands;
  set_bands(bands, scene);
  std::vector<MaterialId> material;
  for (std::uint32_t t = 0; t < mesh.clean.kept.size(); ++t)
    material.push_back(scene.triangle_material[mesh.in_scene(t)]);
  const auto overlaps = find_overlaps(mesh.clean.kept, material, bands.materials, mesh.places, context);
  std::map<std::uint32_t, std::uint32_t> on;  // [triangle of the scene that covers]: one that it covers
  for (const auto& o : overlaps) on.try_emplace(mesh.in_scene(o.cover), mesh.in_scene(o.covered));
  if (on.empty()) return;
  Diagnostic diagnostic{DiagnosticKind::overlap, Severity::note, on.size()};
  std::vector<Candidate> candidates;
  for (const auto& [cover, covered] : on) {
    diagnostic.triangles.push_back(cover);
    candidates.push_back({cover, centroid(scene, cover), area(scene, cover), covered});
  }
  diagnostic.fact =
      fmt::format("{} on larger surfaces in the same plane", counted_lie(on.size(), "triangle"));
  diagnostic.consequence = "leaves out what they cover: rays could not tell which one is in front";
  diagnostic.remedy = "nothing needs to change where things stand on each other; otherwise move them apart";
  tell_places(
      scene, candidates, places, [&](const Candidate& c) { return lies_on(scene, c.item); }, diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

void find_slivers(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  const auto& scene = *mesh.scene;
  Diagnostic diagnostic{DiagnosticKind::sliver, Severity::note};
  std::vector<Candidate> candidates;
  double all = 0.0;
  double slivers = 0.0;
  double worst = 0.0;
  for (std::uint32_t t = 0; t < mesh.clean.kept.size(); ++t) {
    const auto p = mesh.points(t);
    const auto size = mesh.area(t);
    const auto ratio = slenderness(p[0], p[1], p[2]);
    all += size;
    if (ratio < thin) continue;
    slivers += size;
    worst = std::max(worst, ratio);
    diagnostic.triangles.push_back(mesh.in_scene(t));
    candidates.push_back({mesh.in_scene(t), centroid(scene, mesh.in_scene(t)), size, t});
  }
  if (diagnostic.triangles.empty()) return;
  diagnostic.count = diagnostic.triangles.size();
  diagnostic.fact =
      fmt::format("{} more than {:g} times as long as high (up to {}), {} of the area",
                  counted_is(diagnostic.count, "triangle"), thin, rounded(worst), percent(slivers / all));
  diagnostic.consequence =
      "cuts them as it cuts all others; on each thin part the light is one mean along its length";
  diagnostic.remedy = "a shorter edge makes the parts shorter";
  diagnostic.hints = {{Setting::max_edge}};
  tell_places(
      scene, candidates, places,
      [&](const Candidate& c) {
        const auto p = mesh.points(c.item);
        return fmt::format("{} times as long as high", rounded(slenderness(p[0], p[1], p[2])));
      },
      diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

}  // namespace

void find_bad_triangles(const ScannedMesh& mesh, const Context& context, std::size_t places,
                        std::vector<Diagnostic>& diagnostics) {
  find_twins(mesh, true, places, diagnostics);
  find_twins(mesh, false, places, diagnostics);
  find_overlapping(mesh, context, places, diagnostics);
  find_no_area(mesh, places, diagnostics);
  find_slivers(mesh, places, diagnostics);
}

}  // namespace luxel
