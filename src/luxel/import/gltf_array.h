// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "luxel/import/gltf_file.h"

namespace luxel {

// An accessor of a glTF file: a typed array that lies in its bytes, with another one of replaced elements
// where it is sparse. All ranges are checked when it is made, so that elements are read without checks.
// Nothing is copied; valid as long as the file.
class GltfArray {
 public:
  // Limit for an accessor without a bufferView, which is all zeros and may declare any count.
  static constexpr std::size_t max_zeros = std::size_t{1} << 20;

  // index is the JSON value that names the accessor, as primitive["indices"]. fewest, most: bounds of the
  // components per element (of vectors and scalars; matrices are refused). Throws InputError where the file's
  // bytes do not match the accessor.
  GltfArray(GltfFile& file, const JsonValue& index, int fewest, int most);

  std::size_t size() const { return count_; }
  int components() const { return components_; }
  // Reads unsigned integers, such as indices.
  bool is_unsigned() const { return type_ == Type::u8 || type_ == Type::u16 || type_ == Type::u32; }
  const JsonValue& accessor() const { return accessor_; }

  // An element: whole numbers that are normalised become [0, 1] or [-1, 1], missing components are 0.
  std::array<float, 4> at(std::size_t element) const;
  // The first component of an element of an unsigned array.
  std::uint32_t index_at(std::size_t element) const;

 private:
  enum class Type { i8, u8, i16, u16, u32, f32 };
  struct Bytes {
    std::string_view all;
    std::size_t stride = 0;
    const char* at(std::size_t element) const { return all.data() + element * stride; }
  };

  static Type type_of(const JsonValue& component_type);
  static std::size_t size_of(Type type);  // bytes
  static Bytes bytes_of(GltfFile& file, const JsonValue& owner, std::size_t count, std::size_t element);
  static std::uint32_t whole(const char* place, Type type);
  void read_sparse(GltfFile& file, const JsonValue& sparse);
  const char* place_of(std::size_t element) const;  // nothing: zeros
  float component(const char* place, int number) const;

  JsonValue accessor_;
  Type type_ = Type::f32;
  int components_ = 1;
  bool normalised_ = false;
  std::size_t count_ = 0;
  Bytes dense_;               // empty where there is no bufferView
  std::size_t replaced_ = 0;  // how many elements are
  Bytes replaced_indices_, replacements_;
  Type index_type_ = Type::u32;
};

}  // namespace luxel
