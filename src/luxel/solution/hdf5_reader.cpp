// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/hdf5_reader.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include <fmt/format.h>
#include <hdf5.h>

#include "luxel/core/error.h"

namespace luxel {
namespace fs = std::filesystem;
namespace {

// Deflate packs 1,032 bytes into one at best (zlib, "Maximum Compression Factor"), which bounds the size of a
// dataset by its storage in the file.
constexpr std::size_t max_bytes_per_stored_byte = 1040;
// All arrays of a file over its size. Measured: 3 to 5 of lit scenes, 18 of one whose surfaces are black but
// one, with all replicates at most 90.
constexpr std::size_t max_expansion = 128;
constexpr std::size_t always_read = std::size_t{16} << 20;  // bytes of arrays, however small the file
constexpr double max_chunk = 64 << 20;                      // bytes; Luxel's are far smaller
constexpr std::size_t longest_word = 256;                   // bytes

void check_is_readable(const fs::path& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (!fs::exists(status)) throw InputError(path.string(), "there is no such file");
  if (fs::is_directory(status)) throw InputError(path.string(), "it is a folder, expected a solution file");
  if (!fs::is_regular_file(status)) throw InputError(path.string(), "it is not a plain file");
  errno = 0;
  if (!std::ifstream(path))
    throw InputError(path.string(), fmt::format("cannot read it: {}", std::strerror(errno)));
}

bool has_small_chunks(Hdf5Id creation, Hdf5Id type) {
  std::array<hsize_t, 2> chunk = {0, 1};
  H5Pget_chunk(creation, 2, chunk.data());
  // In floating point, where no product of lengths overflows.
  return static_cast<double>(chunk[0]) * static_cast<double>(chunk[1]) *
             static_cast<double>(H5Tget_size(type)) <=
         max_chunk;
}

}  // namespace

Hdf5Reader::Hdf5Reader(fs::path path) : path_(path.string()) {
  check_is_readable(path);
  file_size_ = fs::file_size(path);
  const auto is_hdf5 = H5Fis_hdf5(path.c_str());
  if (is_hdf5 <= 0) refuse("not a Luxel solution, or its beginning is damaged (it is not an HDF5 file)");
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // Many network and read-only disks cannot lock, and a file that is renamed into place needs no lock.
  H5Pset_file_locking(access.id(), false, true);
  file_ = Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
  if (!file_.is_open()) refuse_as_damaged(fmt::format("it cannot be opened ({})", hdf5_reason()));
}

void Hdf5Reader::refuse(const std::string& sentence) const { throw FormatError(path_, sentence); }

void Hdf5Reader::refuse_as_damaged(const std::string& sentence) const { refuse("damaged: " + sentence); }

std::string Hdf5Reader::name_in_file(const std::string& name) const {
  const auto begin = name.rfind('/') + 1;  // 0 for a name without a path
  for (const auto& [asked, stored] : renamed_)
    if (name.compare(begin, std::string::npos, asked) == 0)
      return name.substr(0, begin) + std::string(stored);
  return name;
}

bool Hdf5Reader::has(const std::string& name) const {
  const auto exists = H5Lexists(file_.id(), name_in_file(name).c_str(), H5P_DEFAULT);
  if (exists < 0) refuse_as_damaged(fmt::format("'{}' cannot be looked up ({})", name, hdf5_reason()));
  return exists > 0;
}

bool Hdf5Reader::has_attribute(const std::string& group, const std::string& name) const {
  const auto exists = H5Aexists_by_name(file_.id(), group.c_str(), name_in_file(name).c_str(), H5P_DEFAULT);
  if (exists < 0)
    refuse_as_damaged(fmt::format("the attributes of '{}' cannot be read ({})", group, hdf5_reason()));
  return exists > 0;
}

// Refuses links, which could lead into another file; Luxel's files have none.
void Hdf5Reader::check_links(const std::string& name) const {
  for (auto end = name.find('/');; end = name.find('/', end + 1)) {
    const auto part = name.substr(0, end);
    const auto exists = H5Lexists(file_.id(), part.c_str(), H5P_DEFAULT);
    if (exists < 0) refuse_as_damaged(fmt::format("'{}' cannot be looked up ({})", part, hdf5_reason()));
    if (exists == 0) refuse_as_damaged(fmt::format("'{}' is missing", part));
    H5L_info_t link = {};
    if (H5Lget_info(file_.id(), part.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD)
      refuse_as_damaged(fmt::format("'{}' is a link to elsewhere", part));
    if (end == std::string::npos) return;
  }
}

Hdf5Handle Hdf5Reader::open_attribute(const std::string& group, const std::string& name) const {
  check_links(group);
  Hdf5Handle attribute(
      H5Aopen_by_name(file_.id(), group.c_str(), name_in_file(name).c_str(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  if (!attribute.is_open())
    refuse_as_damaged(
        fmt::format("attribute '{}' of '{}' is missing or cannot be read ({})", name, group, hdf5_reason()));
  const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (!space.is_open() || H5Sget_simple_extent_npoints(space.id()) != 1)
    refuse_as_damaged(fmt::format("attribute '{}' of '{}' is not a single value", name, group));
  return attribute;
}

void Hdf5Reader::read_number(const std::string& group, const std::string& name, Hdf5Element element,
                             void* value) const {
  const auto attribute = open_attribute(group, name);
  const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  if (!type.is_open() || H5Tequal(type.id(), hdf5_file_type(element)) <= 0)
    refuse_as_damaged(fmt::format("attribute '{}' of '{}' is of an unexpected type", name, group));
  if (H5Aread(attribute.id(), hdf5_memory_type(element), value) < 0)
    refuse_as_damaged(fmt::format("attribute '{}' of '{}' cannot be read ({})", name, group, hdf5_reason()));
}

std::string Hdf5Reader::word(const std::string& group, const std::string& name) const {
  const auto attribute = open_attribute(group, name);
  const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  if (!type.is_open() || H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0 ||
      H5Tget_size(type.id()) > longest_word)
    refuse_as_damaged(fmt::format("attribute '{}' of '{}' is not a short word", name, group));
  std::string word(H5Tget_size(type.id()), '\0');
  if (H5Aread(attribute.id(), type.id(), word.data()) < 0)
    refuse_as_damaged(fmt::format("attribute '{}' of '{}' cannot be read ({})", name, group, hdf5_reason()));
  return word.substr(0, word.find('\0'));
}

Hdf5Handle Hdf5Reader::open_dataset(const std::string& asked) const {
  const auto name = name_in_file(asked);
  check_links(name);
  Hdf5Handle dataset(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.is_open())
    refuse_as_damaged(fmt::format("dataset '{}' cannot be opened ({})", name, hdf5_reason()));
  return dataset;
}

std::vector<std::size_t> Hdf5Reader::shape(const Hdf5Handle& dataset, const std::string& name) const {
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const auto rank = space.is_open() ? H5Sget_simple_extent_ndims(space.id()) : -1;
  std::array<hsize_t, 2> lengths = {};
  if (rank < 1 || rank > 2 || H5Sget_simple_extent_dims(space.id(), lengths.data(), nullptr) != rank)
    refuse_as_damaged(fmt::format("dataset '{}' is neither a list nor a table", name));
  return {lengths.begin(), lengths.begin() + rank};
}

std::size_t Hdf5Reader::rows(const std::string& name) const { return shape(open_dataset(name), name)[0]; }

void Hdf5Reader::check_shape(const Hdf5Handle& dataset, const std::string& name, std::size_t rows,
                             std::size_t columns) const {
  const auto found = shape(dataset, name);
  const auto expected = columns > 0 ? std::vector{rows, columns} : std::vector{rows};
  if (found != expected)
    refuse_as_damaged(fmt::format("dataset '{}' is of shape [{}], expected [{}]", name,
                                  fmt::join(found, ", "), fmt::join(expected, ", ")));
}

// Checks, before memory is allocated, that the file can hold this much and holds it itself.
void Hdf5Reader::check_storage(const Hdf5Handle& dataset, const std::string& name, std::size_t rows,
                               std::size_t row_size) const {
  const Hdf5Handle creation(H5Dget_create_plist(dataset.id()), H5Pclose);
  const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const auto layout = creation.is_open() ? H5Pget_layout(creation.id()) : H5D_LAYOUT_ERROR;
  const auto ordinary = layout == H5D_COMPACT || layout == H5D_CONTIGUOUS ||
                        (layout == H5D_CHUNKED && has_small_chunks(creation.id(), type.id()));
  if (!ordinary || H5Pget_external_count(creation.id()) != 0)
    refuse_as_damaged(fmt::format("dataset '{}' is stored in an unexpected way", name));
  const auto stored = std::min(file_size_, std::size_t{H5Dget_storage_size(dataset.id())});
  if (rows > 0 && stored * max_bytes_per_stored_byte / rows < row_size)
    refuse_as_damaged(
        fmt::format("dataset '{}' claims {} rows but only {} bytes of it are there", name, rows, stored));
  claimed_ += rows * row_size;
  if (claimed_ > always_read + max_expansion * file_size_)
    refuse_as_damaged(fmt::format(
        "its arrays claim {:.0f} MB up to '{}', more than a file of {:.1f} MB can hold of a solution",
        1e-6 * static_cast<double>(claimed_), name, 1e-6 * static_cast<double>(file_size_)));
}

Hdf5Handle Hdf5Reader::open_array(const std::string& name, Hdf5Element element, std::size_t rows,
                                  std::size_t columns) const {
  auto dataset = open_dataset(name);
  const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose);
  if (!type.is_open() || H5Tequal(type.id(), hdf5_file_type(element)) <= 0)
    refuse_as_damaged(fmt::format("dataset '{}' is of an unexpected type", name));
  check_shape(dataset, name, rows, columns);
  check_storage(dataset, name, rows, (columns > 0 ? columns : 1) * size_of(element));
  return dataset;
}

void Hdf5Reader::read_array(const Hdf5Handle& dataset, const std::string& name, Hdf5Element element,
                            void* values) const {
  if (H5Dread(dataset.id(), hdf5_memory_type(element), H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
    refuse_as_damaged(fmt::format("dataset '{}' cannot be read ({})", name, hdf5_reason()));
}

std::vector<Vec3> Hdf5Reader::vectors(const std::string& name, std::size_t rows) const {
  const auto dataset = open_array(name, Hdf5Element::float32, rows, 3);
  std::vector<Vec3> values(rows);
  read_array(dataset, name, Hdf5Element::float32, values.data());
  return values;
}

std::vector<std::string> Hdf5Reader::strings(const std::string& name, std::size_t rows) const {
  const auto dataset = open_dataset(name);
  const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose);
  if (!type.is_open() || H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0)
    refuse_as_damaged(fmt::format("dataset '{}' does not hold strings of fixed length", name));
  const auto length = H5Tget_size(type.id());
  check_shape(dataset, name, rows, 0);
  check_storage(dataset, name, rows, length);
  std::string bytes(rows * length, '\0');
  if (H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0)
    refuse_as_damaged(fmt::format("dataset '{}' cannot be read ({})", name, hdf5_reason()));
  std::vector<std::string> strings;
  for (std::size_t i = 0; i < rows; ++i) {
    const auto whole = bytes.substr(i * length, length);
    strings.push_back(whole.substr(0, whole.find('\0')));
  }
  return strings;
}

}  // namespace luxel
