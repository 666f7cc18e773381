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

// The vectors of RFC 4648, section 10, and bytes beyond ASCII.
TEST(Compact, base64_is_that_of_the_standard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xfb\xff\xfe"), "+//+");
}

}  // namespace
}  // namespace luxel
