// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/make_panes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "luxel/core/disjoint_sets.h"
#include "luxel/core/triangle.h"
#include "luxel/scene/triangle_shape.h"

namespace luxel {
namespace {

constexpr double parallel = 0.99;    // cosine between the normals of the faces of a thin body
constexpr double thin = 0.1;         // thickness of a thin body, of the root of the area of a face
constexpr double large_faces = 0.8;  // area of the two faces, of the whole surface
constexpr double same_area = 0.8;    // ratio of the areas of the two faces
constexpr double same_height = 0.1;  // of the thickness: a face lies within this of its end
constexpr double same_place = 0.1;   // between the centres of the faces, of the root of their area

using Corners = std::array<std::uint32_t, 3>;

const Material& material_of(const Scene& scene, std::size_t t) {
  return scene.materials[static_cast<std::size_t>(scene.triangle_material[t])];
}

// The scene's triangles of glass and, for each, the numbers of the places of its corners.
struct Glass {
  std::vector<std::uint32_t> triangles;
  std::vector<Corners> places;
};

Glass glass_of(const Scene& scene) {
  Glass glass;
  std::map<std::array<float, 3>, std::uint32_t> places;
  std::map<std::pair<MaterialId, Corners>, std::uint32_t> known;
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    if (material_of(scene, t).opaque) continue;
    const auto& c = scene.triangles[t];
    if (!has_area(scene.positions[c[0]], scene.positions[c[1]], scene.positions[c[2]])) continue;
    Corners corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = scene.positions[c[k]] + 0.0f;  // -0 becomes +0
      corners[k] =
          places.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(places.size())).first->second;
    }
    auto sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    if (!known.try_emplace({scene.triangle_material[t], sorted}, t).second) continue;
    glass.triangles.push_back(t);
    glass.places.push_back(corners);
  }
  return glass;
}

// For each triangle, the lowest of those connected to it.
std::vector<std::uint32_t> objects_of(const Scene& scene, const Glass& glass) {
  std::map<std::pair<MaterialId, std::uint32_t>, std::uint32_t> first_at;
  DisjointSets sets(glass.triangles.size());
  for (std::uint32_t i = 0; i < glass.triangles.size(); ++i)
    for (const auto place : glass.places[i]) {
      const auto material = scene.triangle_material[glass.triangles[i]];
      sets.join(i, first_at.try_emplace({material, place}, i).first->second);
    }
  std::vector<std::uint32_t> object;
  for (std::uint32_t i = 0; i < glass.triangles.size(); ++i) object.push_back(sets.of(i));
  return object;
}

// One end of an object, along its axis.
struct Face {
  double area = 0.0;  // m²
  Vec3d moment{0.0};  // area times centre

  Vec3d centre() const { return moment / area; }
};

// A connected object.
class GlassObject {
 public:
  GlassObject(const Scene& scene, const Glass& glass, const std::vector<std::uint32_t>& members)
      : scene_(scene), glass_(glass), members_(members) {
    double largest = 0.0;
    for (const auto i : members) {
      const auto vector = area2(i);
      whole_ += 0.5 * glm::length(vector);
      if (!(glm::length(vector) > largest)) continue;
      largest = glm::length(vector);
      axis_ = vector / largest;
    }
    for (const auto i : members)
      if (is_parallel(i)) {
        lowest_ = std::min(lowest_, glm::dot(axis_, centre(i)));
        highest_ = std::max(highest_, glm::dot(axis_, centre(i)));
      }
  }

  GlassBody body() const {
    if (is_closed()) return has_two_faces(false) ? GlassBody::thin_body : GlassBody::body;
    return has_two_faces(true) ? GlassBody::thin_body : GlassBody::sheet;
  }
  Vec3d axis(GlassBody body, std::uint32_t i) const {
    return body == GlassBody::thin_body ? axis_ : glm::normalize(area2(i));
  }

