// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/light_diagnostics.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "luxel/core/none.h"
#include "luxel/session/words.h"

namespace luxel {
namespace {

constexpr double worth_telling = 0.001;   // of the light; less is not reported
constexpr double shut_in = 0.02;          // a lamp is enclosed if a smaller fraction escapes
constexpr std::size_t enough_paths = 64;  // minimum for that diagnostic

// The triangles of a material, and the largest of them.
struct MaterialPart {
  std::vector<std::uint32_t> triangles;
  std::uint32_t largest = 0;
  double area = 0.0;
};

MaterialPart part_of(const ScannedMesh& mesh, std::size_t material) {
  const auto& scene = *mesh.scene;
  MaterialPart part;
  double largest = -1.0;
  for (const auto& t : mesh.clean.kept) {
    if (static_cast<std::size_t>(scene.triangle_material[t.triangle]) != material) continue;
    const auto size = area(scene, t.triangle);
    part.triangles.push_back(t.triangle);
    part.area += size;
    if (size > largest) part.largest = t.triangle;
    largest = std::max(largest, size);
  }
  return part;
}

// Converts a patch's material to the scene's number: make_patches() appends two-sided twins.
std::size_t scene_material(const ScannedMesh& mesh, const PatchSet& patches, std::size_t material) {
  if (material < mesh.scene->materials.size()) return material;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (static_cast<std::size_t>(patches.material[p]) == material)
      return static_cast<std::size_t>(mesh.scene->triangle_material[patches.triangle[p]]);
  return 0;
}

Diagnostic lamp_diagnostic(const ScannedMesh& mesh, DiagnosticKind kind, std::size_t material,
                           std::string fact) {
  const auto part = part_of(mesh, material);
  Diagnostic diagnostic{kind, Severity::error, 1, std::move(fact)};
  diagnostic.triangles = part.triangles;
  tell_places(
      *mesh.scene, {{part.largest, centroid(*mesh.scene, part.largest), part.area}}, 1,
      [&](const Candidate& c) {
        return fmt::format("{}, {:.3g} m²", counted_things(part.triangles.size(), "triangle"), c.weight);
      },
      diagnostic);
  return diagnostic;
}

void find_no_lamp(const ScannedMesh& mesh, std::vector<Diagnostic>& diagnostics) {
  const bool is_under_sky = has_sky(*mesh.scene);
  Diagnostic diagnostic{DiagnosticKind::no_lamp, is_under_sky ? Severity::note : Severity::error, 1};
  diagnostic.fact =
      is_under_sky ? "no surface emits light: all of it comes from the sky" : "no surface emits light";
  diagnostic.consequence =
      is_under_sky ? "lights the scene by the sky alone" : "refuses to bake: all would be black";
  diagnostic.remedy = is_under_sky ? "a material with a Ke line is a lamp"
                                   : "a material with a Ke line is a lamp; a sky lights the scene";
  if (!is_under_sky) diagnostic.hints = {{Setting::sky, "1"}};
  diagnostics.push_back(std::move(diagnostic));
}

}  // namespace

void find_bad_lamps(const ScannedMesh& mesh, const PatchSet& patches, const std::vector<LampView>& views,
                    const LightWalks& walks, std::vector<Diagnostic>& diagnostics) {
  if (views.empty() && patches.point_lights.empty()) return find_no_lamp(mesh, diagnostics);
  for (const auto& view : views) {
    const auto material = scene_material(mesh, patches, view.material);
    const auto& name = mesh.scene->materials[material].name;
    const auto kind = judge(view);
    if (kind != LampFault::no_fault) {
      auto diagnostic = lamp_diagnostic(mesh,
                                        kind == LampFault::faces_wall ? DiagnosticKind::lamp_faces_wall
                                                                      : DiagnosticKind::lamp_lights_nothing,
                                        material, lamp_fact(patches, view));
      diagnostic.consequence = "solves it as it is: a lamp shines from the front of its faces alone";
      diagnostic.remedy = turning_helps(view)
                              ? "turn its faces round"
                              : "no setting helps: both of its sides look away from the scene";
      if (turning_helps(view)) diagnostic.hints = {{Setting::flip, name}};
      diagnostics.push_back(std::move(diagnostic));
      continue;
    }
    const auto paths = walks.set_out[view.material];
    const auto away = static_cast<double>(walks.got_away[view.material]) / static_cast<double>(paths);
    if (paths < enough_paths || away > shut_in) continue;
    auto diagnostic =
        lamp_diagnostic(mesh, DiagnosticKind::lamp_enclosed, material,
                        fmt::format("lamp '{}' is shut in: of {} paths of its light {} get farther than {}",
                                    name, with_commas(paths), away > 0.0 ? percent(away) : "none",
                                    in_metres(static_cast<double>(walks.near))));
    diagnostic.consequence = "lights the inside of what surrounds it, and nothing else";
    diagnostic.remedy =
        "give the cover 'd 0' in its MTL, and light passes freely; or turn the lamp round if it should shine "
        "outwards";
    diagnostic.hints = {{Setting::flip, name}};
    diagnostics.push_back(std::move(diagnostic));
  }
}

void find_misplaced_luminaires(const ScannedMesh& mesh, const PatchSet& patches, const Tracer& tracer,
                               std::size_t places, std::vector<Diagnostic>& diagnostics) {
  for (const auto& group : group_faults(patches, find_luminaire_faults(patches, tracer))) {
    const bool crosses = group.kind == LuminaireFault::Kind::crosses;
    Diagnostic diagnostic{DiagnosticKind::luminaire_misplaced, Severity::warning, group.faults.size(),
                          group.fact};
    diagnostic.consequence = crosses ? "loses the light that comes out on the other side of the surface"
                                     : "lets the surface hide the light of the opening";
    diagnostic.remedy = group.remedy;
    std::vector<Candidate> candidates;
    for (const auto& fault : group.faults)
      candidates.push_back({patches.triangle[fault.patch],
                            Vec3(patches.point_lights[fault.light].light.position), glm::length(fault.move)});
    tell_places(
        *mesh.scene, candidates, places,
        [](const Candidate& c) { return fmt::format("move it by {:.0f} mm", 1000.0 * c.weight); },
        diagnostic);
    diagnostics.push_back(std::move(diagnostic));
  }
}

namespace {

constexpr const char* directions[] = {"-x", "+x", "-y", "+y", "-z", "+z"};

std::string extent(const BoundaryLoop& loop) {
  auto size = std::array<float, 3>{loop.box.size().x, loop.box.size().y, loop.box.size().z};
  std::sort(size.begin(), size.end());
  return fmt::format("{} x {}", in_metres(static_cast<double>(size[2])),
                     in_metres(static_cast<double>(size[1])));
}

std::string describe(const ScannedMesh& mesh, const Opening& opening) {
  if (opening.loop == none)
    return fmt::format("{} past all surfaces towards {}", percent(opening.weight),
                       directions[opening.direction]);
  return fmt::format("{} through a hole of {}", percent(opening.weight), extent(mesh.loops[opening.loop]));
}

// A triangle that identifies the place: one on the loop, or the one nearest to where the rays left.
std::uint32_t triangle_near(const ScannedMesh& mesh, const Opening& opening) {
  if (opening.loop != none)
    return mesh.in_scene(mesh.edges.uses_of(mesh.loops[opening.loop].edges[0])[0].triangle);
  std::size_t best = 0;
  auto best2 = std::numeric_limits<float>::infinity();
  for (std::size_t t = 0; t < mesh.clean.kept.size(); ++t) {
    const auto d = mesh.points(t)[0] - opening.at;
    if (glm::dot(d, d) >= best2) continue;
    best2 = glm::dot(d, d);
    best = t;
  }
  return mesh.in_scene(best);
}

void find_escape(const ScannedMesh& mesh, const LightWalks& walks, const std::vector<Opening>& openings,
                 std::size_t places, std::vector<Diagnostic>& diagnostics) {
  if (walks.escaped < worth_telling) return;
  const bool from_lamps = walks.from == LightWalks::From::lamps;
  Diagnostic diagnostic{DiagnosticKind::escape, from_lamps ? Severity::warning : Severity::note};
  diagnostic.count = openings.size();
  diagnostic.fact =
      from_lamps
          ? fmt::format("{} (± {:.1g}) of the lamps' light leaves the scene, {} before it meets anything",
                        percent(walks.escaped), 100.0 * walks.escaped_error, percent(walks.escaped_at_once))
          : fmt::format("{} (± {:.1g}) of what can be seen from inside is open", percent(walks.escaped),
                        100.0 * walks.escaped_error);
  diagnostic.consequence = has_sky(*mesh.scene) ? "lets the light out there, and the sky's light in"
                           : from_lamps         ? "counts it as escaped; nothing comes back"
                                                : "lets no light in there without a sky";
  diagnostic.remedy = "close what should be closed in the file; welding closes gaps, and a sky lets light in";
  diagnostic.hints = {{Setting::weld, "DISTANCE"}, {Setting::sky, "1"}};
  std::vector<Candidate> candidates;
  for (std::uint32_t i = 0; i < openings.size(); ++i) {
    candidates.push_back({triangle_near(mesh, openings[i]), openings[i].at, openings[i].weight, i});
    if (openings[i].loop == none) continue;
    for (const auto e : mesh.loops[openings[i].loop].edges) diagnostic.edges.push_back(mesh.ends(e));
  }
  tell_places(
      *mesh.scene, candidates, places, [&](const Candidate& c) { return describe(mesh, openings[c.item]); },
      diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

}  // namespace

void find_lost_light(const ScannedMesh& mesh, const PatchSet& patches, const LightWalks& walks,
                     const std::vector<Opening>& openings, std::size_t places,
                     std::vector<Diagnostic>& diagnostics) {
  find_escape(mesh, walks, openings, places, diagnostics);
  if (walks.lost_at_backs < worth_telling) return;
  Diagnostic diagnostic{DiagnosticKind::lost_at_backs, Severity::error};
  std::vector<Candidate> candidates;
  for (std::uint32_t m = 0; m < walks.back_loss.size(); ++m) {
    if (walks.back_loss[m] == 0.0) continue;
    const auto part = part_of(mesh, scene_material(mesh, patches, m));
    if (part.triangles.empty()) continue;
    ++diagnostic.count;
    diagnostic.triangles.insert(diagnostic.triangles.end(), part.triangles.begin(), part.triangles.end());
    candidates.push_back({part.largest, centroid(*mesh.scene, part.largest), walks.back_loss[m]});
  }
  std::sort(diagnostic.triangles.begin(), diagnostic.triangles.end());
  diagnostic.fact =
      fmt::format("{} of the light falls on backs of {} and is lost", percent(walks.lost_at_backs),
                  counted_things(diagnostic.count, "one-sided material"));
  diagnostic.consequence = "lets such backs absorb all light, and counts it as lost at backs";
  diagnostic.remedy =
      "flip the material, or orient each component; where materials are two-sided nothing is lost";
  diagnostic.hints = {{Setting::flip, "NAME"}, {Setting::orient}, {Setting::one_sided}};
  tell_places(
      *mesh.scene, candidates, places, [](const Candidate& c) { return percent(c.weight) + " of the light"; },
      diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

void find_dark_surfaces(const ScannedMesh& mesh, const PatchSet& patches, const Unlit& unlit,
                        std::size_t places, std::vector<Diagnostic>& diagnostics) {
  if (unlit.patches.empty()) return;
  const auto& scene = *mesh.scene;
  // A triangle is dark if all its patches are.
  std::vector<std::uint32_t> patches_of(scene.triangles.size(), 0);
  for (const auto t : patches.triangle) ++patches_of[t];
  for (const auto p : unlit.patches) --patches_of[patches.triangle[p]];

  // Reported by connected parts of one group and one material, which a person sees as one thing.
  struct Part {
    std::uint32_t triangles = 0, largest = 0;
    double area = 0.0, max_area = -1.0;
  };
  std::map<std::array<std::uint32_t, 3>, Part> parts;
  Diagnostic diagnostic{DiagnosticKind::unlit, Severity::warning};
  double dark = 0.0;
  double all = 0.0;
  for (std::uint32_t t = 0; t < mesh.clean.kept.size(); ++t) {
    const auto size = mesh.area(t);
    all += size;
    const auto in_scene = mesh.in_scene(t);
    if (patches_of[in_scene] != 0 ||
        scene.materials[static_cast<std::size_t>(scene.triangle_material[in_scene])].is_lamp())
      continue;
    dark += size;
    diagnostic.triangles.push_back(in_scene);
    auto& part = parts[{mesh.components.of[t], scene.triangle_group[in_scene],
                        static_cast<std::uint32_t>(scene.triangle_material[in_scene])}];
    ++part.triangles;
    part.area += size;
    if (size > part.max_area) {
      part.max_area = size;
      part.largest = in_scene;
    }
  }
  if (diagnostic.triangles.empty()) return;
  diagnostic.count = diagnostic.triangles.size();
  std::vector<Candidate> candidates;
  for (const auto& [key, part] : parts)
    candidates.push_back({part.largest, centroid(scene, part.largest), part.area, part.triangles});
  diagnostic.fact = fmt::format("no light was found from {} ({:.3g} m², {} of the area) in {}",
                                counted_things(diagnostic.count, "triangle"), dark, percent(dark / all),
                                counted_things(candidates.size(), "part"));
  diagnostic.fact += fmt::format(", by {} random walks from each side: an estimate", unlit.walks);
  diagnostic.consequence = "leaves them black, on both sides";
  diagnostic.remedy =
      "nothing needs to change if they are hidden for good; else open what shuts them in, or flip its lamp";
  diagnostic.hints = {{Setting::flip, "NAME"}};
  tell_places(
      scene, candidates, places,
      [](const Candidate& c) {
        return fmt::format("{}, {:.3g} m²", counted_things(c.item, "triangle"), c.weight);
      },
      diagnostic);
  diagnostics.push_back(std::move(diagnostic));
}

}  // namespace luxel
