// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/html_text.h"

#include <gtest/gtest.h>

#include "luxel/export/number_text.h"

namespace luxel {
namespace {

TEST(HtmlText, escapes_markup_and_bytes_that_are_no_text) {
  EXPECT_EQ(html_escaped("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c&#39;");
  EXPECT_EQ(html_escaped("\xc3\xbc"), "\xc3\xbc");
  EXPECT_EQ(html_escaped("a\xff\x01z"), "a? z");
}

// The test vectors of RFC 4648, section 10.
TEST(HtmlText, base64_is_that_of_the_rfc) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(HtmlText, tables_align_numbers_to_the_right) {
  HtmlTable table({"name", "lx"}, 1);
  table.add({"floor", "500"});
  EXPECT_NE(table.html().find("<tr><td>floor</td><td class=\"n\">500</td></tr>"), std::string::npos);
}

TEST(NumberText, has_three_digits_and_the_interval) {
  EXPECT_EQ(lux_text(512.4), "512");
  EXPECT_EQ(lux_text(99.96), "100");
  EXPECT_EQ(lux_text(48.34), "48.3");
  EXPECT_EQ(lux_text(0.424), "0.42");
  EXPECT_EQ(lux_text(Figure{512.0, 498.0, 526.0}), "512 (498 to 526)");
  EXPECT_EQ(ratio_text(Figure{0.62, 0.62, 0.62}), "0.62");
  EXPECT_EQ(beginning_of(judge("U0", {0.43, 0.40, 0.46}, 0.6)), "U0 0.43 (0.40 to 0.46), at least 0.6: ");
}

TEST(NumberText, has_ends_that_differ) {
  EXPECT_EQ(lux_text(Figure{527.0, 526.0, 528.0}), "527 (526 to 528)");
  EXPECT_EQ(lux_text(Figure{527.04, 526.9, 527.2}), "527.0 (526.9 to 527.2)");
  EXPECT_EQ(ratio_text(Figure{0.5, 0.5, 0.5}), "0.50");
  EXPECT_EQ(interval_text(Figure{5.0, 5.0, 5.0}, ratio_text), "");
}

TEST(NumberText, states_requirements_and_what_is_not_known) {
  EXPECT_EQ(requirement_text(judge("Em", {500, 490, 510}, 500)), "Em ≥ 500 lx");
  EXPECT_EQ(requirement_text(judge("max_over_min", {5, 5, 5}, 40, false)), "Emax : Emin ≤ 40");
  auto unknown = judge("Ra", {}, 80);
  unknown.compliance = Compliance::not_known;
  EXPECT_EQ(measured_text(unknown), "–");
  EXPECT_EQ(interval_text(unknown), "");
}

TEST(HtmlText, intervals_stay_on_one_line) {
  EXPECT_EQ(interval_cell("5 (4 to 6)"), "5 <span class=\"i\">(4 to 6)</span>");
  EXPECT_EQ(interval_cell("–"), "–");
}

}  // namespace
}  // namespace luxel