 private:
  std::array<Vec3, 3> points(std::uint32_t i) const {
    const auto& c = scene_.triangles[glass_.triangles[i]];
    return {scene_.positions[c[0]], scene_.positions[c[1]], scene_.positions[c[2]]};
  }
  Vec3d area2(std::uint32_t i) const {
    const auto p = points(i);
    return area_vector2(p[0], p[1], p[2]);
  }
  Vec3d centre(std::uint32_t i) const {
    const auto p = points(i);
    return (Vec3d(p[0]) + Vec3d(p[1]) + Vec3d(p[2])) / 3.0;
  }
  bool is_parallel(std::uint32_t i) const {
    const auto vector = area2(i);
    return std::fabs(glm::dot(axis_, vector)) > parallel * glm::length(vector);
  }

  bool is_closed() const {
    std::map<std::array<std::uint32_t, 2>, bool> is_odd;
    for (const auto i : members_)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto a = glass_.places[i][k], b = glass_.places[i][(k + 1) % 3];
        auto& odd = is_odd[{std::min(a, b), std::max(a, b)}];
        odd = !odd;
      }
    return std::none_of(is_odd.begin(), is_odd.end(), [](const auto& edge) { return edge.second; });
  }

  // Returns whether most of the surface is two faces at the ends of a short axis. alike: they must also be
  // alike and lie over each other, which is required where nothing else shows that it is a body.
  bool has_two_faces(bool alike) const {
    const auto thickness = highest_ - lowest_;
    Face low, high;
    for (const auto i : members_) {
      if (!is_parallel(i)) continue;
      const auto height = glm::dot(axis_, centre(i)) - lowest_;
      const bool is_high = height > 0.5 * thickness;
      if (alike && std::min(height, thickness - height) > same_height * thickness) return false;
      auto& face = is_high ? high : low;
      const auto area = 0.5 * glm::length(area2(i));
      face.area += area;
      face.moment += area * centre(i);
    }
    const auto root = std::sqrt(0.5 * (low.area + high.area));
    if (!(thickness <= thin * root) || low.area + high.area < large_faces * whole_) return false;
    if (!alike) return true;
    if (!(std::min(low.area, high.area) >= same_area * std::max(low.area, high.area))) return false;
    const auto apart = high.centre() - low.centre();
    return glm::length(apart - glm::dot(apart, axis_) * axis_) < same_place * root;
  }

  const Scene& scene_;
  const Glass& glass_;
  const std::vector<std::uint32_t>& members_;
  Vec3d axis_{0.0};
  double whole_ = 0.0;                                                            // m²
  double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -lowest_;  // m, along the axis
};

bool absorbs(const Material& m) { return !m.opaque && m.transmittance != Vec3(1.0f); }

// Of the materials that absorb light.
std::vector<GlassTriangle> absorbing_glass(const Scene& scene) {
  if (std::none_of(scene.materials.begin(), scene.materials.end(), absorbs)) return {};
  auto found = find_glass(scene);
  std::erase_if(found, [&](const GlassTriangle& g) { return !absorbs(material_of(scene, g.triangle)); });
  return found;
}

}  // namespace

std::vector<GlassTriangle> find_glass(const Scene& scene) {
  const auto glass = glass_of(scene);
  const auto object = objects_of(scene, glass);
  std::map<std::uint32_t, std::vector<std::uint32_t>> members;
  for (std::uint32_t i = 0; i < object.size(); ++i) members[object[i]].push_back(i);
  std::vector<GlassTriangle> found(object.size());
  for (const auto& [first, of_object] : members) {
    const GlassObject whole(scene, glass, of_object);
    const auto body = whole.body();
    for (const auto i : of_object) found[i] = {glass.triangles[i], first, body, whole.axis(body, i)};
  }
  return found;
}

std::vector<Pane> make_panes(const Scene& scene) {
  std::vector<Pane> panes;
  for (const auto& glass : absorbing_glass(scene)) {
    const auto& c = scene.triangles[glass.triangle];
    panes.push_back({{scene.positions[c[0]], scene.positions[c[1]], scene.positions[c[2]]},
                     Vec3(glass.axis),
                     scene.triangle_material[glass.triangle],
                     glass.body == GlassBody::sheet ? 1.0f : 0.5f});
  }
  return panes;
}

std::vector<std::uint32_t> pane_triangles(const Scene& scene) {
  std::vector<std::uint32_t> triangles;
  for (const auto& glass : absorbing_glass(scene)) triangles.push_back(glass.triangle);
  return triangles;
}

}  // namespace luxel
