// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/round_trip_parts.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/import/gltf_array.h"

namespace luxel {
namespace {

Vec3d placed(const GltfArray& positions, std::uint32_t vertex, const glm::dmat4& world) {
  const auto p = positions.at(vertex);
  return Vec3d(world * glm::dvec4(p[0], p[1], p[2], 1.0));
}

[[noreturn]] void refuse(const Scene& scene) {
  throw MismatchError(fmt::format(
      "{}: the scene has other triangles than the file: solve the file as it is now", scene.source));
}

// The vertices of a primitive, and the scene that was read from it.
struct VerticesOfFile {
  const GltfArray& positions;
  const Scene& scene;
  double metres_per_unit;

  // Returns the distance of a vertex from a position of the scene, m.
  double distance(const RoundTripPart& part, std::uint32_t vertex, std::uint32_t position) const {
    const auto at = metres_per_unit * placed(positions, vertex, part.drawn.placed.world) - scene.origin;
    return glm::length(Vec3d(scene.positions[position]) - at);
  }
};

// Orders the corners of the last triangle as the scene does. A flipped triangle has its second and third
// corner exchanged.
void match_corners(RoundTripPart& part, const VerticesOfFile& vertices) {
  auto& corners = part.corners.back();
  if (part.mirrored) std::swap(corners[1], corners[2]);
  const auto& of_scene = vertices.scene.triangles[part.triangles.back()];
  if (vertices.distance(part, corners[1], of_scene[1]) <= vertices.distance(part, corners[1], of_scene[2]))
    return;
  std::swap(corners[1], corners[2]);
  part.as_read = false;
}

// Adds a surface that was triangulated again. corners: of the part's triangles in the file, from `begin` on.
void add_surface(RoundTripPart& part, const VerticesOfFile& vertices, const FlatSurface& surface,
                 std::span<const std::array<std::uint32_t, 3>> corners, std::size_t begin) {
  if (surface.of_file.back() >= begin + corners.size()) refuse(vertices.scene);
  std::vector<std::uint32_t> position(surface.corner_of.size() + surface.halved.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      position[surface.triangles[t][k]] = vertices.scene.triangles[surface.first + t][k];
  std::vector<std::uint32_t> vertex;
  for (const auto t : surface.corner_of) {
    const auto& three = corners[t - begin];
    const auto at = position[vertex.size()];
    vertex.push_back(*std::min_element(three.begin(), three.end(), [&](std::uint32_t a, std::uint32_t b) {
      return vertices.distance(part, a, at) < vertices.distance(part, b, at);
    }));
  }
  for (const auto& [a, b] : surface.halved) {
    part.halved.push_back({vertex[a], vertex[b]});
    vertex.push_back(static_cast<std::uint32_t>(part.vertices++));
  }
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    part.triangles.push_back(surface.first + t);
    const auto& points = surface.triangles[t];
    part.corners.push_back({vertex[points[0]], vertex[points[1]], vertex[points[2]]});
  }
  part.as_read = false;
}

// Where the triangles of a file are in the scene.
class TrianglesOfFile {
 public:
  // order: see round_trip_parts()
  TrianglesOfFile(const Scene& scene, const std::vector<std::uint32_t>& order) : order_(order) {
    auto size = scene.triangles.size();
    if (order.empty())
      for (const auto& surface : scene.retriangulated) {
        size += surface.of_file.size();
        size -= surface.triangles.size();
      }
    in_scene_.resize(size);
    if (!order.empty()) return;
    for (const auto& surface : scene.retriangulated) {
      for (const auto t : surface.of_file) in_scene_[t] = none;
      surface_at_[surface.of_file.front()] = &surface;
    }
    std::uint32_t next = 0;
    for (std::uint32_t t = 0; t < size; ++t)
      if (const auto* surface = surface_at(t))
        next += static_cast<std::uint32_t>(surface->triangles.size());
      else if (in_scene_[t] != none)
        in_scene_[t] = next++;
  }

  std::size_t size() const { return in_scene_.size(); }
  // The triangle in the scene; none: of a surface that was triangulated again.
  std::uint32_t in_scene(std::size_t t) const { return order_.empty() ? in_scene_[t] : order_[t]; }
  // The surface that stands at this triangle of the file, or null.
  const FlatSurface* surface_at(std::size_t t) const {
    const auto found = surface_at_.find(static_cast<std::uint32_t>(t));
    return found == surface_at_.end() ? nullptr : found->second;
  }

 private:
  const std::vector<std::uint32_t>& order_;
  std::vector<std::uint32_t> in_scene_;
  std::map<std::uint32_t, const FlatSurface*> surface_at_;
};

}  // namespace

bool is_opaque(const Scene& scene, const RoundTripPart& part) {
  if (part.triangles.empty()) return false;
  return scene.materials[static_cast<std::size_t>(scene.triangle_material[part.triangles.front()])].opaque;
}

std::vector<RoundTripPart> round_trip_parts(GltfFile& file, const Scene& scene, double metres_per_unit,
                                            const std::vector<std::uint32_t>& order) {
  const TrianglesOfFile of_file(scene, order);
  std::vector<RoundTripPart> parts;
  std::size_t triangles = 0;
  for (auto& drawn : drawn_parts(file, placed_nodes(file)).parts) {
    const GltfArray positions(file, drawn.primitive["attributes"]["POSITION"], 3, 3);
    const VerticesOfFile vertices{positions, scene, metres_per_unit};
    const auto corners = triangle_corners(file, drawn.primitive, positions.size());
    const auto begin = triangles;
    triangles += corners.size();
    if (triangles > of_file.size()) refuse(scene);
    const bool mirrored = mirrors(drawn.placed.world);
    RoundTripPart part{std::move(drawn), positions.size(), {}, {}, {}, mirrored};
    for (auto t = begin; t < triangles; ++t) {
      if (const auto* surface = of_file.surface_at(t)) {
        add_surface(part, vertices, *surface, corners, begin);
      } else if (const auto of_scene = of_file.in_scene(t); of_scene != none) {
        part.triangles.push_back(of_scene);
        part.corners.push_back(corners[t - begin]);
        match_corners(part, vertices);
      }
    }
    parts.push_back(std::move(part));
  }
  // Triangles added to a glTF scene are not in its file; the glTF of any other scene contains all triangles.
  if (triangles != of_file.size() && triangles + scene.added_triangles != of_file.size()) refuse(scene);
  return parts;
}

}  // namespace luxel
