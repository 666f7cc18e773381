// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/scanned_mesh.h"

#include <algorithm>
#include <numeric>

#include "luxel/core/triangle.h"

namespace luxel {

std::array<Vec3, 3> ScannedMesh::points(std::size_t triangle) const {
  const auto& c = clean.kept[triangle].corners;
  return {places[c[0]], places[c[1]], places[c[2]]};
}

double ScannedMesh::area(std::size_t triangle) const {
  const auto p = points(triangle);
  return triangle_area(p[0], p[1], p[2]);
}

ScannedMesh scan_mesh(const Scene& scene, const Context& context, bool& is_whole) {
  ScannedMesh mesh;
  mesh.scene = &scene;
  is_whole = false;
  const auto stops = [&](double done) {
    return context.report({.stage = "mesh", .done = done}) == Next::stop;
  };
  if (stops(0.0)) return mesh;
  VertexWeld weld;
  mesh.clean = clean_triangles(scene, weld);
  mesh.places = weld.take();
  for (const auto& p : mesh.places) mesh.box.add(p);
  if (stops(0.35)) return mesh;
  mesh.edges = find_edges(mesh.clean.kept, mesh.places.size());
  if (stops(0.6)) return mesh;
  mesh.components = find_components(mesh.places, mesh.clean.kept, mesh.edges);
  if (stops(0.75)) return mesh;
  mesh.junctions = find_t_junctions(mesh.places, mesh.edges, rounding_distance(mesh.places));
  if (stops(0.95)) return mesh;
  mesh.loops = find_boundary_loops(mesh.places, mesh.edges, mesh.junctions);
  is_whole = !stops(1.0);
  return mesh;
}

Vec3 centroid(const Scene& scene, std::uint32_t triangle) {
  const auto& t = scene.triangles[triangle];
  return (scene.positions[t[0]] + scene.positions[t[1]] + scene.positions[t[2]]) / 3.0f;
}

double area(const Scene& scene, std::uint32_t triangle) {
  const auto& t = scene.triangles[triangle];
  return triangle_area(scene.positions[t[0]], scene.positions[t[1]], scene.positions[t[2]]);
}

void tell_places(const Scene& scene, const std::vector<Candidate>& candidates, std::size_t most,
                 const std::function<std::string(const Candidate&)>& detail, Diagnostic& diagnostic) {
  diagnostic.all_places = candidates.size();
  std::vector<std::uint32_t> order(candidates.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto count = static_cast<std::ptrdiff_t>(std::min(most, candidates.size()));
  std::partial_sort(order.begin(), order.begin() + count, order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const auto a = candidates[i].weight;
    const auto b = candidates[j].weight;
    return a != b ? a > b : i < j;
  });
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto& c = candidates[order[static_cast<std::size_t>(i)]];
    Place place;
    place.line = scene.triangle_line[c.triangle];
    place.group = scene.groups[scene.triangle_group[c.triangle]];
    if (!scene.objects.empty()) place.object = scene.objects[scene.triangle_object[c.triangle]];
    place.material = scene.materials[static_cast<std::size_t>(scene.triangle_material[c.triangle])].name;
    place.at = scene.origin + Vec3d(c.at);
    place.detail = detail(c);
    diagnostic.places.push_back(std::move(place));
  }
}

}  // namespace luxel
