// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/none.h"
#include "luxel/import/gltf_parts.h"

namespace luxel {
namespace {

using Corners = std::array<std::uint32_t, 3>;  // numbers of vertices in the primitive's arrays

// Clamps to [0, 1]; NaN becomes 0.
float in_unit(float x) { return x > 0.0f ? std::min(x, 1.0f) : 0.0f; }

}  // namespace

GltfMesh::GltfMesh(GltfFile& file, Scene& scene, double scale, std::vector<std::size_t> texture_coordinates)
    : file_(file), scene_(scene), scale_(scale), texture_coordinates_(std::move(texture_coordinates)) {
  scene_.uv_sets.resize(texture_coordinates_.size());
}

void GltfMesh::add(const JsonValue& primitive, const glm::dmat4& world, const std::string& object,
                   MaterialId material) {
  const auto place = primitive["attributes"]["POSITION"];
  const GltfArray positions(file_, place, 3, 3);
  auto corners = triangle_corners(file_, primitive, positions.size());
  if (mirrors(world))
    for (auto& [a, b, c] : corners) std::swap(b, c);

  // Files may share one array among many primitives: only the vertices of this one are taken.
  std::vector<std::uint32_t> taken(positions.size(), none);
  const auto number = number_of(object);
  for (const auto& triangle : corners) {
    auto& indices = scene_.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      auto& index = taken[triangle[i]];
      if (index == none) {
        index = static_cast<std::uint32_t>(positions_.size());
        if (index == none) place.refuse("the file has more than 4,294,967,295 vertices in all its instances");
        positions_.push_back(placed(positions, triangle[i], world));
      }
      indices[i] = index;
    }
    scene_.triangle_material.push_back(material);
    scene_.triangle_line.push_back(0);
    scene_.triangle_group.push_back(number);
    scene_.triangle_object.push_back(number);
  }
  add_uvs(primitive, corners);
  add_colours(primitive, corners);
}

// Written so that NaN fails too.
Vec3d GltfMesh::placed(const GltfArray& positions, std::size_t vertex, const glm::dmat4& world) const {
  const auto p = positions.at(vertex);
  const auto at = Vec3d(world * glm::dvec4(p[0], p[1], p[2], 1.0));
  const auto metres = scale_ * glm::abs(at);
  if (!(metres.x <= farthest && metres.y <= farthest && metres.z <= farthest))
    positions.accessor().refuse(
        fmt::format("vertex {} is not finite, or comes to lie beyond {:g} m", vertex, farthest));
  return at;
}

std::uint32_t GltfMesh::number_of(const std::string& object) {
  const auto [found, is_new] = objects_.try_emplace(object, static_cast<std::uint32_t>(objects_.size()));
  if (is_new) {
    scene_.groups.push_back(object);
    scene_.objects.push_back(object);
  }
  return found->second;
}

// A primitive never gets a material that needs a set it lacks, so the values that fill the gap are not
// visible.
void GltfMesh::add_uvs(const JsonValue& primitive, const std::vector<Corners>& corners) {
  for (std::size_t set = 0; set < scene_.uv_sets.size(); ++set) {
    auto& uvs = scene_.uv_sets[set];
    const auto place = primitive["attributes"][fmt::format("TEXCOORD_{}", texture_coordinates_[set])];
    if (!place) {
      uvs.resize(uvs.size() + corners.size());
      continue;
    }
    const GltfArray array(file_, place, 2, 2);
    for (const auto& triangle : corners) {
      auto& uv = uvs.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        if (triangle[i] >= array.size())
          place.refuse(
              fmt::format("expected an element for vertex {}, found {} elements", triangle[i], array.size()));
        const auto numbers = array.at(triangle[i]);
        uv[i] = Vec2(numbers[0], numbers[1]);
        if (!std::isfinite(uv[i].x) || !std::isfinite(uv[i].y))
          array.accessor().refuse(fmt::format("element {} is not finite", triangle[i]));
      }
    }
  }
}

void GltfMesh::add_colours(const JsonValue& primitive, const std::vector<Corners>& corners) {
  const auto place = primitive["attributes"]["COLOR_0"];
  const auto white = std::array{Vec3(1.0f), Vec3(1.0f), Vec3(1.0f)};
  if (place && !has_colours_) {
    has_colours_ = true;
    scene_.corner_colours.assign(scene_.triangles.size() - corners.size(), white);
  }
  if (!has_colours_) return;
  if (!place) return scene_.corner_colours.resize(scene_.triangles.size(), white);
  const GltfArray array(file_, place, 3, 4);
  for (const auto& triangle : corners) {
    auto& colours = scene_.corner_colours.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      if (triangle[i] >= array.size())
        place.refuse(
            fmt::format("expected an element for vertex {}, found {} elements", triangle[i], array.size()));
      const auto numbers = array.at(triangle[i]);
      colours[i] = Vec3(in_unit(numbers[0]), in_unit(numbers[1]), in_unit(numbers[2]));
    }
  }
}

void GltfMesh::finish() {
  const auto is_white = [](const std::array<Vec3, 3>& c) {
    return c[0] == Vec3(1.0f) && c[1] == Vec3(1.0f) && c[2] == Vec3(1.0f);
  };
  if (std::all_of(scene_.corner_colours.begin(), scene_.corner_colours.end(), is_white))
    scene_.corner_colours = {};
}

}  // namespace luxel
