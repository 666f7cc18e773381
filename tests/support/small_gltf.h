// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace luxel {

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

template <typename T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// A glTF file made by a test: arrays are added to the one buffer, all other JSON is written by the test.
struct SmallGltf {
  std::string buffer, views, accessors;
  int view_count = 0, accessor_count = 0;
  std::string meshes, nodes = R"({"mesh":0})", rest;  // rest: `,"materials":[...]` and so on

  static constexpr int i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126;

  // The number of a bufferView of these bytes.
  int view(const std::string& bytes, const std::string& more = "") {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    views += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", view_count > 0 ? "," : "",
                         buffer.size(), bytes.size(), more);
    buffer += bytes;
    return view_count++;
  }
  // Returns the number of a new accessor; place: `"bufferView":3` and further members.
  int accessor(int component, const char* type, std::size_t count, const std::string& place) {
    accessors +=
        fmt::format(R"({}{{"componentType":{},"type":"{}","count":{}{}{}}})", accessor_count > 0 ? "," : "",
                    component, type, count, place.empty() ? "" : ",", place);
    return accessor_count++;
  }
  template <typename T>
  int array(int component, const char* type, std::size_t count, const std::vector<T>& values,
            const std::string& more = "") {
    return accessor(component, type, count,
                    fmt::format(R"("bufferView":{}{})", view(bytes_of(values)), more));
  }
  int points(const std::vector<float>& xyz) { return array(f32, "VEC3", xyz.size() / 3, xyz); }

  std::string json(const std::string& uri) const {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}{}}}],"bufferViews":[{}],)"
        R"("accessors":[{}],"meshes":[{}],"nodes":[{}]{}}})",
        buffer.size(), uri, views, accessors, meshes, nodes, rest);
  }
  std::string text() const {
    return json(fmt::format(R"(,"uri":"data:application/octet-stream;base64,{}")", base64(buffer)));
  }
  std::string glb() const {
    auto text = json("");
    text.resize((text.size() + 3) / 4 * 4, ' ');
    auto bytes = buffer;
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const auto number = [](std::size_t n) {
      const std::vector<std::uint32_t> one = {static_cast<std::uint32_t>(n)};
      return bytes_of(one);
    };
    return "glTF" + number(2) + number(28 + text.size() + bytes.size()) + number(text.size()) + "JSON" +
           text + number(bytes.size()) + std::string("BIN\0", 4) + bytes;
  }
};

// One triangle in the plane z = 0, seen from +z: (0, 0), (1, 0), (0, 1).
inline SmallGltf one_triangle() {
  SmallGltf gltf;
  gltf.points({0, 0, 0, 1, 0, 0, 0, 1, 0});
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0}}]})";
  return gltf;
}

}  // namespace luxel
