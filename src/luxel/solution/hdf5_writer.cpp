// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/hdf5_writer.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>
#include <hdf5.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr std::size_t max_compact = 4096;    // bytes; such an array is stored in its header (64 KiB at most)
constexpr std::size_t chunk_size = 1 << 19;  // bytes; two fit into HDF5's default chunk cache

void require(bool success, const std::string& what) {
  if (!success) throw DeviceError(fmt::format("the HDF5 library failed to make {}: {}", what, hdf5_reason()));
}

Hdf5Handle require(Hdf5Id id, Hdf5Handle::Closer closer, const std::string& what) {
  require(id >= 0, what);
  return Hdf5Handle(id, closer);
}

Hdf5Handle properties(Hdf5Id list_class) {
  return require(H5Pcreate(list_class), H5Pclose, "a property list");
}

// Without time stamps, which would make two runs differ.
Hdf5Handle properties_without_times(Hdf5Id list_class) {
  auto list = properties(list_class);
  require(H5Pset_obj_track_times(list.id(), false) >= 0, "a file without time stamps");
  return list;
}

Hdf5Handle space_of(std::size_t rows, std::size_t columns) {
  const std::array<hsize_t, 2> shape = {rows, columns};
  return require(H5Screate_simple(columns > 0 ? 2 : 1, shape.data(), nullptr), H5Sclose, "a shape");
}

Hdf5Handle string_type(std::size_t length, H5T_cset_t letters) {
  auto type = require(H5Tcopy(H5T_C_S1), H5Tclose, "a type of string");
  require(H5Tset_size(type.id(), std::max<std::size_t>(length, 1)) >= 0 &&
              H5Tset_strpad(type.id(), H5T_STR_NULLPAD) >= 0 && H5Tset_cset(type.id(), letters) >= 0,
          "a type of string");
  return type;
}

void set_storage(Hdf5Id list, std::size_t rows, std::size_t columns, std::size_t element_size,
                 unsigned deflate) {
  const auto row_size = std::max<std::size_t>(columns, 1) * element_size;
  if (rows * row_size <= max_compact) {
    require(H5Pset_layout(list, H5D_COMPACT) >= 0, "a compact array");
    return;
  }
  const std::array<hsize_t, 2> chunk = {std::clamp<std::size_t>(chunk_size / row_size, 1, rows), columns};
  bool is_set = H5Pset_chunk(list, columns > 0 ? 2 : 1, chunk.data()) >= 0;
  if (deflate > 0) is_set = is_set && H5Pset_shuffle(list) >= 0 && H5Pset_deflate(list, deflate) >= 0;
  require(is_set && H5Pset_fletcher32(list) >= 0, "an array in chunks");
}

// Takes the memory image when the library closes the file, instead of copying it before (H5Fget_file_image):
// while the file is open its first block is marked as open, and the library's copy lacks that mark but has
// the checksum of the block with it, so it cannot be opened (HDF5 1.10.8).
herr_t keep_image(void* bytes, H5FD_file_image_op_t operation, void* keeper) {
  if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE)
    static_cast<Hdf5Image*>(keeper)->reset(bytes);
  else
    std::free(bytes);
  return 0;
}

void* grow_image(void* bytes, std::size_t size, H5FD_file_image_op_t, void*) {
  return std::realloc(bytes, size);
}

// The library requires its own copy of the pointer to the keeper.
void* same_keeper(void* keeper) { return keeper; }
herr_t forget_keeper(void*) { return 0; }

}  // namespace

Hdf5Writer::Hdf5Writer(unsigned deflate) : deflate_(deflate) {
  constexpr std::size_t growth = 1 << 22;  // bytes
  const auto access = properties(H5P_FILE_ACCESS);
  H5FD_file_image_callbacks_t keep = {nullptr,     nullptr,       grow_image, keep_image,
                                      same_keeper, forget_keeper, &image_};
  require(H5Pset_fapl_core(access.id(), growth, false) >= 0 &&
              H5Pset_file_image_callbacks(access.id(), &keep) >= 0 &&
              H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0,
          "a file in memory");
  const auto creation = properties_without_times(H5P_FILE_CREATE);
  // The name is only for the library's own list of open files.
  file_ = require(H5Fcreate("luxel-solution", H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose,
                  "a file in memory");
}

void Hdf5Writer::add_group(const std::string& name) {
  const auto creation = properties_without_times(H5P_GROUP_CREATE);
  require(H5Gcreate2(file_.id(), name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose, name);
}

void Hdf5Writer::add_attribute(const std::string& group, const std::string& name, const Hdf5Array& values) {
  const auto scalar = values.rows == 1 && values.columns == 0;
  const auto space =
      scalar ? require(H5Screate(H5S_SCALAR), H5Sclose, "a shape") : space_of(values.rows, values.columns);
  const auto attribute =
      require(H5Acreate_by_name(file_.id(), group.c_str(), name.c_str(), hdf5_file_type(values.element),
                                space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
              H5Aclose, name);
  require(H5Awrite(attribute.id(), hdf5_memory_type(values.element), values.data) >= 0, name);
}

void Hdf5Writer::add_word(const std::string& object, const std::string& name, const std::string& word) {
  const auto type = string_type(word.size(), H5T_CSET_ASCII);
  const auto space = require(H5Screate(H5S_SCALAR), H5Sclose, "a shape");
  const auto attribute = require(H5Acreate_by_name(file_.id(), object.c_str(), name.c_str(), type.id(),
                                                   space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                 H5Aclose, name);
  require(H5Awrite(attribute.id(), type.id(), word.data()) >= 0, name);
}

void Hdf5Writer::add_array(const std::string& name, const Hdf5Array& values, const std::string& unit) {
  add_dataset(name, hdf5_file_type(values.element), hdf5_memory_type(values.element), values);
  if (!unit.empty()) add_word(name, "unit", unit);
}

void Hdf5Writer::add_strings(const std::string& name, std::span<const std::string> strings) {
  std::size_t longest = 1;
  for (const auto& string : strings) longest = std::max(longest, string.size());
  std::string bytes;
  bytes.reserve(strings.size() * longest);
  for (const auto& string : strings) {
    bytes += string;
    std::replace(bytes.end() - static_cast<std::ptrdiff_t>(string.size()), bytes.end(), '\0', '?');
    bytes.resize(bytes.size() + longest - string.size(), '\0');
  }
  const auto type = string_type(longest, H5T_CSET_UTF8);
  add_dataset(name, type.id(), type.id(), {Hdf5Element::uint8, bytes.data(), strings.size(), 0});
}

void Hdf5Writer::add_dataset(const std::string& name, Hdf5Id file_type, Hdf5Id memory_type,
                             const Hdf5Array& values) {
  const auto creation = properties_without_times(H5P_DATASET_CREATE);
  set_storage(creation.id(), values.rows, values.columns, H5Tget_size(file_type), deflate_);
  const auto space = space_of(values.rows, values.columns);
  const auto dataset = require(
      H5Dcreate2(file_.id(), name.c_str(), file_type, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
      H5Dclose, name);
  if (values.rows > 0)
    require(H5Dwrite(dataset.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data) >= 0, name);
}

std::string_view Hdf5Writer::finish() {
  require(H5Fflush(file_.id(), H5F_SCOPE_LOCAL) >= 0, "the file");
  const auto size = H5Fget_file_image(file_.id(), nullptr, 0);
  require(size > 0 && file_.close() && image_, "the file");
  return {static_cast<const char*>(image_.get()), static_cast<std::size_t>(size)};
}

void FreeHdf5Image::operator()(void* bytes) const { std::free(bytes); }

}  // namespace luxel
