// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/compact.h"

#include <gtest/gtest.h>
#include <zlib.h>

namespace luxel {
namespace {

std::string inflated(const std::string& stream, std::size_t size) {
  std::string bytes(size, '\0');
  auto room = static_cast<uLongf>(size);
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &room,
                       reinterpret_cast<const Bytef*>(stream.data()), stream.size()),
            Z_OK);
  EXPECT_EQ(room, size);
  return bytes;
}

TEST(Compact, what_is_deflated_comes_back) {
  std::string bytes;
  for (int i = 0; i < 100'000; ++i) bytes += static_cast<char>(i / 100 + i % 3);
  const auto stream = deflated(bytes);
  EXPECT_LT(stream.size(), bytes.size() / 2);
  EXPECT_EQ(inflated(stream, bytes.size()), bytes);
  EXPECT_EQ(inflated(deflated(""), 0), "");
}

TEST(Compact, the_same_bytes_give_the_same_stream) {
  const std::string bytes(5000, 'x');
  EXPECT_EQ(deflated(bytes), deflated(bytes));
}

TEST(Compact, base85_writes_four_bytes_as_five_digits_of_base_85) {
  EXPECT_EQ(base85(""), "");
  EXPECT_EQ(base85(std::string(4, '\0')), "!!!!!");
  EXPECT_EQ(base85(std::string("\0\0\0\x01", 4)), "!!!!#");
  EXPECT_EQ(base85(std::string("\0\0\0\x55", 4)), "!!!#!");  // 85
  EXPECT_EQ(base85("\xff\xff\xff\xff"), "|?_2!");            // 82 23 54 12 0
  EXPECT_EQ(base85("\1"), base85(std::string("\1\0\0\0", 4)));
}

TEST(Compact, base85_has_no_character_that_html_reads_otherwise) {
  std::string bytes;
  for (unsigned i = 0; i < 4000; ++i) bytes += static_cast<char>(i * 2654435761u >> 24u);
  const auto text = base85(bytes);
  EXPECT_EQ(text.size(), 5000u);
  EXPECT_EQ(text.find_first_of("<>&\"'\\`$- \n"), std::string::npos);
}

}  // namespace
}  // namespace luxel
