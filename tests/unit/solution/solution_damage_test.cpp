// SPDX-License-Identifier: Apache-2.0
// Damaged and wrong files. Where HDF5 itself is needed to make one, it is used directly.
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <hdf5.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/solution/solution_file.h"

#include "support/sample_solution.h"

// HDF5 1.10.8 loses a few hundred bytes over a damaged header. Only the leak sanitizer asks for this.
extern "C" const char* __lsan_default_suppressions();   // NOLINT(readability-identifier-naming)
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(readability-identifier-naming)
  return "leak:libhdf5";
}

namespace luxel {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& path, std::string_view bytes) {
  fs::remove(path);  // some file systems flush a file to the disk when it is overwritten
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

class DamagedSolution : public testing::Test {
 protected:
  // The error of reading; empty where the file reads as it was.
  std::string complaint() const {
    try {
      const auto found = read_solution(path_);
      EXPECT_EQ(sample::difference(found.patches, written_.patches), "");
      EXPECT_EQ(sample::difference(found.solution, written_.solution), "");
    } catch (const FormatError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find(path_.string() + ": "), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message.substr(std::min(message.size(), path_.string().size() + 2));
    }
    return {};
  }

  void damage_at(std::size_t position, unsigned char bits) {
    auto bytes = whole_;
    bytes[position] = static_cast<char>(bytes[position] ^ bits);
    put(path_, bytes);
    SCOPED_TRACE(position);
    complaints_ += complaint().empty() ? 0 : 1;
    ++attempts_;
  }

  // Damage everywhere: single bits, in turn, and whole bytes.
  void damage_every(std::size_t stride) {
    for (std::size_t i = 0; i < whole_.size(); i += stride)
      damage_at(i, static_cast<unsigned char>(i % 3 == 0 ? 0xffu : 1u << (i % 8)));
  }

  void cut_at_every(std::size_t stride) {
    for (std::size_t length = 0; length < whole_.size(); length += stride) {
      put(path_, std::string_view(whole_).substr(0, length));
      SCOPED_TRACE(length);
      EXPECT_NE(complaint(), "");
    }
    put(path_, std::string_view(whole_).substr(0, whole_.size() - 1));
    EXPECT_NE(complaint(), "");
  }

  // A file to change with HDF5 itself, which is closed before it is read.
  std::string complaint_after(const std::function<void(hid_t)>& change) {
    put(path_, whole_);
    const auto file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    EXPECT_GE(file, 0);
    change(file);
    EXPECT_GE(H5Fclose(file), 0);
    return complaint();
  }

  void make(std::size_t patches) { make(sample::baked(patches, 3)); }

  void make(Baked sample) {
    written_ = std::move(sample);
    write_solution(path_, written_.patches, written_.solution);
    whole_ = read_file(path_);
  }

  fs::path path_ = fs::path(testing::TempDir()) / "damaged.vtkhdf";
  Baked written_;
  std::string whole_;
  int attempts_ = 0;
  int complaints_ = 0;
};

void replace_dataset(hid_t file, const char* name, hid_t type, const std::vector<hsize_t>& shape,
                     const void* values) {
  if (H5Lexists(file, name, H5P_DEFAULT) > 0) H5Ldelete(file, name, H5P_DEFAULT);
  const auto space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  const auto set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(set, 0);
  EXPECT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), 0);
  H5Dclose(set);
  H5Sclose(space);
}

TEST_F(DamagedSolution, a_small_file_with_any_byte_changed_is_refused_or_read_as_it_was) {
  make(4);
  damage_every(13);
  EXPECT_GT(attempts_, 500);
  EXPECT_GT(complaints_, attempts_ / 2);
}

TEST_F(DamagedSolution, standard_errors_with_any_byte_changed_are_refused_or_read_as_they_were) {
  make(sample::baked_with_errors(4, 3));
  damage_every(17);
  EXPECT_GT(attempts_, 500);
  EXPECT_GT(complaints_, attempts_ / 2);
}

