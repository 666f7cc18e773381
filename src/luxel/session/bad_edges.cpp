// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "luxel/core/none.h"
#include "luxel/scene/orient_windings.h"
#include "luxel/scene/weld_vertices.h"
#include "luxel/session/mesh_diagnostics.h"
#include "luxel/session/words.h"

namespace luxel {
namespace {

bool is_lamp(const ScannedMesh& mesh, std::uint32_t triangle) {
  const auto& scene = *mesh.scene;
  return scene.materials[static_cast<std::size_t>(scene.triangle_material[mesh.in_scene(triangle)])]
      .is_lamp();
}

bool is_two_sided(const ScannedMesh& mesh, std::uint32_t triangle) {
  const auto& scene = *mesh.scene;
  return scene.materials[static_cast<std::size_t>(scene.triangle_material[mesh.in_scene(triangle)])]
      .two_sided;
}

Vec3 middle(const std::array<Vec3, 2>& edge) { return 0.5f * (edge[0] + edge[1]); }

double length(const std::array<Vec3, 2>& edge) { return glm::distance(Vec3d(edge[0]), Vec3d(edge[1])); }

void find_t_vertices(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  const auto& junctions = mesh.junctions.found;
  if (junctions.empty()) return;
  Diagnostic diagnostic{DiagnosticKind::t_junction, Severity::note, junctions.size()};
  std::vector<Candidate> candidates;
  for (std::size_t begin = 0, end = 0; begin < junctions.size(); begin = end) {
    const auto e = junctions[begin].edge;
    while (end < junctions.size() && junctions[end].edge == e) ++end;
    const auto triangle = mesh.in_scene(mesh.edges.uses_of(e)[0].triangle);
    const auto edge = mesh.ends(e);
    diagnostic.triangles.push_back(triangle);
    diagnostic.edges.push_back(edge);
    candidates.push_back({triangle, mesh.places[junctions[begin].vertex], length(edge),
                          static_cast<std::uint32_t>(end - begin)});
  }
  diagnostic.fact = junctions.size() == 1
                        ? "1 vertex lies inside an edge of a neighbour (a T-junction)"
                        : fmt::format("{} vertices lie inside edges of neighbours (T-junctions)",
                                      with_commas(junctions.size()));
  diagnostic.consequence =
      "loses no light there, but does not smooth the light across such an edge: it may show";
  diagnostic.remedy = "no setting changes that: split the long edge at the vertex in the file";
  tell_places(
      *mesh.scene, candidates, places,
      [](const Candidate& c) { return fmt::format("{} on an edge {} long", c.item, in_metres(c.weight)); },
      diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

// The effect of --weld on the open edges, found by welding only their ends.
struct WeldTrial {
  double distance = 0.0;   // m
  std::size_t closed = 0;  // open edges that would meet another one
};

std::size_t closed_by(const ScannedMesh& mesh, double distance) {
  std::vector<std::uint32_t> number(mesh.places.size(), none);
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 2>> open;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    if (!mesh.edges.is_open(e) || mesh.junctions.is_welded[e] != 0) continue;
    auto ends = mesh.edges.ends[e];
    for (auto& v : ends) {
      if (number[v] == none) {
        number[v] = static_cast<std::uint32_t>(points.size());
        points.push_back(mesh.places[v]);
      }
      v = number[v];
    }
    open.push_back(ends);
  }
  const auto goes_to = weld_points(points, distance);
  for (auto& [a, b] : open) {
    a = goes_to[a];
    b = goes_to[b];
    if (a > b) std::swap(a, b);
  }
  const auto collapsed = std::erase_if(open, [](const auto& ends) { return ends[0] == ends[1]; });
  std::sort(open.begin(), open.end());
  std::size_t closed = 0;
  for (std::size_t i = 0; i + 1 < open.size(); ++i)
    if (open[i] == open[i + 1]) closed += i > 0 && open[i] == open[i - 1] ? 1 : 2;
  return closed > 10 * collapsed ? closed : 0;  // a distance that destroys detail is no repair
}

// The shortest of a few distances that closes nearly as many as the longest: rounding of the file's digits,
// and a gap that is invisible to a modeller.
WeldTrial try_weld(const ScannedMesh& mesh) {
  const auto size = mesh.box.size();
  const auto extent = static_cast<double>(std::max({size.x, size.y, size.z}));
  // Rounds to one digit, as a user would type it.
  const auto one_digit = [](double x) { return std::stod(fmt::format("{:.0e}", x)); };
  WeldTrial best;
  for (const auto fraction : {1e-5, 1e-4, 1e-3}) {
    const auto distance = one_digit(fraction * extent);
    const auto closed = closed_by(mesh, distance);
    if (static_cast<double>(closed) > 1.1 * static_cast<double>(best.closed)) best = {distance, closed};
  }
  return best;
}

void find_open_edges(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  if (mesh.loops.empty()) return;
  Diagnostic diagnostic{DiagnosticKind::open_edge, Severity::note};
  std::vector<Candidate> candidates;
  for (const auto& loop : mesh.loops) {
    diagnostic.count += loop.edges.size();
    std::uint32_t longest = loop.edges[0];
    for (const auto e : loop.edges) {
      diagnostic.edges.push_back(mesh.ends(e));
      diagnostic.triangles.push_back(mesh.in_scene(mesh.edges.uses_of(e)[0].triangle));
      if (length(mesh.ends(e)) > length(mesh.ends(longest))) longest = e;
    }
    candidates.push_back({mesh.in_scene(mesh.edges.uses_of(longest)[0].triangle), middle(mesh.ends(longest)),
                          loop.length, static_cast<std::uint32_t>(loop.edges.size())});
  }
  std::sort(diagnostic.triangles.begin(), diagnostic.triangles.end());
  diagnostic.triangles.erase(std::unique(diagnostic.triangles.begin(), diagnostic.triangles.end()),
                             diagnostic.triangles.end());
  const auto weld = try_weld(mesh);
  diagnostic.fact = fmt::format("{} open, in {}: surfaces end there", counted_is(diagnostic.count, "edge"),
                                counted_things(mesh.loops.size(), "boundary loop"));
  if (weld.closed > 0)
    diagnostic.fact += fmt::format(", and {} of them lie so near another one that a gap is likely",
                                   with_commas(weld.closed));
  if (weld.closed > 0) diagnostic.severity = Severity::warning;
  diagnostic.consequence =
      "takes such surfaces as sheets, lit on both sides; light passes around their boundary and through gaps";
  diagnostic.remedy = weld.closed > 0
                          ? fmt::format("welding closes {} of them", with_commas(weld.closed))
                          : "nothing needs to change where sheets are meant; backs can be made to absorb";
  diagnostic.hints = {weld.closed > 0 ? Hint{Setting::weld, fmt::format("{:g}", weld.distance)}
                                      : Hint{Setting::one_sided, "NAME"}};
  tell_places(
      *mesh.scene, candidates, places,
      [](const Candidate& c) {
        return fmt::format("a boundary loop of {}, {} in all", counted_things(c.item, "edge"),
                           in_metres(c.weight));
      },
      diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

void find_non_manifold_edges(const ScannedMesh& mesh, std::size_t places,
                             std::vector<Diagnostic>& diagnostics) {
  Diagnostic diagnostic{DiagnosticKind::non_manifold_edge, Severity::note};
  std::vector<Candidate> candidates;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto uses = mesh.edges.uses_of(e);
    if (uses.size() < 3) continue;
    const auto edge = mesh.ends(e);
    diagnostic.edges.push_back(edge);
    for (const auto& use : uses) diagnostic.triangles.push_back(mesh.in_scene(use.triangle));
    candidates.push_back({mesh.in_scene(uses[0].triangle), middle(edge), length(edge),
                          static_cast<std::uint32_t>(uses.size())});
  }
  if (diagnostic.edges.empty()) return;
  std::sort(diagnostic.triangles.begin(), diagnostic.triangles.end());
  diagnostic.triangles.erase(std::unique(diagnostic.triangles.begin(), diagnostic.triangles.end()),
                             diagnostic.triangles.end());
  diagnostic.count = diagnostic.edges.size();
  diagnostic.fact = fmt::format("{} more than two triangles", counted_have(diagnostic.count, "edge"));
  diagnostic.consequence = "takes the surfaces as they are; orientation does not carry over such an edge";
  diagnostic.remedy = "nothing needs to change: walls that meet a floor along its edges look like this";
  tell_places(
      *mesh.scene, candidates, places,
      [](const Candidate& c) { return fmt::format("{} triangles, {} long", c.item, in_metres(c.weight)); },
      diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

// Neighbours that face opposite ways, found by what --orient would flip.
void find_windings(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  std::vector<std::size_t> inconsistent;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (mesh.edges.winds_inconsistently(e)) inconsistent.push_back(e);
  if (inconsistent.empty()) return;
  Diagnostic diagnostic{DiagnosticKind::windings, Severity::note, inconsistent.size()};
  Diagnostic lamps{DiagnosticKind::lamp_windings, Severity::error};
  std::vector<Candidate> candidates, lamp_candidates;
  std::size_t one_sided = 0;
  for (const auto e : inconsistent) {
    const auto uses = mesh.edges.uses_of(e);
    const auto edge = mesh.ends(e);
    const Candidate candidate{mesh.in_scene(uses[1].triangle), middle(edge), length(edge)};
    candidates.push_back(candidate);
    diagnostic.edges.push_back(edge);
    if (!is_two_sided(mesh, uses[0].triangle) || !is_two_sided(mesh, uses[1].triangle)) ++one_sided;
    if (!is_lamp(mesh, uses[0].triangle) || !is_lamp(mesh, uses[1].triangle)) continue;
    lamp_candidates.push_back(candidate);
    lamps.edges.push_back(edge);
    for (const auto& use : uses) lamps.triangles.push_back(mesh.in_scene(use.triangle));
  }
  const auto plan = plan_windings(*mesh.scene, mesh.places, mesh.clean.kept, mesh.components);
  std::size_t components = 0;
  for (const auto& component : mesh.components.components) components += component.is_consistent() ? 0 : 1;
  for (std::size_t t = 0; t < mesh.clean.kept.size(); ++t)
    if (plan.turn[t] != 0 && !mesh.components.components[mesh.components.of[t]].is_consistent())
      diagnostic.triangles.push_back(mesh.in_scene(static_cast<std::uint32_t>(t)));
  diagnostic.severity = one_sided > 0 ? Severity::error : Severity::note;
  diagnostic.fact = fmt::format("{} between neighbours that face opposite ways, in {} of {}",
                                counted_lie(inconsistent.size(), "edge"), with_commas(components),
                                counted_things(mesh.components.components.size(), "connected component"));
  if (plan.not_orientable > 0)
    diagnostic.fact += fmt::format("; {} of these no winding makes consistent (as a Moebius strip)",
                                   with_commas(plan.not_orientable));
  diagnostic.consequence =
      one_sided > 0
          ? "lets the backs of one-sided materials absorb, so these components darken in patches"
          : "lights both sides alike, so the light is the same; view factors and one-sided materials do look";
  diagnostic.remedy = fmt::format("orientation turns {} round", counted_things(plan.turned, "triangle"));
  diagnostic.hints = {{Setting::orient}};
  const auto detail = [](const Candidate& c) { return fmt::format("an edge {} long", in_metres(c.weight)); };
  tell_places(*mesh.scene, candidates, places, detail, diagnostic);
  diagnostics.push_back(std::move(diagnostic));

  if (lamps.edges.empty()) return;
  std::sort(lamps.triangles.begin(), lamps.triangles.end());
  lamps.triangles.erase(std::unique(lamps.triangles.begin(), lamps.triangles.end()), lamps.triangles.end());
  lamps.count = lamps.edges.size();
  lamps.fact =
      fmt::format("{} between parts of a lamp that face opposite ways: one of them shines to the wrong side",
                  counted_lie(lamps.count, "edge"));
  lamps.consequence = "lets each part shine from its own front";
  lamps.remedy = "no setting turns a part of a lamp: turn these faces round in the file";
  tell_places(*mesh.scene, lamp_candidates, places, detail, lamps);
  diagnostics.push_back(std::move(lamps));
}

}  // namespace

void find_bad_edges(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  find_windings(mesh, places, diagnostics);
  find_t_vertices(mesh, places, diagnostics);
  find_open_edges(mesh, places, diagnostics);
  find_non_manifold_edges(mesh, places, diagnostics);
}

}  // namespace luxel
