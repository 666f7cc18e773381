// SPDX-License-Identifier: Apache-2.0
#include "luxel/load/make_triangles.h"

#include <span>

#include "luxel/load/polygon.h"
#include "luxel/math/triangle.h"

namespace luxel {
namespace {

constexpr std::size_t faces_a_report = 1 << 14;

bool opposes_its_normals(const ObjMesh& mesh, const std::array<ObjMesh::Corner, 3>& corners,
                         const Scene& scene) {
  Vec3d normals(0.0);
  for (const auto& corner : corners) {
    if (corner.normal == ObjMesh::no_normal) return false;
    normals += Vec3d(mesh.normals[corner.normal]);
  }
  const auto front = area_vector2(scene.positions[corners[0].position], scene.positions[corners[1].position],
                                  scene.positions[corners[2].position]);
  return glm::dot(front, normals) < 0.0;
}

void reserve(Scene& scene, std::size_t count, bool has_objects) {
  scene.triangles.reserve(count);
  scene.triangle_material.reserve(count);
  scene.triangle_line.reserve(count);
  scene.triangle_group.reserve(count);
  if (has_objects) scene.triangle_object.reserve(count);
}

}  // namespace

std::optional<Tally> make_triangles(const ObjMesh& mesh, Scene& scene, const Monitor& monitor) {
  Tally turned;
  std::vector<Vec3> polygon;
  std::vector<std::array<std::uint32_t, 3>> parts;
  reserve(scene, mesh.corners.size() - 2 * mesh.faces.size(), !mesh.objects.empty());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto done = static_cast<double>(i) / static_cast<double>(mesh.faces.size());
    if (i % faces_a_report == 0 && tell(monitor, {.stage = "triangles", .done = done}) == Next::stop)
      return std::nullopt;
    const auto& face = mesh.faces[i];
    const auto end = i + 1 < mesh.faces.size() ? mesh.faces[i + 1].first_corner : mesh.corners.size();
    const auto corners = std::span(mesh.corners).subspan(face.first_corner, end - face.first_corner);
    polygon.clear();
    parts.clear();
    for (const auto& corner : corners) polygon.push_back(scene.positions[corner.position]);
    triangulate_polygon(polygon, parts);
    for (const auto& [a, b, c] : parts) {
      std::array triangle = {corners[a], corners[b], corners[c]};
      if (opposes_its_normals(mesh, triangle, scene)) {
        std::swap(triangle[1], triangle[2]);
        turned.add(face.line);
      }
      scene.triangles.push_back({triangle[0].position, triangle[1].position, triangle[2].position});
      scene.triangle_material.push_back(MaterialId{face.material});
      scene.triangle_line.push_back(face.line);
      scene.triangle_group.push_back(face.group);
      if (!mesh.objects.empty()) scene.triangle_object.push_back(face.object);
    }
  }
  return turned;
}

}  // namespace luxel
