// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "luxel/solution/hdf5_element.h"
#include "luxel/solution/hdf5_handle.h"

namespace luxel {

// Reads an untrusted HDF5 file: types, shapes and the storage that a declared shape takes in the file are
// checked before memory is allocated. Names are paths from the root. Throws FormatError, naming the file and
// the object, where an object differs from the expected one; other content of the file is ignored.
class Hdf5Reader {
 public:
  // Throws InputError where there is no such file, FormatError where it is not HDF5 or is cut short.
  explicit Hdf5Reader(std::filesystem::path path);

  // Renames datasets and attributes: pairs of the expected name and the name in this file, both without the
  // path. Applies to all later calls. Keeps the span.
  using Renamed = std::span<const std::pair<std::string_view, std::string_view>>;
  void use_names(Renamed renamed) { renamed_ = renamed; }

  // Returns whether there is such a group or dataset, in a group that exists; such an attribute of a group.
  bool has(const std::string& name) const;
  bool has_attribute(const std::string& group, const std::string& name) const;

  // A scalar attribute of a group.
  template <typename T>
  T number(const std::string& group, const std::string& name) const {
    T value = {};
    read_number(group, name, hdf5_element<T>(), &value);
    return value;
  }
  std::string word(const std::string& group, const std::string& name) const;

  // The length of the dataset's first dimension.
  std::size_t rows(const std::string& name) const;
  // The dataset, which must have exactly this shape; columns as in Hdf5Array.
  template <typename T>
  std::vector<T> array(const std::string& name, std::size_t rows, std::size_t columns = 0) const {
    const auto dataset = open_array(name, hdf5_element<T>(), rows, columns);
    std::vector<T> values(rows * (columns > 0 ? columns : 1));
    read_array(dataset, name, hdf5_element<T>(), values.data());
    return values;
  }
  std::vector<Vec3> vectors(const std::string& name, std::size_t rows) const;
  std::vector<std::string> strings(const std::string& name, std::size_t rows) const;

  [[noreturn]] void refuse(const std::string& sentence) const;
  [[noreturn]] void refuse_as_damaged(const std::string& sentence) const;

 private:
  std::string name_in_file(const std::string& name) const;
  void check_links(const std::string& name) const;
  Hdf5Handle open_attribute(const std::string& group, const std::string& name) const;
  void read_number(const std::string& group, const std::string& name, Hdf5Element element, void* value) const;
  Hdf5Handle open_dataset(const std::string& asked) const;
  std::vector<std::size_t> shape(const Hdf5Handle& dataset, const std::string& name) const;
  void check_shape(const Hdf5Handle& dataset, const std::string& name, std::size_t rows,
                   std::size_t columns) const;
  void check_storage(const Hdf5Handle& dataset, const std::string& name, std::size_t rows,
                     std::size_t row_size) const;
  Hdf5Handle open_array(const std::string& name, Hdf5Element element, std::size_t rows,
                        std::size_t columns) const;
  void read_array(const Hdf5Handle& dataset, const std::string& name, Hdf5Element element,
                  void* values) const;

  Hdf5Silence silence_;
  std::string path_;
  std::size_t file_size_ = 0;        // bytes
  mutable std::size_t claimed_ = 0;  // bytes, of the arrays that were opened
  Hdf5Handle file_;
  Renamed renamed_;
};

}  // namespace luxel
