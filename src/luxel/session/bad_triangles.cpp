// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/scene/triangle_shape.h"
#include "luxel/session/mesh_findings.h"
#include "luxel/session/words.h"

namespace luxel {
namespace {

constexpr double thin = 100.0;  // a triangle this much longer than high is a sliver

// The middle of a triangle without area: that of its longest edge.
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

void find_no_area(const ScannedMesh& mesh, std::size_t places, std::vector<Finding>& findings) {
  const auto& scene = *mesh.scene;
  const auto& triangles = mesh.clean.without_area;
  if (triangles.empty()) return;
  Finding finding{FindingKind::no_area, Gravity::note, triangles.size()};
  std::vector<Candidate> candidates;
  for (const auto t : triangles) {
    const auto edge = longest_edge(scene, t);
    const auto length = glm::distance(Vec3d(edge[0]), Vec3d(edge[1]));
    finding.edges.push_back(edge);
    candidates.push_back({t, 0.5f * (edge[0] + edge[1]), length});
  }
  finding.triangles = triangles;
  finding.fact =
      fmt::format("{} no area: {} corners lie on one line or in one place",
                  counted_have(triangles.size(), "triangle"), triangles.size() == 1 ? "its" : "their");
  finding.consequence = "leaves them out; no light is lost, but the vertices they joined no longer meet";
  if (mesh.clean.kept.empty()) {
    finding.gravity = Gravity::fault;
    finding.consequence = "refuses to bake: there is nothing else to light";
  }
  finding.remedy =
      "no flag needed; if an open edge or a T-junction stays in their place, --weld may close it";
  tell_places(
      scene, candidates, places, [](const Candidate& c) { return in_metres(c.weight) + " long"; }, finding);
  findings.push_back(std::move(finding));
}

void find_twins(const ScannedMesh& mesh, bool opposite, std::size_t places, std::vector<Finding>& findings) {
  const auto& scene = *mesh.scene;
  Finding finding{opposite ? FindingKind::opposite : FindingKind::duplicate, Gravity::note};
  std::vector<Candidate> candidates;
  std::size_t other_material = 0;
  for (const auto& twin : mesh.clean.twins) {
    if (twin.is_opposite != opposite) continue;
    const auto kept = mesh.in_scene(twin.kept);
    finding.triangles.push_back(twin.triangle);
    if (scene.triangle_material[twin.triangle] != scene.triangle_material[kept]) ++other_material;
    candidates.push_back({twin.triangle, centroid(scene, twin.triangle), area(scene, twin.triangle), kept});
  }
  if (finding.triangles.empty()) return;
  finding.count = finding.triangles.size();
  finding.fact = fmt::format("{} exactly on another one, facing {}", counted_lie(finding.count, "triangle"),
                             opposite ? "the other way" : "the same way");
  if (other_material > 0) {
    finding.gravity = Gravity::doubt;
    finding.fact += fmt::format("; {} of another material than the one below", counted_are(other_material));
  }
  finding.consequence =
      opposite ? "keeps one of each pile (the lamp, else the first of the file), lit on both sides"
               : "keeps one of each pile: the lamp, else the first of the file";
  finding.remedy = "no flag changes that: delete the copies that are not wanted in the file";
  tell_places(
      scene, candidates, places, [&](const Candidate& c) { return lies_on(scene, c.item); }, finding);
  findings.push_back(std::move(finding));
}

void find_slivers(const ScannedMesh& mesh, std::size_t places, std::vector<Finding>& findings) {
  const auto& scene = *mesh.scene;
  Finding finding{FindingKind::sliver, Gravity::note};
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
    finding.triangles.push_back(mesh.in_scene(t));
    candidates.push_back({mesh.in_scene(t), centroid(scene, mesh.in_scene(t)), size, t});
  }
  if (finding.triangles.empty()) return;
  finding.count = finding.triangles.size();
  finding.fact =
      fmt::format("{} more than {:g} times as long as high (up to {}), {} of the area",
                  counted_is(finding.count, "triangle"), thin, rounded(worst), percent(slivers / all));
  finding.consequence =
      "cuts them as it cuts all others; on each thin part the light is one mean along its length";
  finding.remedy = "--max-edge makes the parts shorter";
  tell_places(
      scene, candidates, places,
      [&](const Candidate& c) {
        const auto p = mesh.points(c.item);
        return fmt::format("{} times as long as high", rounded(slenderness(p[0], p[1], p[2])));
      },
      finding);
  findings.push_back(std::move(finding));
}

}  // namespace

void find_bad_triangles(const ScannedMesh& mesh, std::size_t places, std::vector<Finding>& findings) {
  find_twins(mesh, true, places, findings);
  find_twins(mesh, false, places, findings);
  find_no_area(mesh, places, findings);
  find_slivers(mesh, places, findings);
}

}  // namespace luxel
