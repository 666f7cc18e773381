// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "luxel/solution/hdf5_element.h"
#include "luxel/solution/hdf5_handle.h"

namespace luxel {

struct FreeHdf5Image {
  void operator()(void* bytes) const;
};
using Hdf5Image = std::unique_ptr<void, FreeHdf5Image>;

// Builds an HDF5 file in memory, so that errors of the disk occur in one place, later. The same calls give
// the same bytes: no time stamps, one fixed file format (that of HDF5 1.10). Every relevant byte is covered
// by a checksum: the 1.10 format has one over each header and index, small arrays stand inside the headers,
// larger ones are cut into chunks with a Fletcher-32 each. Names are paths from the root: "VTKHDF/CellData".
// Throws DeviceError where the library fails (no memory).
class Hdf5Writer {
 public:
  // deflate: 1 (fast) to 9 (small); 0 stores large arrays as they are, still with checksums.
  explicit Hdf5Writer(unsigned deflate = 4);
  // Sets the compression of the arrays that follow.
  void set_deflate(unsigned deflate) { deflate_ = deflate; }

  void add_group(const std::string& name);
  // An attribute of a group: numbers, a number, or an ASCII word.
  void add_attribute(const std::string& group, const std::string& name, const Hdf5Array& values);
  template <typename T>
  void add_number(const std::string& group, const std::string& name, T value) {
    add_attribute(group, name, flat_array(std::span<const T>(&value, 1)));
  }
  void add_word(const std::string& object, const std::string& name, const std::string& word);
  // A dataset of numbers; the unit, if any, becomes its attribute "unit".
  void add_array(const std::string& name, const Hdf5Array& values, const std::string& unit = {});
  // A dataset of strings as long as the longest. A byte 0, which the file cannot hold, becomes '?'.
  void add_strings(const std::string& name, std::span<const std::string> strings);

  // The whole file, which lives as long as the writer; the last call.
  std::string_view finish();

 private:
  void add_dataset(const std::string& name, Hdf5Id file_type, Hdf5Id memory_type, const Hdf5Array& values);

  unsigned deflate_;
  Hdf5Silence silence_;
  Hdf5Image image_;  // empty until the file is closed, which must be before this goes
  Hdf5Handle file_;
};

}  // namespace luxel
