// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/hdf5_element.h"

#include <hdf5.h>

namespace luxel {
namespace {

struct Types {
  std::size_t size;
  Hdf5Id memory;
  Hdf5Id file;
};

// HDF5's type names are calls that start the library, so this is a function, not a table.
Types types_of(Hdf5Element element) {
  switch (element) {
    case Hdf5Element::float32:
      return {4, H5T_NATIVE_FLOAT, H5T_IEEE_F32LE};
    case Hdf5Element::float64:
      return {8, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE};
    case Hdf5Element::uint8:
      return {1, H5T_NATIVE_UINT8, H5T_STD_U8LE};
    case Hdf5Element::uint32:
      return {4, H5T_NATIVE_UINT32, H5T_STD_U32LE};
    case Hdf5Element::uint64:
      return {8, H5T_NATIVE_UINT64, H5T_STD_U64LE};
    case Hdf5Element::int64:
      break;
  }
  return {8, H5T_NATIVE_INT64, H5T_STD_I64LE};
}

}  // namespace

std::size_t size_of(Hdf5Element element) { return types_of(element).size; }
Hdf5Id hdf5_memory_type(Hdf5Element element) { return types_of(element).memory; }
Hdf5Id hdf5_file_type(Hdf5Element element) { return types_of(element).file; }

}  // namespace luxel
