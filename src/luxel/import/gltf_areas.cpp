// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_areas.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "luxel/import/gltf_parts.h"
#include "luxel/import/placed_nodes.h"

namespace luxel {
namespace {

constexpr const char* area_key = "calculation_area";

struct LocalBox {
  Vec3d low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};

// glTF requires the bounds of positions.
LocalBox box_of(const GltfFile& file, const JsonValue& node) {
  if (!node["mesh"]) return {{-0.5, 0.0, -0.5}, {0.5, 0.0, 0.5}};
  LocalBox box;
  const auto primitives = file.object(node["mesh"], "meshes")["primitives"];
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const auto position = primitives[i]["attributes"]["POSITION"];
    if (!position) continue;
    const auto accessor = file.object(position, "accessors");
    const auto low = accessor["min"].numbers({0.0, 0.0, 0.0}),
               high = accessor["max"].numbers({0.0, 0.0, 0.0});
    box.low = glm::min(box.low, Vec3d(low[0], low[1], low[2]));
    box.high = glm::max(box.high, Vec3d(high[0], high[1], high[2]));
  }
  return box;
}

AreaNode area_of(const GltfFile& file, const PlacedNode& placed) {
  const auto extras = placed.node["extras"];
  AreaNode area{placed.node["name"].text(""), extras[area_key].text(), {}, {}, {}, extras};
  if (area.name.empty()) area.name = fmt::format("node {}", placed.number);
  const auto box = box_of(file, placed.node);
  const auto size = box.high - box.low;
  if (!(std::min({size.x, size.y, size.z}) >= 0.0)) placed.node.refuse("expected a mesh with positions");
  // The thinnest axis is the normal; the others follow so that the corners turn about it.
  int normal = 1;
  if (size.x < size[normal]) normal = 0;
  if (size.z < size[normal]) normal = 2;
  auto corner = box.low;
  corner[normal] = 0.5 * (box.low[normal] + box.high[normal]);
  const auto place = [&](const Vec3d& at) { return Vec3d(placed.world * glm::dvec4(at, 1.0)); };
  const auto beside = [&](int axis) {
    auto at = corner;
    at[axis] = box.high[axis];
    return place(at);
  };
  area.corner = place(corner);
  area.first = beside((normal + 1) % 3);
  area.second = beside((normal + 2) % 3);
  return area;
}

}  // namespace

bool is_calculation_area(const JsonValue& node) {
  const auto extras = node["extras"];
  return extras.is_object() && extras[area_key].is_text();
}

std::vector<AreaNode> gltf_area_nodes(const std::filesystem::path& file) {
  const GltfFile gltf(file, known_extensions());
  std::vector<AreaNode> areas;
  for (const auto& placed : placed_nodes(gltf))
    if (is_calculation_area(placed.node)) areas.push_back(area_of(gltf, placed));
  return areas;
}

}  // namespace luxel
