// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/glass_diagnostics.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "luxel/core/ending_of.h"
#include "luxel/patch/make_panes.h"
#include "luxel/scene/glass_names.h"
#include "luxel/session/words.h"
#include "luxel/trace/tracer.h"

namespace luxel {
namespace {

constexpr float doubled = 1e-3f;  // m: sheets nearer than this are probably one

const Material& material_of(const Scene& scene, std::uint32_t triangle) {
  return scene.materials[static_cast<std::size_t>(scene.triangle_material[triangle])];
}

bool is_lit_from_outside(const Scene& scene) {
  return has_sky(scene) ||
         std::any_of(scene.point_lights.begin(), scene.point_lights.end(),
                     [](const PointLight& light) { return light.kind == PointLightKind::directional; });
}

// The openings of luminaires, which OBJ files name after photometric files, let light pass as well.
bool is_opening(const Material& material) {
  const auto ending = ending_of(material.name);
  return ending == ".ies" || ending == ".ldt";
}

// Reports materials: their triangles, the largest of each as its place.
void tell_materials(const Scene& scene, const std::vector<std::uint32_t>& triangles, std::size_t places,
                    Diagnostic& diagnostic) {
  struct Part {
    std::uint32_t largest = 0, count = 0;
    double area = 0.0, max_area = -1.0;
  };
  std::map<MaterialId, Part> parts;
  for (const auto t : triangles) {
    auto& part = parts[scene.triangle_material[t]];
    const auto size = area(scene, t);
    ++part.count;
    part.area += size;
    if (size > part.max_area) {
      part.max_area = size;
      part.largest = t;
    }
  }
  diagnostic.count = parts.size();
  diagnostic.triangles = triangles;
  std::vector<Candidate> candidates;
  for (const auto& [material, part] : parts)
    candidates.push_back({part.largest, centroid(scene, part.largest), part.area, part.count});
  tell_places(
      scene, candidates, places,
      [](const Candidate& c) {
        return fmt::format("{}, {:.3g} m²", counted_things(c.item, "triangle"), c.weight);
      },
      diagnostic);
}

std::string names_of(const Scene& scene, const std::vector<std::uint32_t>& triangles) {
  return material_of(scene, triangles.front()).name;
}

void find_opaque_glass(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  const auto& scene = *mesh.scene;
  std::vector<std::uint32_t> triangles;
  for (const auto& t : mesh.clean.kept) {
    const auto& material = material_of(scene, t.triangle);
    if (!material.is_lamp() && !material.is_diffuser() && is_glass_name(material.name))
      triangles.push_back(t.triangle);
  }
  if (triangles.empty()) return;
  Diagnostic diagnostic{DiagnosticKind::opaque_glass,
                        is_lit_from_outside(scene) ? Severity::warning : Severity::note};
  tell_materials(scene, triangles, places, diagnostic);
  diagnostic.fact = fmt::format("{} called glass, but opaque", counted_is(diagnostic.count, "material"));
  diagnostic.consequence = "treats its surfaces as walls: no light passes through them";
  diagnostic.remedy = "a transmittance makes a material a pane of glass";
  diagnostic.hints = {{Setting::glass, names_of(scene, triangles) + "=0.8"}};
  diagnostics.push_back(std::move(diagnostic));
}

void find_clear_panes(const ScannedMesh& mesh, const std::vector<GlassTriangle>& glass, std::size_t places,
                      std::vector<Diagnostic>& diagnostics) {
  const auto& scene = *mesh.scene;
  if (!is_lit_from_outside(scene)) return;
  std::vector<std::uint32_t> triangles;
  for (const auto& g : glass) {
    const auto& material = material_of(scene, g.triangle);
    if (material.transmittance == Vec3(1.0f) && !is_opening(material)) triangles.push_back(g.triangle);
  }
  if (triangles.empty()) return;
  Diagnostic diagnostic{DiagnosticKind::clear_panes, Severity::warning};
  tell_materials(scene, triangles, places, diagnostic);
  diagnostic.fact =
      fmt::format("{} {} all light pass, as if there were no glass",
                  counted_things(diagnostic.count, "material"), diagnostic.count == 1 ? "lets" : "let");
  diagnostic.consequence = "brings in about a quarter more daylight than double glazing does";
  diagnostic.remedy =
      "give the panes their transmittance, about 0.9 for one sheet of clear glass and 0.8 for two";
  diagnostic.hints = {{Setting::glass, names_of(scene, triangles) + "=0.8"}};
  diagnostics.push_back(std::move(diagnostic));
}

// Adds a triangle with corners of its own to bare geometry, which a tracer takes.
void add_bare(const Scene& scene, std::uint32_t triangle, PatchSet& bare) {
  const auto first = static_cast<std::uint32_t>(bare.vertices.size());
  for (const auto v : scene.triangles[triangle]) bare.vertices.push_back(scene.positions[v]);
  bare.corners.push_back({first, first + 1, first + 2});
}

// A warning about triangles that lie so close to something else.
Diagnostic too_close(DiagnosticKind kind, const Scene& scene, const std::vector<std::uint32_t>& triangles,
                     std::size_t places) {
  Diagnostic diagnostic{kind, Severity::warning};
  tell_materials(scene, triangles, places, diagnostic);
  diagnostic.count = triangles.size();
  return diagnostic;
}

// Looks along the normals of sheets for another one nearby.
class NearSheets {
 public:
  NearSheets(const Scene& scene, const std::vector<GlassTriangle>& glass, const Context& context) {
    PatchSet triangles;  // bare geometry
    for (const auto& g : glass) {
      if (g.body != GlassBody::sheet || material_of(scene, g.triangle).transmittance == Vec3(1.0f)) continue;
      add_bare(scene, g.triangle, triangles);
      sheets_.push_back(g);
    }
    if (!sheets_.empty()) tracer_.emplace(triangles, context);
    corners_ = std::move(triangles.vertices);
  }

