// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/round_trip_primitive.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/export/back_gap.h"
#include "luxel/export/round_trip_attribute.h"
#include "luxel/import/gltf_array.h"

namespace luxel {
namespace {

using Kind = RoundTripAttribute::Kind;
using Numbers = RoundTripAttribute::Numbers;

Kind kind_of(const std::string& name) {
  if (name == "POSITION") return Kind::position;
  if (name == "NORMAL" || name == "TANGENT") return Kind::direction;
  return name.starts_with("JOINTS_") ? Kind::joints : Kind::other;
}

std::vector<Vec3> positions_of(const std::vector<float>& values) {
  std::vector<Vec3> positions(values.size() / 3);
  for (std::size_t i = 0; i < values.size(); ++i) positions[i / 3][static_cast<int>(i % 3)] = values[i];
  return positions;
}

std::size_t add(GltfWriter& copy, const std::vector<float>& values, int components, Kind kind) {
  if (kind == Kind::joints) {
    std::vector<std::array<std::uint16_t, 4>> joints(values.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i)
      joints[i / 4][i % 4] = static_cast<std::uint16_t>(values[i]);
    return copy.add_joints(joints);
  }
  if (kind != Kind::position) return copy.add_floats(values, components);
  return copy.add_positions(positions_of(values));
}

// A surface, and how far it is moved outwards, in the coordinates of its node.
struct MovedSurface {
  const RoundTripSurface& surface;
  float distance = 0.0f;
};

// Extends the attributes at `path` to the old and new vertices.
void extend(GltfWriter& copy, GltfFile& file, const JsonValue& attributes, const RoundTripPart& part,
            const MovedSurface& moved, const std::string& path) {
  const auto& surface = moved.surface;
  const auto vertices = part.vertices_of_file();
  for (const auto& name : attributes.keys()) {
    const GltfArray array(file, attributes[name], 1, 4);
    const auto kind = kind_of(name);
    const auto turns = surface.back && name == "NORMAL";
    const auto moves = moved.distance > 0.0f && kind == Kind::position;
    if (surface.has_all_own && surface.added.empty() && part.halved.empty() && !turns && !moves) continue;
    if (array.size() < vertices)
      attributes[name].refuse(fmt::format("expected {} elements, found {}", vertices, array.size()));
    const RoundTripAttribute attribute(array, part, kind);
    std::vector<float> values;
    values.reserve((surface.own.size() + surface.added.size()) *
                   static_cast<std::size_t>(array.components()));
    const auto put = [&](const Numbers& numbers) {
      for (int c = 0; c < array.components(); ++c) {
        const auto number = static_cast<float>(numbers[static_cast<std::size_t>(c)]);
        values.push_back(turns ? -number : number);
      }
    };
    for (const auto v : surface.own) put(attribute.at(v));
    for (const auto& vertex : surface.added) put(attribute.between(vertex));
    if (moves) {
      auto positions = positions_of(values);
      move_outwards(positions, surface.triangles, moved.distance);
      copy.put(path + "/" + name, copy.add_positions(positions));
    } else {
      copy.put(path + "/" + name, add(copy, values, array.components(), kind));
    }
  }
}

}  // namespace

std::string primitive_path(std::size_t mesh, std::size_t primitive) {
  return fmt::format("/meshes/{}/primitives/{}", mesh, primitive);
}

std::size_t mesh_of_node(GltfWriter& copy, std::size_t node, std::vector<bool>& taken) {
  const auto place = fmt::format("/nodes/{}/mesh", node);
  const auto mesh = copy.index_at(place);
  if (!taken[mesh]) {
    taken[mesh] = true;
    return mesh;
  }
  const auto own = copy.append_copy("/meshes", fmt::format("/meshes/{}", mesh));
  copy.put(place, own);
  return own;
}

void put_surface(GltfWriter& copy, GltfFile& file, const RoundTripPart& part, const RoundTripSurface& surface,
                 const std::string& path, float gap) {
  const auto& primitive = part.drawn.primitive;
  if (surface.back) copy.erase(path + "/attributes/TANGENT");
  const auto scale = static_cast<float>(glm::length(glm::dvec3(part.drawn.placed.world[0])));
  extend(copy, file, primitive["attributes"], part, {surface, surface.back ? gap / scale : 0.0f},
         path + "/attributes");
  const auto targets = primitive["targets"];
  for (std::size_t i = 0; i < targets.size(); ++i)
    extend(copy, file, targets[i], part, {surface}, fmt::format("{}/targets/{}", path, i));
  if (surface.as_it_was) return;
  copy.erase(path + "/mode");
  copy.put(path + "/indices", copy.add_indices(surface.triangles, surface.own.size() + surface.added.size()));
}

}  // namespace luxel
