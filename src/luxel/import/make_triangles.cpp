// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/make_triangles.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"
#include "luxel/import/polygon.h"

namespace luxel {
namespace {

constexpr std::size_t faces_per_report = 1 << 14;

bool opposes_its_normals(const PolygonMesh& mesh, const std::array<PolygonMesh::Corner, 3>& corners,
                         const Scene& scene) {
  Vec3d normals(0.0);
  for (const auto& corner : corners) {
    if (corner.normal == none) return false;
    normals += Vec3d(mesh.normals[corner.normal]);
  }
  const auto front = area_vector2(scene.positions[corners[0].position], scene.positions[corners[1].position],
                                  scene.positions[corners[2].position]);
  return glm::dot(front, normals) < 0.0;
}

// The materials of faces, including faces that cannot be textured.
class FaceMaterials {
 public:
  explicit FaceMaterials(Scene& scene) : scene_(scene), plain_(scene.materials.size()) {}

  // Returns the scene's number of the material's copy without pictures, created on first use.
  std::uint32_t plain(std::uint32_t material) {
    auto& twin = plain_[material];
    if (!twin) {
      twin = static_cast<std::uint32_t>(scene_.materials.size());
      auto copy = scene_.materials[material];
      copy.textures = {};
      scene_.materials.push_back(std::move(copy));
    }
    return *twin;
  }

 private:
  Scene& scene_;
  std::vector<std::optional<std::uint32_t>> plain_;
};

bool lacks_uv(std::span<const PolygonMesh::Corner> corners) {
  return std::any_of(corners.begin(), corners.end(),
                     [](const PolygonMesh::Corner& corner) { return corner.uv == none; });
}

void reserve(Scene& scene, std::size_t count, bool has_objects) {
  scene.triangles.reserve(count);
  scene.triangle_material.reserve(count);
  scene.triangle_line.reserve(count);
  scene.triangle_group.reserve(count);
  if (has_objects) scene.triangle_object.reserve(count);
  for (auto& set : scene.uv_sets) set.reserve(count);
}

bool has_colours(const PolygonMesh& mesh) {
  return !mesh.face_colours.empty() || !mesh.vertex_colours.empty();
}

Vec3 colour_of(const PolygonMesh& mesh, std::size_t face, const PolygonMesh::Corner& corner) {
  return mesh.face_colours.empty() ? mesh.vertex_colours[corner.position] : mesh.face_colours[face];
}

Vec2 uv_of(const PolygonMesh& mesh, const PolygonMesh::Corner& corner) {
  return corner.uv == none ? Vec2(0.0f) : mesh.uvs[corner.uv];
}

}  // namespace

std::optional<TriangleTallies> make_triangles(const PolygonMesh& mesh, Scene& scene, const Context& context) {
  TriangleTallies tallies;
  std::vector<bool> is_textured;
  for (const auto& material : scene.materials) is_textured.push_back(material.textures.any());
  scene.uv_sets.resize(std::count(is_textured.begin(), is_textured.end(), true) > 0 ? 1 : 0);
  FaceMaterials materials(scene);
  std::vector<Vec3> polygon;
  std::vector<std::array<std::uint32_t, 3>> parts;
  reserve(scene, mesh.corners.size() - 2 * mesh.faces.size(), !mesh.objects.empty());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto done = static_cast<double>(i) / static_cast<double>(mesh.faces.size());
    if (i % faces_per_report == 0 && context.report({.stage = "triangles", .done = done}) == Next::stop)
      return std::nullopt;
    const auto& face = mesh.faces[i];
    const auto end = i + 1 < mesh.faces.size() ? mesh.faces[i + 1].first_corner : mesh.corners.size();
    const auto corners = std::span(mesh.corners).subspan(face.first_corner, end - face.first_corner);
    auto material = face.material;
    if (is_textured[material] && lacks_uv(corners)) {
      tallies.without_uv.add(face.line);
      material = materials.plain(material);
    }
    polygon.clear();
    parts.clear();
    for (const auto& corner : corners) polygon.push_back(scene.positions[corner.position]);
    triangulate_polygon(polygon, parts);
    for (const auto& [a, b, c] : parts) {
      std::array triangle = {corners[a], corners[b], corners[c]};
      if (opposes_its_normals(mesh, triangle, scene)) {
        std::swap(triangle[1], triangle[2]);
        tallies.turned.add(face.line);
      }
      scene.triangles.push_back({triangle[0].position, triangle[1].position, triangle[2].position});
      scene.triangle_material.push_back(MaterialId{material});
      scene.triangle_line.push_back(face.line);
      scene.triangle_group.push_back(face.group);
      if (!mesh.objects.empty()) scene.triangle_object.push_back(face.object);
      for (auto& set : scene.uv_sets)
        set.push_back({uv_of(mesh, triangle[0]), uv_of(mesh, triangle[1]), uv_of(mesh, triangle[2])});
      if (has_colours(mesh))
        scene.corner_colours.push_back({colour_of(mesh, i, triangle[0]), colour_of(mesh, i, triangle[1]),
                                        colour_of(mesh, i, triangle[2])});
    }
  }
  return tallies;
}

}  // namespace luxel