  // Triangles with another object within a millimetre before or behind their centre.
  std::vector<std::uint32_t> find() const {
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < sheets_.size(); ++i)
      if (is_doubled(i)) found.push_back(sheets_[i].triangle);
    return found;
  }

 private:
  bool is_doubled(std::size_t i) const {
    const auto centre = (corners_[3 * i] + corners_[3 * i + 1] + corners_[3 * i + 2]) / 3.0f;
    const Vec3 axis(sheets_[i].axis);
    for (const auto& direction : {axis, -axis}) {
      const auto hit = tracer_->nearest({centre - doubled * direction, direction});
      if (hit && hit.distance < doubled && sheets_[hit.patch].object != sheets_[i].object) return true;
    }
    return false;
  }

  std::vector<GlassTriangle> sheets_;
  std::vector<Vec3> corners_;  // [3 * sheet + corner], m
  std::optional<Tracer> tracer_;
};

void find_doubled_panes(const ScannedMesh& mesh, const std::vector<GlassTriangle>& glass,
                        const Context& context, std::size_t places, std::vector<Diagnostic>& diagnostics) {
  const auto triangles = NearSheets(*mesh.scene, glass, context).find();
  if (triangles.empty()) return;
  auto diagnostic = too_close(DiagnosticKind::doubled_panes, *mesh.scene, triangles, places);
  diagnostic.fact =
      fmt::format("{} within 1 mm of another sheet", counted_lie(triangles.size(), "glass triangle"));
  diagnostic.consequence = "lets each sheet absorb its part, so that such a pane absorbs twice";
  diagnostic.remedy = "remove one of the two sheets in the file, or give each the root of the transmittance";
  diagnostic.hints = {{Setting::glass, "NAME=0.9"}};
  diagnostics.push_back(std::move(diagnostic));
}

// Triangles of diffusers with a surface of another kind within a millimetre before or behind their centre.
std::vector<std::uint32_t> covered_diffusers(const ScannedMesh& mesh, const Context& context) {
  const auto& scene = *mesh.scene;
  PatchSet others;  // bare geometry
  std::vector<std::uint32_t> diffusers, covered;
  for (const auto& t : mesh.clean.kept) {
    const auto& material = material_of(scene, t.triangle);
    if (material.is_diffuser()) diffusers.push_back(t.triangle);
    if (!material.opaque || material.is_diffuser()) continue;
    add_bare(scene, t.triangle, others);
  }
  if (diffusers.empty() || others.corners.empty()) return {};
  const Tracer tracer(others, context);
  for (const auto t : diffusers) {
    const auto& c = scene.triangles[t];
    const auto &p = scene.positions[c[0]], &q = scene.positions[c[1]], &r = scene.positions[c[2]];
    const auto axis = glm::normalize(glm::cross(q - p, r - p));
    const auto hit = tracer.nearest({(p + q + r) / 3.0f - doubled * axis, axis});
    if (hit && hit.distance < 2.0f * doubled) covered.push_back(t);
  }
  return covered;
}

void find_covered_diffusers(const ScannedMesh& mesh, const Context& context, std::size_t places,
                            std::vector<Diagnostic>& diagnostics) {
  const auto triangles = covered_diffusers(mesh, context);
  if (triangles.empty()) return;
  auto diagnostic = too_close(DiagnosticKind::covered_diffuser, *mesh.scene, triangles, places);
  diagnostic.fact =
      fmt::format("{} within 1 mm of a surface", counted_lie(triangles.size(), "diffuser triangle"));
  diagnostic.consequence = "lets the light that they transmit end at that surface";
  diagnostic.remedy = "open the wall behind the diffuser in the file, or move the two apart";
  diagnostics.push_back(std::move(diagnostic));
}

}  // namespace

void find_bad_glass(const ScannedMesh& mesh, const Context& context, std::size_t places,
                    std::vector<Diagnostic>& diagnostics) {
  find_opaque_glass(mesh, places, diagnostics);
  find_covered_diffusers(mesh, context, places, diagnostics);
  const auto glass = find_glass(*mesh.scene);
  if (glass.empty()) return;
  find_clear_panes(mesh, glass, places, diagnostics);
  find_doubled_panes(mesh, glass, context, places, diagnostics);
}

}  // namespace luxel
