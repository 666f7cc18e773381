// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "luxel/core/output_file.h"

namespace luxel::test {

// Reads a GLB file by its specification, without Luxel's own reader.
struct GlbFile {
  nlohmann::json json;
  std::string bytes;  // of the one buffer

  explicit GlbFile(const std::filesystem::path& path) {
    const auto file = read_file(path);
    const auto word = [&](std::size_t at) {
      std::uint32_t value = 0;
      std::memcpy(&value, file.substr(at, 4).data(), 4);
      return value;
    };
    if (file.substr(0, 4) != "glTF" || word(4) != 2 || word(8) != file.size() || file.substr(16, 4) != "JSON")
      throw std::runtime_error("no GLB");
    json = nlohmann::json::parse(file.substr(20, word(12)));
    if (const auto binary = 20 + word(12); binary < file.size()) {
      EXPECT_EQ(file.substr(binary + 4, 4), std::string("BIN\0", 4));
      EXPECT_EQ(binary + 8 + word(binary), file.size());
      bytes = file.substr(binary + 8);
      EXPECT_EQ(json.at("buffers").at(0).at("byteLength"), bytes.size());
    }
  }

  const nlohmann::json& primitive(std::size_t number) const {
    return json.at("meshes").at(0).at("primitives").at(number);
  }
  const nlohmann::json& accessor(const nlohmann::json& index) const {
    return json.at("accessors").at(index.get<std::size_t>());
  }
  const nlohmann::json& attribute(std::size_t number, const char* name) const {
    return accessor(primitive(number).at("attributes").at(name));
  }
  std::size_t primitives() const { return json.at("meshes").at(0).at("primitives").size(); }

  template <typename T>
  std::vector<T> values(const nlohmann::json& accessor) const {
    const auto& view = json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    const auto type = accessor.at("type").get<std::string>();
    const auto code = accessor.at("componentType").get<int>();
    EXPECT_EQ(code == 5126 || code == 5125 ? 4u : 2u, sizeof(T));
    std::vector<T> result(accessor.at("count").get<std::size_t>() *
                          (type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0')));
    const auto begin = view.at("byteOffset").get<std::size_t>(), size = result.size() * sizeof(T);
    EXPECT_EQ(begin % 4, 0u);
    EXPECT_LE(size, view.at("byteLength").get<std::size_t>());
    if (begin + size > bytes.size()) throw std::out_of_range("accessor");
    std::memcpy(result.data(), bytes.data() + begin, size);
    return result;
  }
};

}  // namespace luxel::test
