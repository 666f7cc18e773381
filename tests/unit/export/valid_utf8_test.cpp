// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "luxel/export/utf8.h"

namespace luxel {
namespace {

TEST(ValidUtf8, text_that_is_utf8_stays_as_it_is) {
  for (const std::string text : {"", "wall", "Wände", "壁", "\U0001F4A1", "\uFFFD", "\u0800", "\U0010FFFF"})
    EXPECT_EQ(valid_utf8(text), text);
}

TEST(ValidUtf8, every_other_byte_becomes_a_question_mark) {
  EXPECT_EQ(valid_utf8("W\xE4nde"), "W?nde");           // Latin-1
  EXPECT_EQ(valid_utf8("\xC3"), "?");                   // cut short
  EXPECT_EQ(valid_utf8("\xE5\xA3"), "??");              // cut short
  EXPECT_EQ(valid_utf8("\xC0\xAF"), "??");              // overlong
  EXPECT_EQ(valid_utf8("\xE0\x80\x80"), "???");         // overlong
  EXPECT_EQ(valid_utf8("\xED\xA0\x80"), "???");         // a surrogate
  EXPECT_EQ(valid_utf8("\xF4\x90\x80\x80x"), "????x");  // above U+10FFFF
  EXPECT_EQ(valid_utf8("\xFF\xFE"), "??");
}

}  // namespace
}  // namespace luxel
