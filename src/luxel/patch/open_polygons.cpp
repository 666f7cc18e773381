// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/open_polygons.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "luxel/core/disjoint_sets.h"
#include "luxel/core/triangle.h"
#include "luxel/scene/clean_triangles.h"
#include "luxel/scene/edges.h"

namespace luxel {
namespace {

constexpr double plane_tolerance = 2e-4;  // of the extent: how far apart triangles of one pane may lie
constexpr double narrow_side = 0.1;       // area, relative to the largest face of the same glass object
constexpr double rim_flatness = 0.02;     // of a loop's extent: maximum distance of its corners from a plane
constexpr double parallel =
    0.9;  // cosine: above it, a triangle lies in the plane of the loop at which it ends

Triangle3 triangle_of(const Scene& scene, std::size_t t) {
  const auto& c = scene.triangles[t];
  return {scene.positions[c[0]], scene.positions[c[1]], scene.positions[c[2]]};
}

OpenPolygon in_space(const FlatFrame& frame, std::span<const std::array<double, 2>> polygon) {
  OpenPolygon corners;
  for (const auto& p : polygon) corners.push_back(frame.in_space(p));
  return corners;
}

double area_of(const OpenPolygon& polygon) {
  Vec3d area2(0.0);
  for (std::size_t i = 2; i < polygon.size(); ++i)
    area2 += area_vector2(polygon[0], polygon[i - 1], polygon[i]);
  return 0.5 * glm::length(area2);
}

// The convex hull of points that lie nearly in one plane, or nothing. The plane contains three of them that
// are far apart.
OpenPolygon flat_hull(const std::vector<Vec3>& points, Vec3d& normal) {
  const auto farthest = [&](const auto& distance) {
    return *std::max_element(points.begin(), points.end(), [&](const Vec3& p, const Vec3& q) {
      return distance(Vec3d(p)) < distance(Vec3d(q));
    });
  };
  const Vec3d first(points.front());
  const Vec3d a(farthest([&](const Vec3d& p) { return glm::length(p - first); }));
  const Vec3d b(farthest([&](const Vec3d& p) { return glm::length(p - a); }));
  const auto along = b - a;
  const Vec3d c(farthest([&](const Vec3d& p) { return glm::length(glm::cross(p - a, along)); }));
  const auto normal2 = glm::cross(along, c - a);
  const auto size = glm::length(along);
  if (!(glm::length(normal2) > 1e-4 * size * size)) return {};
  normal = glm::normalize(normal2);
  for (const auto& p : points)
    if (std::fabs(glm::dot(normal, Vec3d(p) - a)) > rim_flatness * size) return {};
  FlatFrame frame{.origin = a, .normal = normal, .axis = {along / size, glm::cross(normal, along / size)}};
  std::vector<std::array<double, 2>> flat;
  for (const auto& p : points) flat.push_back(frame.flat(p));
  const auto hull = convex_hull(std::move(flat));
  return hull.size() < 3 ? OpenPolygon() : in_space(frame, hull);
}

}  // namespace

namespace {

// For each triangle, the first one of those connected to it by corners, [triangle].
std::vector<std::uint32_t> connected(std::span<const Triangle3> triangles,
                                     std::span<const std::uint32_t> members) {
  std::map<std::array<float, 3>, std::uint32_t> first_at;
  DisjointSets sets(members.size());
  for (std::uint32_t i = 0; i < members.size(); ++i)
    for (const auto& v : triangles[members[i]])
      sets.join(i, first_at.try_emplace(std::array<float, 3>{v.x, v.y, v.z}, i).first->second);
  std::vector<std::uint32_t> of;
  for (std::uint32_t i = 0; i < members.size(); ++i) of.push_back(sets.of(i));
  return of;
}

}  // namespace

// Triangles of one plane that share corners are one pane, represented by its convex hull; a hull larger than
// the pane is valid, as any set of portals is unbiased. The narrow sides of a thin box of glass are not
// panes.
std::vector<OpenPolygon> find_panes(std::span<const Triangle3> glass, double extent) {
  std::vector<std::uint32_t> all(glass.size());
  std::iota(all.begin(), all.end(), 0u);
  const auto object = connected(glass, all);
  std::vector<std::pair<std::uint32_t, OpenPolygon>> panes;  // with their objects
  std::vector<double> largest(glass.size(), 0.0);            // [object], m²
  for (const auto& plane : group_by_plane(glass, plane_tolerance * extent)) {
    const auto set = connected(glass, plane);
    const auto frame = frame_of(glass, plane);
    std::map<std::uint32_t, std::vector<std::array<double, 2>>> points;
    for (std::uint32_t i = 0; i < plane.size(); ++i)
      for (const auto& v : glass[plane[i]]) points[set[i]].push_back(frame.flat(v));
    for (auto& [first, flat] : points) {
      const auto hull = convex_hull(std::move(flat));
      if (hull.size() < 3) continue;
      const auto of = object[plane[first]];
      largest[of] = std::max(largest[of], area_of(hull));
      panes.emplace_back(of, in_space(frame, hull));
    }
  }
  std::vector<OpenPolygon> wide;
  for (auto& [of, pane] : panes)
    if (area_of(pane) >= narrow_side * largest[of]) wide.push_back(std::move(pane));
  return wide;
}

// A loop whose triangles stand on its plane: the boundary of a box without a lid. (Where they lie in the
// plane, the loop is the outline of a sheet, or a hole that find_wall_holes() finds.)
std::vector<OpenPolygon> find_missing_walls(const Scene& scene) {
  VertexWeld weld;
  const auto triangles = clean_triangles(scene, weld).kept;
  const auto& places = weld.positions();
  const auto edges = find_edges(triangles, places.size());
  DisjointSets sets(places.size());
  std::vector<std::uint32_t> open;
  for (std::uint32_t e = 0; e < edges.size(); ++e)
    if (edges.is_open(e)) {
      open.push_back(e);
      sets.join(edges.ends[e][0], edges.ends[e][1]);
    }
  std::map<std::uint32_t, std::vector<std::uint32_t>> loops;
  for (const auto e : open) loops[sets.of(edges.ends[e][0])].push_back(e);
  std::vector<OpenPolygon> walls;
  for (const auto& [set, loop] : loops) {
    if (loop.size() < 3) continue;
    std::vector<Vec3> points;
    for (const auto e : loop)
      points.insert(points.end(), {places[edges.ends[e][0]], places[edges.ends[e][1]]});
    Vec3d normal(0.0);
    auto hull = flat_hull(points, normal);
    if (hull.empty()) continue;
    double length = 0.0, standing = 0.0;
    for (const auto e : loop) {
      const auto own = glm::length(Vec3d(places[edges.ends[e][0]]) - Vec3d(places[edges.ends[e][1]]));
      const auto& c = triangles[edges.uses_of(e)[0].triangle].corners;
      const auto of_triangle = glm::normalize(area_vector2(places[c[0]], places[c[1]], places[c[2]]));
      length += own;
      if (std::fabs(glm::dot(normal, of_triangle)) < parallel) standing += own;
    }
    if (2.0 * standing > length) walls.push_back(std::move(hull));
  }
  return walls;
}

std::vector<OpenPolygon> find_open_polygons(const Scene& scene, std::size_t max_count) {
  std::vector<Triangle3> glass, solid;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const auto& material = scene.materials[static_cast<std::size_t>(scene.triangle_material[t])];
    (material.opaque ? solid : glass).push_back(triangle_of(scene, t));
  }
  const double extent = glm::length(bounds(scene).size());
  auto all = find_panes(glass, extent);
  for (auto& found : {find_wall_holes(solid, extent), find_missing_walls(scene)})
    all.insert(all.end(), found.begin(), found.end());
  std::vector<std::pair<double, std::size_t>> by_area;
  for (std::size_t i = 0; i < all.size(); ++i) by_area.emplace_back(-area_of(all[i]), i);
  std::sort(by_area.begin(), by_area.end());
  by_area.resize(std::min(by_area.size(), max_count));
  std::vector<OpenPolygon> largest;
  for (const auto& [area, i] : by_area) largest.push_back(std::move(all[i]));
  return largest;
}

}  // namespace luxel