TEST_F(DamagedSolution, panes_that_cannot_be_are_named) {
  auto sample = sample::baked(4, 3);
  auto& patches = sample.patches;
  patches.materials[1].transmittance = {0.5f, 0.8f, 1.0f};
  patches.panes = {{{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}}, {0, 1, 0}, MaterialId{1}, 1.0f}};
  make(sample);
  const std::vector<float> exponents = {0.7f}, transmittances = {1.0f, 1.0f, 1.0f, 0.5f, 1.5f, 1.0f};
  EXPECT_EQ(complaint_after([&](hid_t file) {
              replace_dataset(file, "Luxel/panes/exponent", H5T_NATIVE_FLOAT, {1}, exponents.data());
            }),
            "damaged: the axis of a pane is no unit vector, or its exponent is neither 1 nor 0.5");
  EXPECT_EQ(
      complaint_after([&](hid_t file) {
        replace_dataset(file, "Luxel/panes/transmittance", H5T_NATIVE_FLOAT, {2, 3}, transmittances.data());
      }),
      "damaged: a transmittance is not a number from 0 to 1");
  const std::vector<std::uint32_t> material = {0};
  EXPECT_EQ(complaint_after([&](hid_t file) {
              replace_dataset(file, "Luxel/panes/material", H5T_NATIVE_UINT32, {1}, material.data());
            }),
            "damaged: a pane has no material with a transmittance");
  damage_every(13);
}

TEST_F(DamagedSolution, the_standard_errors_of_one_side_alone_are_refused) {
  make(sample::baked_with_errors(4, 3));
  EXPECT_EQ(complaint_after(
                [](hid_t file) { H5Ldelete(file, "VTKHDF/CellData/standard_error_back", H5P_DEFAULT); }),
            "damaged: 'VTKHDF/CellData/standard_error_back' holds 0 numbers, expected 12");
}

TEST_F(DamagedSolution, standard_errors_of_another_length_are_named) {
  make(sample::baked_with_errors(4, 3));
  const std::vector<float> errors(15, 1.0f);
  EXPECT_EQ(
      complaint_after([&](hid_t file) {
        replace_dataset(file, "VTKHDF/CellData/standard_error_front", H5T_IEEE_F32LE, {5, 3}, errors.data());
      }),
      "damaged: dataset 'VTKHDF/CellData/standard_error_front' is of shape [5, 3], expected [4, 3]");
}

TEST_F(DamagedSolution, a_compressed_file_with_any_byte_changed_is_refused_or_read_as_it_was) {
  make(700);
  damage_every(97);
  EXPECT_GT(attempts_, 200);
  EXPECT_GT(complaints_, attempts_ / 2);
}

