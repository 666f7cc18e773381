// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace luxel {

enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };
enum class PlyEncoding { ascii, little_endian, big_endian };

std::size_t size_of(PlyType type);  // bytes
inline bool is_whole(PlyType type) { return type != PlyType::f32 && type != PlyType::f64; }

// A number of each element, or a list of numbers behind their count.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::f32;
  bool is_list = false;
  PlyType count_type = PlyType::u8;
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::size_t line = 0;  // of the declaration
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;   // in the order of their data
  std::vector<std::string> textures;  // file names of the comments TextureFile, as MeshLab writes them
  std::size_t size = 0;               // bytes, up to the data
  std::size_t lines = 0;
};

// Reads the header of a PLY file. Throws InputError with source and line where it is damaged.
PlyHeader read_ply_header(std::string_view bytes, const std::string& source);

}  // namespace luxel
