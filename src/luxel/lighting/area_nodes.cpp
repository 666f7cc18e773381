// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/import/gltf_areas.h"
#include "luxel/lighting/areas.h"

namespace luxel {
namespace {

constexpr std::string_view prefix = "area_";
constexpr std::array<std::string_view, 2> texts = {"requirement", "source"};
constexpr std::array<std::string_view, 3> flags = {"cylindrical", "direct", "surround"};
constexpr std::array<std::string_view, 14> numbers = {
    "border", "spacing",      "Ez_height", "maintenance", "Em",        "Emin", "U0",
    "Ud",     "max_over_min", "Ez",        "E_wall",      "E_ceiling", "UGR",  "Ra"};

bool has(std::span<const std::string_view> keys, std::string_view key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

TomlValue to_toml(const Vec3d& point) {
  TomlArray array;
  for (const auto x : {point.x, point.y, point.z}) array.push_back({x});
  return {array};
}

// Programs write true and false as numbers, too.
bool truth_of(const JsonValue& value) {
  return value.is_truth() ? value.truth(false) : value.number() != 0.0;
}

void add_keys(const JsonValue& extras, TomlEntries& entries) {
  for (const auto& key : extras.keys()) {
    if (!key.starts_with(prefix)) continue;
    const auto name = key.substr(prefix.size());
    const auto value = extras[key];
    if (has(texts, name))
      entries.push_back({name, {value.text()}});
    else if (has(flags, name))
      entries.push_back({name, {truth_of(value)}});
    else if (has(numbers, name))
      entries.push_back({name, {value.number()}});
    else
      value.refuse(fmt::format("expected one of area_requirement, area_{}, area_{}",
                               fmt::join(flags, ", area_"), fmt::join(numbers, ", area_")));
  }
}

TomlTable table_of(const AreaNode& node) {
  TomlTable table{"area", true, 0, {}};
  auto& entries = table.entries;
  entries.push_back({"name", {node.name}});
  entries.push_back({"kind", {node.kind}});
  if (node.kind == "escape_route") {
    // The middle line of the rectangle, along its longer side.
    auto along = node.first - node.corner, across = node.second - node.corner;
    if (glm::length(along) < glm::length(across)) std::swap(along, across);
    const auto begin = node.corner + 0.5 * across;
    entries.push_back({"line", {TomlArray{to_toml(begin), to_toml(begin + along)}}});
  } else {
    entries.push_back({"corner", to_toml(node.corner)});
    entries.push_back({"first", to_toml(node.first)});
    entries.push_back({"second", to_toml(node.second)});
  }
  add_keys(node.extras, entries);
  return table;
}

}  // namespace

TomlFile read_area_file(const std::string& file) {
  const auto ending = ending_of(file);
  if (ending != ".glb" && ending != ".gltf") return read_toml(file);
  TomlFile toml{file, {TomlTable{}}};
  for (const auto& node : gltf_area_nodes(file)) toml.tables.push_back(table_of(node));
  if (toml.tables.size() == 1)
    throw InputError(file, "expected a node with the extra \"calculation_area\", found none");
  return toml;
}

}  // namespace luxel