TEST_F(DamagedSolution, a_file_of_many_chunks_with_any_byte_changed_is_refused_or_read_as_it_was) {
  make(30'000);
  damage_every(whole_.size() / 25);
  // HDF5 marks the blocks of a chunk index with these letters.
  for (const auto* mark : {"FAHD", "FADB"}) {
    const auto begin = whole_.find(mark);
    ASSERT_NE(begin, std::string::npos);
    for (std::size_t i = 0; i < 28; i += 3) damage_at(begin + i, 0x10);
  }
}

TEST_F(DamagedSolution, a_file_cut_short_anywhere_is_refused) {
  make(4);
  cut_at_every(37);
  make(700);
  cut_at_every(997);
}

TEST_F(DamagedSolution, a_file_that_grew_is_read_as_it_was) {
  make(4);
  put(path_, whole_ + "some more");
  EXPECT_EQ(complaint(), "");
}

TEST_F(DamagedSolution, an_empty_or_a_text_file_is_not_a_solution) {
  for (const std::string text : {"", "v 0 0 0\n"}) {
    put(path_, text);
    EXPECT_EQ(complaint().find("not a Luxel solution"), 0u);
  }
}

TEST_F(DamagedSolution, another_hdf5_file_is_not_a_solution) {
  H5Fclose(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_EQ(complaint(), "not a Luxel solution (no Luxel group)");
}

TEST_F(DamagedSolution, a_newer_version_is_refused_with_advice) {
  make(4);
  const auto message = complaint_after([](hid_t file) {
    const std::uint32_t version = 7;
    const auto group = H5Gopen2(file, "Luxel", H5P_DEFAULT);
    const auto attribute = H5Aopen(group, "format_version", H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_UINT32, &version);
    H5Aclose(attribute);
    H5Gclose(group);
  });
  EXPECT_EQ(message, "written by format version 7; this program reads up to 2: use a newer Luxel");
}

TEST_F(DamagedSolution, what_a_reader_does_not_know_is_ignored) {
  make(4);
  const auto message = complaint_after([](hid_t file) {
    H5Gclose(H5Gcreate2(file, "Luxel/cameras", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    const std::array<double, 3> values = {1.0, 2.0, 3.0};
    replace_dataset(file, "VTKHDF/CellData/mine", H5T_NATIVE_DOUBLE, {3}, values.data());
  });
  EXPECT_EQ(message, "");
}

TEST_F(DamagedSolution, a_missing_dataset_is_named) {
  make(4);
  EXPECT_EQ(complaint_after([](hid_t file) { H5Ldelete(file, "VTKHDF/CellData/area", H5P_DEFAULT); }),
            "damaged: 'VTKHDF/CellData/area' is missing");
}

TEST_F(DamagedSolution, an_array_of_another_length_is_named_with_both_lengths) {
  make(4);
  const std::vector<float> areas(5, 1.0f);
  EXPECT_EQ(complaint_after([&](hid_t file) {
              replace_dataset(file, "VTKHDF/CellData/area", H5T_IEEE_F32LE, {5}, areas.data());
            }),
            "damaged: dataset 'VTKHDF/CellData/area' is of shape [5], expected [4]");
}

TEST_F(DamagedSolution, an_array_of_another_type_is_named) {
  make(4);
  const std::vector<double> areas(4, 1.0);
  EXPECT_EQ(complaint_after([&](hid_t file) {
              replace_dataset(file, "VTKHDF/CellData/area", H5T_IEEE_F64LE, {4}, areas.data());
            }),
            "damaged: dataset 'VTKHDF/CellData/area' is of an unexpected type");
}

TEST_F(DamagedSolution, an_index_out_of_range_is_named) {
  make(4);
  for (const std::int64_t index : {std::int64_t{-1}, std::int64_t{6}, std::int64_t{1} << 32}) {
    std::vector<std::int64_t> connectivity(12, 0);
    connectivity[7] = index;
    EXPECT_EQ(complaint_after([&](hid_t file) {
                replace_dataset(file, "VTKHDF/Connectivity", H5T_STD_I64LE, {12}, connectivity.data());
              }).find("damaged: patch 2 names vertex " + std::to_string(index)),
              0u);
  }
}

int rank_of(const std::string& dataset) { return dataset == "VTKHDF/Points" ? 2 : 1; }

TEST_F(DamagedSolution, a_length_that_the_file_cannot_hold_asks_for_no_memory) {
  make(4);
  constexpr hsize_t huge = hsize_t{1} << 50;
  for (const auto* name : {"VTKHDF/Types", "VTKHDF/Points", "Luxel/bands"}) {
    SCOPED_TRACE(name);
    const auto message = complaint_after([&](hid_t file) {
      H5Ldelete(file, name, H5P_DEFAULT);
      const std::array<hsize_t, 2> shape = {huge, 3}, chunk = {1024, 3};
      const auto rank = rank_of(name);
      const auto text = H5Tcopy(H5T_C_S1);
      const auto type = name == std::string("VTKHDF/Types") ? H5T_STD_U8LE
                        : rank == 2                         ? H5T_IEEE_F32LE
                                                            : text;
      const auto list = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_chunk(list, rank, chunk.data());
      const auto space = H5Screate_simple(rank, shape.data(), nullptr);
      H5Dclose(H5Dcreate2(file, name, type, space, H5P_DEFAULT, list, H5P_DEFAULT));
      H5Sclose(space);
      H5Pclose(list);
      H5Tclose(text);
    });
    const std::string expected = name == std::string("VTKHDF/Types")
                                     ? "'VTKHDF/NumberOfCells' is 4, but the arrays hold 1125899906842624"
                                 : rank_of(name) == 2
                                     ? "'VTKHDF/NumberOfPoints' is 6, but the arrays hold 1125899906842624"
                                     : "claims 1125899906842624 rows but only 0 bytes of it are there";
    EXPECT_NE(message.find(expected), std::string::npos) << message;
  }
}

// Zeros that deflate packs by a factor of a thousand.
TEST_F(DamagedSolution, arrays_that_unpack_to_far_more_than_the_file_are_refused) {
  make(4);
  const auto message = complaint_after([&](hid_t file) {
    const std::array<hsize_t, 2> shape = {3'000'000, 3}, chunk = {1'000'000, 3};
    const std::vector<float> zeros(9'000'000);
    const auto group = H5Gcreate2(file, "Luxel/contacts", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const auto list = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(list, 2, chunk.data());
    H5Pset_deflate(list, 9);
    const auto space = H5Screate_simple(2, shape.data(), nullptr);
    const auto set = H5Dcreate2(group, "into", H5T_IEEE_F32LE, space, H5P_DEFAULT, list, H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
    const std::array<hsize_t, 2> pairs = {3'000'000, 2};
    const auto plane = H5Screate_simple(2, pairs.data(), nullptr);
    const std::vector<std::uint32_t> corners(6'000'000);
    const std::array<hsize_t, 2> chunk_of_pairs = {1'000'000, 2};
    H5Pset_chunk(list, 2, chunk_of_pairs.data());
    const auto edges = H5Dcreate2(group, "edge", H5T_STD_U32LE, plane, H5P_DEFAULT, list, H5P_DEFAULT);
    H5Dwrite(edges, H5T_NATIVE_UINT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, corners.data());
    for (const auto of : {set, edges}) H5Dclose(of);
    for (const auto of : {space, plane}) H5Sclose(of);
    H5Pclose(list);
    H5Gclose(group);
  });
  EXPECT_NE(message.find("its arrays claim "), std::string::npos) << message;
  EXPECT_NE(message.find("more than a file of 0."), std::string::npos) << message;
}

TEST_F(DamagedSolution, a_link_into_another_file_is_not_followed) {
  make(4);
  EXPECT_EQ(complaint_after([](hid_t file) {
              H5Ldelete(file, "VTKHDF/CellData/area", H5P_DEFAULT);
              H5Lcreate_external("other.h5", "area", file, "VTKHDF/CellData/area", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "damaged: 'VTKHDF/CellData/area' is a link to elsewhere");
}

TEST_F(DamagedSolution, the_library_stays_silent_and_its_printing_as_it_was) {
  make(4);
  put(path_, std::string_view(whole_).substr(0, whole_.size() / 2));
  H5E_auto2_t before = nullptr, after = nullptr;
  void* data = nullptr;
  H5Eget_auto2(H5E_DEFAULT, &before, &data);
  testing::internal::CaptureStderr();
  EXPECT_NE(complaint(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  H5Eget_auto2(H5E_DEFAULT, &after, &data);
  EXPECT_EQ(before, after);
}

TEST_F(DamagedSolution, nothing_stays_open_after_a_refusal) {
  make(4);
  const auto open_before = H5Fget_obj_count(static_cast<hid_t>(H5F_OBJ_ALL), H5F_OBJ_ALL);
  damage_every(501);
  EXPECT_GT(complaints_, 0);
  EXPECT_EQ(H5Fget_obj_count(static_cast<hid_t>(H5F_OBJ_ALL), H5F_OBJ_ALL), open_before);
}

}  // namespace
}  // namespace luxel
