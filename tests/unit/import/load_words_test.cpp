// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "luxel/import/name_list.h"
#include "luxel/import/numbers.h"
#include "luxel/import/text.h"
#include "luxel/scene/name_pattern.h"

namespace luxel {
namespace {

using Lines = std::vector<std::pair<std::size_t, std::string>>;

Lines lines_of(std::string_view text) {
  Lines lines;
  for (Statements statements(text); statements.next();)
    lines.emplace_back(statements.line(), statements.text());
  return lines;
}

TEST(Statements, end_with_the_line_ends_of_all_systems) {
  EXPECT_EQ(lines_of("a\nb\r\nc\rd\n\re"),
            (Lines{{1, "a"}, {2, "b"}, {3, "c"}, {4, "d"}, {5, ""}, {6, "e"}}));
}

TEST(Statements, the_last_needs_no_line_end) {
  EXPECT_EQ(lines_of("a\n"), (Lines{{1, "a"}}));
  EXPECT_EQ(lines_of("a"), (Lines{{1, "a"}}));
  EXPECT_EQ(lines_of(""), Lines{});
}

TEST(Statements, a_backslash_joins_the_next_line) {
  EXPECT_EQ(lines_of("f 1 \\\r\n2\\\n3\nv"), (Lines{{1, "f 1  2 3"}, {4, "v"}}));
}

TEST(Statements, a_backslash_in_a_comment_joins_nothing) {
  EXPECT_EQ(lines_of("# C:\\\nv"), (Lines{{1, "# C:\\"}, {2, "v"}}));
}

TEST(Statements, a_backslash_at_the_very_end_stays) { EXPECT_EQ(lines_of("f 1\\"), (Lines{{1, "f 1\\"}})); }

TEST(Words, are_taken_one_after_the_other) {
  std::string_view text = "  newmtl \t a b  ";
  EXPECT_EQ(take_word(text), "newmtl");
  EXPECT_EQ(take_word(text), "a");
  EXPECT_EQ(take_word(text), "b");
  EXPECT_EQ(take_word(text), "");
}

TEST(Numbers, are_read_whole_and_rounded_to_the_nearest_float) {
  EXPECT_EQ(read_number("+2."), 2.0f);
  EXPECT_EQ(read_number(".8e-1"), 0.08f);
  EXPECT_EQ(read_number("-.7e+2"), -70.0f);
  EXPECT_EQ(read_number("3.1E2"), 310.0f);
  EXPECT_EQ(read_number("0.1000000014901161193847656251"), 0.1f);
  EXPECT_EQ(read_number("16777217.0000001"), 16777218.0f);
}

TEST(Numbers, too_small_for_a_float_are_zero) { EXPECT_EQ(read_number("1e-60"), 0.0f); }

TEST(Numbers, are_nothing_else) {
  for (const char* word : {"", "+", "-", ".", "+-1", "--1", "1e", "3.1+e2", "abc", "1,5", "1.#IND", "nan",
                           "-nan", "inf", "1e39", "-1e39", "1e999", "1x", "0x10"})
    EXPECT_FALSE(read_number(word)) << word;
}

TEST(NamePattern, star_is_any_run_and_question_mark_any_one) {
  EXPECT_TRUE(matches("wall", "wall"));
  EXPECT_FALSE(matches("wall", "wall2"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("wall*", "wall"));
  EXPECT_TRUE(matches("w?ll", "wall"));
  EXPECT_FALSE(matches("w?ll", "wll"));
  EXPECT_TRUE(matches("*a*b", "aab_ab"));
  EXPECT_FALSE(matches("*a*b", "aab_a"));
  EXPECT_FALSE(matches("", "a"));
}

TEST(NamePattern, many_stars_cost_no_eternity) {
  EXPECT_FALSE(matches("*a*a*a*a*a*a*a*a*a*a*a*a*b", std::string(10'000, 'a')));
}

TEST(NameList, is_short) {
  const std::vector<std::string> names = {"a", "b", "c", "d", "e", "f", "g", "h"};
  EXPECT_EQ(name_list(names), "'a', 'b', 'c', 'd', 'e', 'f' and 2 more");
  EXPECT_EQ(name_list(std::span(names).first(1)), "'a'");
}

}  // namespace
}  // namespace luxel
