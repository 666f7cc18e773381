// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/array_store.h"

#include <array>
#include <limits>
#include <utility>

#include "luxel/import/meshopt_encode.h"

namespace luxel {
namespace {

constexpr const char* extension = "EXT_meshopt_compression";
constexpr std::size_t alignment = 4;  // of every view
enum Target : int { vertices = 34962, indices = 34963 };
enum Component : int { u16 = 5123, u32 = 5125, f32 = 5126 };

void align(std::string& bytes) { bytes.resize((bytes.size() + alignment - 1) / alignment * alignment); }

SortedJson bounds_of(const PackedColumn& column, const std::array<double, 3>& bounds) {
  auto json = SortedJson::array();
  for (const auto number : bounds)
    if (column.component == f32)
      json.push_back(number);
    else
      json.push_back(static_cast<std::int64_t>(number));
  return json;
}

SortedJson& array_at(SortedJson& root, const char* name) {
  auto& array = root[name];
  if (!array.is_array()) array = SortedJson::array();
  return array;
}

}  // namespace

std::size_t ArrayStore::append(Stream& stream, SortedJson accessor, std::string_view bytes) {
  accessor["byteOffset"] = stream.bytes.size();
  stream.bytes += bytes;
  auto& accessors = array_at(root_, "accessors");
  accessors.push_back(std::move(accessor));
  stream.accessors.push_back(accessors.size() - 1);
  return stream.accessors.back();
}

std::size_t ArrayStore::add(std::string_view name, const PackedColumn& column) {
  constexpr std::array types = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  SortedJson accessor = {{"componentType", column.component},
                         {"type", types.at(static_cast<std::size_t>(column.components) - 1)},
                         {"count", column.count}};
  if (column.is_normalised) accessor["normalized"] = true;
  if (name == "POSITION") {
    accessor["min"] = bounds_of(column, column.low);
    accessor["max"] = bounds_of(column, column.high);
  }
  auto& stream = streams_[{column.component, column.stride, std::string(name)}];
  stream.mode = "ATTRIBUTES";
  // Luxel's own attribute, whose error is far larger. Others may hold numbers that must not change.
  if (name == "_IRRADIANCE" && column.component == f32) stream.filter = "EXPONENTIAL";
  return append(stream, std::move(accessor), column.bytes);
}

// Indices of all ones are forbidden: programs may take them for the end of a strip.
std::size_t ArrayStore::add_indices(const std::vector<std::uint32_t>& values, std::size_t vertex_count,
                                    bool is_list) {
  const bool is_narrow = vertex_count <= std::numeric_limits<std::uint16_t>::max();
  std::string bytes;
  for (const auto value : values)
    for (int byte = 0; byte < (is_narrow ? 2 : 4); ++byte)
      bytes += static_cast<char>(value >> 8 * byte & 0xff);
  const int component = is_narrow ? u16 : u32;
  auto& stream = streams_[{component, is_narrow ? 2 : 4, is_list ? "triangles" : "indices"}];
  stream.mode = is_list ? "TRIANGLES" : "INDICES";
  return append(stream, {{"componentType", component}, {"type", "SCALAR"}, {"count", values.size()}}, bytes);
}

std::size_t ArrayStore::append_views(std::string& binary) {
  for (const auto& [key, stream] : streams_) {
    align(binary);
    SortedJson view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", stream.bytes.size()}};
    const bool is_attribute = stream.mode == "ATTRIBUTES";
    view["target"] = is_attribute ? vertices : indices;
    if (is_attribute) view["byteStride"] = std::get<1>(key);
    auto& views = array_at(root_, "bufferViews");
    for (const auto accessor : stream.accessors) root_["accessors"][accessor]["bufferView"] = views.size();
    views.push_back(std::move(view));
    binary += stream.bytes;
  }
  align(binary);
  return streams_.size();
}

void ArrayStore::compress_views(std::string& binary) const {
  auto& views = root_["bufferViews"];
  auto number = views.size() - streams_.size();
  binary.resize(views[number]["byteOffset"].get<std::size_t>());
  std::size_t decoded = 0;
  for (const auto& [key, stream] : streams_) {
    const auto stride = std::get<1>(key);
    const auto count = stream.bytes.size() / stride;
    const auto code = encode_meshopt(stream.bytes, {count, stride, stream.mode, stream.filter});
    SortedJson meshopt = {
        {"buffer", 0},    {"byteOffset", binary.size()}, {"byteLength", code.size()}, {"byteStride", stride},
        {"count", count}, {"mode", stream.mode}};
    if (stream.filter != "NONE") meshopt["filter"] = stream.filter;
    auto& view = views[number++];
    view["buffer"] = 1;
    view["byteOffset"] = decoded;
    view["extensions"][extension] = std::move(meshopt);
    decoded += (stream.bytes.size() + alignment - 1) / alignment * alignment;
    binary += code;
    align(binary);
  }
  root_["buffers"].push_back({{"byteLength", decoded}, {"extensions", {{extension, {{"fallback", true}}}}}});
}

}  // namespace luxel
