// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace luxel {

// A NumPy array of numbers that owner holds: no copy, read-only, and owner lives as long as the array.
template <typename Number>
pybind11::array view_of(const Number* data, std::vector<pybind11::ssize_t> shape, pybind11::handle owner) {
  pybind11::array_t<Number> array(std::move(shape), data, owner);
  array.attr("setflags")(false);
  return array;
}

// Such an array of a vector of numbers, or of structs of `width` numbers each.
template <typename Element>
pybind11::array view_of(const std::vector<Element>& values, pybind11::handle owner) {
  return view_of(values.data(), {static_cast<pybind11::ssize_t>(values.size())}, owner);
}

template <typename Number, typename Element>
pybind11::array rows_of(const std::vector<Element>& values, pybind11::handle owner) {
  constexpr auto width = sizeof(Element) / sizeof(Number);
  static_assert(width * sizeof(Number) == sizeof(Element));
  return view_of(reinterpret_cast<const Number*>(values.data()),
                 {static_cast<pybind11::ssize_t>(values.size()), static_cast<pybind11::ssize_t>(width)},
                 owner);
}

// [row][column] of a flat vector.
template <typename Number>
pybind11::array table_of(const std::vector<Number>& values, std::size_t columns, pybind11::handle owner) {
  const auto rows = columns == 0 ? 0 : values.size() / columns;
  return view_of(values.data(),
                 {static_cast<pybind11::ssize_t>(rows), static_cast<pybind11::ssize_t>(columns)}, owner);
}

// A NumPy array that takes over the numbers of a vector: no copy, and read-only as all arrays here.
template <typename Number>
pybind11::array taken(std::vector<Number> values, std::vector<pybind11::ssize_t> shape = {}) {
  auto* kept = new std::vector<Number>(std::move(values));
  const pybind11::capsule owner(kept, [](void* p) { delete static_cast<std::vector<Number>*>(p); });
  if (shape.empty()) shape = {static_cast<pybind11::ssize_t>(kept->size())};
  return view_of(kept->data(), std::move(shape), owner);
}

}  // namespace luxel
