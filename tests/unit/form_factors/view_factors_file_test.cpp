// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/view_factors_file.h"

#include <sstream>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"

namespace luxel {
namespace {

std::filesystem::path place(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("luxel_view_factors_" + name);
}

// Two elements, names that formats must quote.
StoredViewFactors sample() {
  StoredViewFactors stored;
  auto& f = stored.factors;
  f = ViewFactors::between({"a \"b\", c", "d\ne"}, {1.5, 0.1});
  f.column = {1, 0, 1};
  f.factor = {1.0 / 3.0, 0.7, 1e-9};
  f.standard_error = {0.01f, 0.02f, 1e-9f};
  f.row_begin = {0, 1, 3};
  f.rays = {1024, 1000.5};
  f.is_known = {1, 1};
  f.sink[ViewFactors::environment].factor = {2.0 / 3.0, 0.0};
  f.sink[ViewFactors::environment].standard_error = {0.01f, 0.0f};
  f.sink[ViewFactors::dropped].factor = {0.0, 0.3};
  stored.note = {
      "patches", "both",
      true,      {"0.1.0", "luxel viewfactors x.obj", "counted", {{"error", "auto"}}, 7, 9, 11, {}},
      {4, 5},    {{1, 2, 3}, {4, 5, 6}}};
  return stored;
}

std::string complaint(const std::filesystem::path& path) {
  try {
    read_view_factors_hdf5(path);
  } catch (const FormatError& error) {
    return error.what();
  }
  return "read without complaint";
}

TEST(ViewFactorsFile, hdf5_gives_back_every_bit_and_repeats) {
  const auto stored = sample();
  const auto path = place("a.h5");
  write_view_factors_hdf5(path, stored.factors, stored.note);
  const auto back = read_view_factors_hdf5(path);
  EXPECT_EQ(back.factors.name, stored.factors.name);
  EXPECT_EQ(back.factors.area, stored.factors.area);
  EXPECT_EQ(back.factors.rays, stored.factors.rays);
  EXPECT_EQ(back.factors.row_begin, stored.factors.row_begin);
  EXPECT_EQ(back.factors.column, stored.factors.column);
  EXPECT_EQ(back.factors.factor, stored.factors.factor);
  EXPECT_EQ(back.factors.standard_error, stored.factors.standard_error);
  for (std::size_t k = 0; k < ViewFactors::sinks; ++k) {
    EXPECT_EQ(back.factors.sink[k].factor, stored.factors.sink[k].factor);
    EXPECT_EQ(back.factors.sink[k].standard_error, stored.factors.sink[k].standard_error);
  }
  EXPECT_EQ(back.note.between, "patches");
  EXPECT_EQ(back.note.sides, "both");
  EXPECT_TRUE(back.note.enforced);
  EXPECT_EQ(back.note.triangle, stored.note.triangle);
  EXPECT_EQ(back.note.centre, stored.note.centre);
  EXPECT_EQ(back.note.provenance.command_line, stored.note.provenance.command_line);
  EXPECT_EQ(back.note.provenance.options, stored.note.provenance.options);
  EXPECT_EQ(back.note.provenance.rays, 9u);
  const auto again = place("b.h5");
  write_view_factors_hdf5(again, back.factors, back.note);
  EXPECT_EQ(read_file(path), read_file(again));
}

TEST(ViewFactorsFile, compressed_or_not_gives_back_the_same) {
  constexpr std::uint32_t n = 10000;
  auto stored = sample();
  auto& f = stored.factors;
  f.row_begin = {0, 1, 1 + n};
  f.name.resize(n, "more");
  f.area.resize(n, 1.0);
  f.rays.resize(n);
  f.is_known.resize(n);
  f.row_begin.resize(n + 1, 1 + n);
  for (auto& sink : f.sink) {
    sink.factor.resize(n);
    sink.standard_error.resize(n);
  }
  f.column.resize(1);
  f.factor.assign(1 + n, 1.0 / n);
  f.standard_error.assign(1 + n, 1e-4f);
  for (std::uint32_t j = 0; j < n; ++j) f.column.push_back(j);
  stored.note.triangle.clear();
  stored.note.centre.clear();
  const auto plain = place("plain.h5"), compressed = place("compressed.h5");
  write_view_factors_hdf5(plain, f, stored.note);
  write_view_factors_hdf5(compressed, f, stored.note, true);
  EXPECT_LT(2 * std::filesystem::file_size(compressed), std::filesystem::file_size(plain));
  const auto a = read_view_factors_hdf5(plain).factors, b = read_view_factors_hdf5(compressed).factors;
  for (const auto& back : {a, b}) {
    EXPECT_EQ(back.column, f.column);
    EXPECT_EQ(back.factor, f.factor);
  }
  // Not compressed is not unguarded: a flipped bit in the middle is found.
  auto bytes = read_file(plain);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  write_file(plain, bytes);
  EXPECT_NE(complaint(plain), "read without complaint");
}

TEST(ViewFactorsFile, damage_and_other_files_are_told_in_a_sentence) {
  auto stored = sample();
  const auto path = place("damaged.h5");
  write_view_factors_hdf5(path, stored.factors, stored.note);
  const auto bytes = read_file(path);
  write_file(path, bytes.substr(0, bytes.size() / 2));
  EXPECT_NE(complaint(path), "read without complaint");
  stored.factors.column[2] = 9;
  write_view_factors_hdf5(path, stored.factors, stored.note);
  EXPECT_NE(complaint(path).find("name no element"), std::string::npos) << complaint(path);
  stored = sample();
  stored.factors.factor[0] = 1.5;
  write_view_factors_hdf5(path, stored.factors, stored.note);
  EXPECT_NE(complaint(path).find("no such number"), std::string::npos) << complaint(path);
  EXPECT_NE(complaint(LUXEL_SOURCE_DIR "/tests/golden/solution-v1.vtkhdf").find("not view factors of Luxel"),
            std::string::npos);
}

TEST(ViewFactorsFile, csv_has_a_line_a_factor_and_one_for_what_is_lost) {
  const auto path = place("a.csv");
  write_view_factors_csv(path, sample().factors);
  EXPECT_EQ(read_file(path),
            "from,to,factor,standard_error\n"
            "\"a \"\"b\"\", c\",\"d\ne\",0.3333333333333333,0.01\n"
            "\"a \"\"b\"\", c\",(environment),0.6666666666666666,0.01\n"
            "\"d\ne\",\"a \"\"b\"\", c\",0.7,0.02\n"
            "\"d\ne\",\"d\ne\",1e-09,1e-09\n"
            "\"d\ne\",(dropped),0.3,0\n");
}

TEST(ViewFactorsFile, matrix_market_reads_back) {
  const auto path = place("a.mtx");
  const auto stored = sample();
  write_view_factors_matrix_market(path, stored.factors, stored.note);
  std::istringstream file(read_file(path));
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "%%MatrixMarket matrix coordinate real general");
  while (file.peek() == '%') std::getline(file, line);
  std::size_t rows = 0, columns = 0, count = 0;
  file >> rows >> columns >> count;
  EXPECT_EQ(rows, 2u);
  EXPECT_EQ(columns, 2u);
  ASSERT_EQ(count, 3u);
  const std::size_t row_of[] = {1, 2, 2};
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t i = 0, j = 0;
    double value = 0.0;
    file >> i >> j >> value;
    EXPECT_EQ(i, row_of[k]);
    EXPECT_EQ(j, stored.factors.column[k] + 1);
    EXPECT_EQ(value, stored.factors.factor[k]);
  }
}

TEST(ViewFactorsFile, a_full_disk_is_a_sentence) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  const auto stored = sample();
  EXPECT_THROW(write_view_factors_hdf5("/dev/full", stored.factors, stored.note), DeviceError);
  EXPECT_THROW(write_view_factors_csv("/dev/full", stored.factors), DeviceError);
  EXPECT_THROW(write_view_factors_matrix_market("/dev/full", stored.factors, stored.note), DeviceError);
}

}  // namespace
}  // namespace luxel
