// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/vector.h"

namespace luxel {

// The cube [0, 2]³ as a mesh of quadrilaterals, fronts outwards, for files of any format.
struct SmallCube {
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 4>> faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

  SmallCube() {
    for (int i = 0; i < 8; ++i)
      positions.emplace_back(i % 2 ? 2.0f : 0.0f, i / 2 % 2 ? 2.0f : 0.0f, i / 4 ? 2.0f : 0.0f);
  }

  // As convex polygons are triangulated.
  std::vector<std::array<std::uint32_t, 3>> triangles() const {
    std::vector<std::array<std::uint32_t, 3>> all;
    for (const auto& [a, b, c, d] : faces) {
      all.push_back({a, b, c});
      all.push_back({a, c, d});
    }
    return all;
  }

  std::string obj() const {
    std::string text;
    for (const auto& p : positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const auto& [a, b, c, d] : faces) text += fmt::format("f {} {} {} {}\n", a + 1, b + 1, c + 1, d + 1);
    return text;
  }

  std::string ply_header(const std::string& format) const {
    return fmt::format(
        "ply\nformat {} 1.0\ncomment a cube\nelement vertex {}\nproperty float x\nproperty float y\n"
        "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        format, positions.size(), faces.size());
  }
  std::string ply_text() const {
    auto text = ply_header("ascii");
    for (const auto& p : positions) text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    for (const auto& [a, b, c, d] : faces) text += fmt::format("4 {} {} {} {}\n", a, b, c, d);
    return text;
  }
  std::string ply_binary(bool big_endian) const {
    auto bytes = ply_header(big_endian ? "binary_big_endian" : "binary_little_endian");
    const auto put = [&](auto value) {
      std::array<char, sizeof(value)> raw;
      std::memcpy(raw.data(), &value, sizeof(value));
      if (big_endian) std::reverse(raw.begin(), raw.end());
      bytes.append(raw.data(), raw.size());
    };
    for (const auto& p : positions)
      for (int i = 0; i < 3; ++i) put(p[i]);
    for (const auto& face : faces) {
      put(std::uint8_t{4});
      for (const auto index : face) put(static_cast<std::int32_t>(index));
    }
    return bytes;
  }

  std::string stl_text(const std::string& name) const {
    auto text = "solid " + name + "\n";
    for (const auto& triangle : triangles()) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const auto i : triangle)
        text += fmt::format("vertex {} {} {}\n", positions[i].x, positions[i].y, positions[i].z);
      text += "endloop\nendfacet\n";
    }
    return text + "endsolid " + name + "\n";
  }
  std::string stl_binary(const std::string& header = "solid by a careless writer") const {
    auto bytes = header;
    bytes.resize(80);
    const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
    put(static_cast<std::uint32_t>(triangles().size()));
    for (const auto& triangle : triangles()) {
      for (int i = 0; i < 3; ++i) put(0.0f);
      for (const auto i : triangle)
        for (int axis = 0; axis < 3; ++axis) put(positions[i][axis]);
      put(std::uint16_t{0});
    }
    return bytes;
  }
};

}  // namespace luxel
