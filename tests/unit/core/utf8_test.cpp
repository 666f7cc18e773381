// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/utf8.h"

#include <gtest/gtest.h>

#include "luxel/core/csv_field.h"

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

TEST(Printable, shows_control_characters_and_leaves_the_text_of_all_languages) {
  EXPECT_EQ(printable("Wand \u00e4\u00f6 \u2713 \u6f22 \U0001F4A1"),
            "Wand \u00e4\u00f6 \u2713 \u6f22 \U0001F4A1");
  EXPECT_EQ(printable("a\x1b]0;title\x07 b\rc\x7f"), "a\\x1b]0;title\\x07 b\\x0dc\\x7f");
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "\\x9b31m")
      << "no UTF-8, a control character elsewhere";
  EXPECT_EQ(printable("\u009b"
                      "31m"),
            "\\u{009b}31m");
  EXPECT_EQ(printable("abc\u202etxt.exe"), "abc\\u{202e}txt.exe");
  EXPECT_EQ(printable("a\tb\n"), "a\tb\n");
  EXPECT_EQ(printable("a\tb\n", false), "a\\x09b\\x0a");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
}

TEST(CsvField, quotes_what_needs_it_and_disarms_formulas) {
  EXPECT_EQ(csv_field("desk 1"), "desk 1");
  EXPECT_EQ(csv_field("desk, \"left\""), "\"desk, \"\"left\"\"\"");
  EXPECT_EQ(csv_field("=HYPERLINK(1)"), "'=HYPERLINK(1)");
  EXPECT_EQ(csv_field("+1"), "'+1");
  EXPECT_EQ(csv_field("@a,b"), "\"'@a,b\"");
  EXPECT_EQ(csv_field(""), "");
}

}  // namespace
}  // namespace luxel
