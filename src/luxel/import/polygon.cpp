// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/polygon.h"

#include "luxel/import/ear_clipper.h"

namespace luxel {
namespace {

// Newell's normal (Sutherland, Sproull, Schumacker 1974): twice the area vector, for any positions of the
// corners.
Vec3d newell_normal(std::span<const Vec3> corners) {
  const Vec3d origin(corners[0]);
  Vec3d sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += glm::cross(Vec3d(corners[i]) - origin, Vec3d(corners[i + 1]) - origin);
  return sum;
}

// Drops the coordinate along which the polygon is thinnest, so that the other two stay exact, and orients the
// result counter-clockwise.
void project(std::span<const Vec3> corners, const Vec3d& normal, std::vector<glm::dvec2>& plane) {
  const Vec3d size = glm::abs(normal);
  const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int u = (drop + 1) % 3, v = (drop + 2) % 3;
  if (normal[drop] < 0.0) std::swap(u, v);
  plane.clear();
  for (const auto& corner : corners) plane.emplace_back(corner[u], corner[v]);
}

// Returns whether all turns are to the left and no triangle of the fan is flipped (as in a five-pointed
// star).
bool is_strictly_convex(std::span<const glm::dvec2> plane) {
  const std::size_t n = plane.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!(turn(plane[i], plane[(i + 1) % n], plane[(i + 2) % n]) > 0.0)) return false;
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (!(turn(plane[0], plane[i], plane[i + 1]) > 0.0)) return false;
  return true;
}

void fan(std::size_t corner_count, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  for (std::uint32_t i = 1; i + 1 < corner_count; ++i) triangles.push_back({0, i, i + 1});
}

}  // namespace

void triangulate_polygon(std::span<const Vec3> corners,
                         std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (corners.size() <= 3) return fan(corners.size(), triangles);
  const auto normal = newell_normal(corners);
  if (normal == Vec3d(0.0)) return fan(corners.size(), triangles);

  std::vector<glm::dvec2> plane;
  project(corners, normal, plane);
  if (is_strictly_convex(plane)) return fan(corners.size(), triangles);
  EarClipper(plane).clip(triangles);
}

}  // namespace luxel
