// SPDX-License-Identifier: Apache-2.0
#include "scenes/shapes/mesh.h"

#include <cmath>
#include <map>
#include <tuple>

namespace luxel::scenes {
namespace {

// Rotation in the plane of the coordinates a and b, from a towards b.
Mesh turned(Mesh mesh, int a, int b, double degrees) {
  const auto angle = glm::radians(degrees);
  const auto c = std::cos(angle);
  const auto s = std::sin(angle);
  for (auto& p : mesh.points) {
    const auto q = p;
    p[a] = c * q[a] - s * q[b];
    p[b] = s * q[a] + c * q[b];
  }
  return mesh;
}

}  // namespace

std::uint32_t Mesh::add_point(const Vec3d& p) {
  points.push_back(p);
  return static_cast<std::uint32_t>(points.size() - 1);
}

void Mesh::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  triangles.push_back({.corners = {a, b, c}});
}

void Mesh::add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  // A rectangle's diagonals differ by rounding only; the margin keeps that from deciding.
  const auto turn = glm::distance(points[b], points[d]) < 0.999 * glm::distance(points[a], points[c]);
  if (turn) {
    add_triangle(a, b, d);
    add_triangle(b, c, d);
  } else {
    add_triangle(a, b, c);
    add_triangle(a, c, d);
  }
}

Vec3d centroid(const Mesh& mesh, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
}

Vec3d area_vector(const Mesh& mesh, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return 0.5 * glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

void append(Mesh& mesh, const Mesh& part) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
  for (auto triangle : part.triangles) {
    for (auto& corner : triangle.corners) corner += first;
    mesh.triangles.push_back(triangle);
  }
}

Mesh joined(std::initializer_list<Mesh> parts) {
  auto mesh = Mesh{};
  for (const auto& part : parts) append(mesh, part);
  return mesh;
}

Mesh welded(const Mesh& mesh) {
  auto result = Mesh{};
  auto index_of = std::map<std::tuple<double, double, double>, std::uint32_t>{};
  auto index = std::vector<std::uint32_t>{};
  for (const auto& p : mesh.points) {
    const auto [at, is_new] = index_of.try_emplace({p.x, p.y, p.z}, 0u);
    if (is_new) at->second = result.add_point(p);
    index.push_back(at->second);
  }
  for (auto triangle : mesh.triangles) {
    for (auto& corner : triangle.corners) corner = index[corner];
    result.triangles.push_back(triangle);
  }
  return result;
}

Mesh rounded(const Mesh& mesh) {
  return welded(deformed(mesh, [](const Vec3d& p) {
    return glm::round(p * 1e6) / 1e6 + 0.0;  // + 0: minus zero becomes zero
  }));
}

Mesh painted(Mesh mesh, Paint paint) {
  for (auto& triangle : mesh.triangles) triangle.paint = paint;
  return mesh;
}

Mesh painted(Mesh mesh, Paint paint, const Where& where) {
  for (auto& triangle : mesh.triangles) {
    if (where(centroid(mesh, triangle), glm::normalize(area_vector(mesh, triangle)))) triangle.paint = paint;
  }
  return mesh;
}

Mesh deformed(Mesh mesh, const Deformation& deformation) {
  for (auto& p : mesh.points) p = deformation(p);
  return mesh;
}

Mesh moved(Mesh mesh, const Vec3d& by) {
  for (auto& p : mesh.points) p += by;
  return mesh;
}

Mesh turned_x(Mesh mesh, double degrees) { return turned(std::move(mesh), 1, 2, degrees); }
Mesh turned_y(Mesh mesh, double degrees) { return turned(std::move(mesh), 2, 0, degrees); }
Mesh turned_z(Mesh mesh, double degrees) { return turned(std::move(mesh), 0, 1, degrees); }

Mesh placed(Mesh mesh, const Vec3d& at, double turn_degrees) {
  return moved(turned_y(std::move(mesh), turn_degrees), at);
}

}  // namespace luxel::scenes
