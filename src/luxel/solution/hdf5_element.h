// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/solution/hdf5_handle.h"

namespace luxel {

// The numbers that our files hold; little-endian there, the host's own in memory.
enum class Hdf5Element { float32, float64, uint8, uint32, uint64, int64 };

std::size_t size_of(Hdf5Element element);  // bytes
Hdf5Id hdf5_memory_type(Hdf5Element element);
Hdf5Id hdf5_file_type(Hdf5Element element);

template <typename T>
constexpr Hdf5Element hdf5_element() {
  if constexpr (std::is_enum_v<T>) {
    return hdf5_element<std::underlying_type_t<T>>();
  } else if constexpr (std::is_same_v<T, float>) {
    return Hdf5Element::float32;
  } else if constexpr (std::is_same_v<T, double>) {
    return Hdf5Element::float64;
  } else if constexpr (std::is_same_v<T, std::uint8_t>) {
    return Hdf5Element::uint8;
  } else if constexpr (std::is_same_v<T, std::uint32_t>) {
    return Hdf5Element::uint32;
  } else if constexpr (std::is_same_v<T, std::uint64_t>) {
    return Hdf5Element::uint64;
  } else {
    static_assert(std::is_same_v<T, std::int64_t>);
    return Hdf5Element::int64;
  }
}

// Numbers to write, row by row. No columns means a flat array: one dimension in the file instead of two.
struct Hdf5Array {
  Hdf5Element element = Hdf5Element::float32;
  const void* data = nullptr;
  std::size_t rows = 0;
  std::size_t columns = 0;
};

template <typename T>
Hdf5Array flat_array(std::span<const T> values) {
  return {hdf5_element<T>(), values.data(), values.size(), 0};
}

template <typename T>
Hdf5Array table(std::span<const T> values, std::size_t rows, std::size_t columns) {
  return {hdf5_element<T>(), values.data(), rows, columns};
}

inline Hdf5Array vectors(std::span<const Vec3> values) {
  static_assert(sizeof(Vec3) == 3 * sizeof(float));
  return {Hdf5Element::float32, values.data(), values.size(), 3};
}

// Whole vectors as such arrays: flat, and in rows of some columns.
template <typename T>
Hdf5Array flat(const std::vector<T>& values) {
  return flat_array(std::span<const T>(values));
}
template <typename T>
Hdf5Array rows_of(const std::vector<T>& values, std::size_t columns) {
  return table(std::span<const T>(values), values.size() / columns, columns);
}

}  // namespace luxel
