// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/toml.h"

#include <gtest/gtest.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

void refuses(const std::string& text, const std::string& message) {
  try {
    parse_toml(text, "a.toml");
    FAIL() << text;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(Toml, reads_tables_keys_and_values) {
  const auto file = parse_toml(
      "# note\nmaintenance = 0.8  # of all\r\n[[area]]\nname = \"a \\\"b\\\"\"\npolygon = [\n  [0, 1.5],  # "
      "one\n"
      "  [-2e1, 1_000],\n]\non = true\n[requirement.\"my room\"]\nparts = { LLMF = 0.9, LSF = 1 }\npath = "
      "'C:\\x'\n"
      "[[area]]\n",
      "a.toml");
  ASSERT_EQ(file.tables.size(), 4u);
  EXPECT_EQ(file.tables[1].name, "area");
  EXPECT_TRUE(file.tables[1].is_element);
  EXPECT_EQ(file.tables[1].line, 3u);
  EXPECT_EQ(file.tables[2].name, "requirement.my room");
  const TomlKeys root(file.source, file.tables[0], {"maintenance"});
  EXPECT_EQ(root.number("maintenance", 0, 1), 0.8);
  const TomlKeys area(file.source, file.tables[1], {"name", "polygon", "on"});
  EXPECT_EQ(area.text("name"), "a \"b\"");
  EXPECT_EQ(area.flag("on"), true);
  const std::vector<std::vector<double>> rows = {{0, 1.5}, {-20, 1000}};
  EXPECT_EQ(area.rows("polygon"), rows);
  const TomlKeys room(file.source, file.tables[2], {"parts", "path"});
  EXPECT_EQ(room.text("path"), "C:\\x");
  ASSERT_NE(room.table("parts"), nullptr);
  EXPECT_EQ(room.table("parts")->size(), 2u);
  EXPECT_EQ(area.line("on"), 9u);
}

TEST(Toml, names_file_and_line_of_errors) {
  refuses("a = 1\na = 2\n", "a.toml:2: 'a' is set in line 1 already");
  refuses("a = 1 2\n", "a.toml:1: expected the end of the line, found '2'");
  refuses("\n[x\n", "a.toml:2: expected ] after 'x'");
  refuses("[x]\n[x]\n", "a.toml:2: there is a table [x] in line 1 already");
  refuses("a = \"b\n", "a.toml:1: expected \" at the end of the text");
  refuses("a = \"\\q\"\n", "a.toml:1: expected one of");
  refuses("a = 2020-01-01\n", "a.toml:1: expected a number, true, false, or text");
  refuses("a = inf\n", "a.toml:1: expected a number");
  refuses("a.b = 1\n", "a.toml:1: expected = after 'a', found a dot");
  refuses("a = [1,\n2\n", "a.toml:1: expected ] at the end of the list");
  refuses("a = { b = 1\n}", "a.toml:1: expected a comma or }");
  refuses("a = [[[[[[[[[[[[1]]]]]]]]]]]]", "a.toml:1: expected at most 8 brackets");
  refuses("= 1", "a.toml:1: expected a key");
  refuses("a", "a.toml:1: expected = after 'a'");
  refuses("a = \"\"\"x\"\"\"", "a.toml:1: expected text on one line");
}

TEST(TomlKeys, refuses_unknown_keys_wrong_kinds_and_ranges) {
  const auto file = parse_toml("a = 1\nb = \"x\"\nc = [1, 2]\n", "a.toml");
  const auto message = [&](auto call) -> std::string {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_EQ(message([&] {
              TomlKeys(file.source, file.tables[0], {"a", "b"});
            }),
            "a.toml:3: there is no key 'c' here; expected one of a, b");
  const TomlKeys keys(file.source, file.tables[0], {"a", "b", "c"});
  EXPECT_EQ(message([&] { keys.number("b", 0, 1); }), "a.toml:2: b: expected a number");
  EXPECT_EQ(message([&] { keys.number("a", 2, 3); }), "a.toml:1: a: expected a number from 2 to 3, found 1");
  EXPECT_EQ(message([&] { keys.text("a"); }), "a.toml:1: a: expected text between \" and \"");
  EXPECT_EQ(message([&] { keys.flag("a"); }), "a.toml:1: a: expected true or false");
  EXPECT_EQ(message([&] { keys.point("c"); }), "a.toml:3: c: expected 3 numbers in brackets, found 2");
  EXPECT_EQ(message([&] { keys.rows("a"); }),
            "a.toml:1: a: expected a list of points such as [[0, 0], [4, 0], [4, 3]]");
  EXPECT_FALSE(keys.has("d"));
  EXPECT_EQ(keys.number("d", 0, 1), std::nullopt);
}

}  // namespace
}  // namespace luxel
