// SPDX-License-Identifier: Apache-2.0
// Contents and legibility of daylight plans.
#include "luxel/lighting/metric_plan.h"

#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "luxel/lighting/daylight_plans.h"

namespace luxel {
namespace {

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

// 4 x 3 cells of 1 m in a room of 5 x 4 m with a window in the lower wall.
MetricGround ground() {
  MetricGround g;
  g.grid = rectangular_grid({0.5, 0.5, 0.85}, {4.5, 0.5, 0.85}, {0.5, 3.5, 0.85}, 4, 3);
  g.plan = {{{-0.5, -0.5}, {4.5, -0.5}, {4.5, 3.5}, {-0.5, 3.5}, {-0.5, -0.5}}};
  g.openings = openings_of(g.grid, {{1.0, 0.0, 1.0}, {3.0, 0.0, 1.0}, {3.0, 0.0, 2.0}});
  g.north = Vec2d(0.0, 1.0);
  return g;
}

MetricPlan metric() {
  MetricPlan m;
  m.title = "Factor & <more>";
  m.figures = {"mean 2 % (1 < 3)"};
  m.values = {8, 8, 8, 8, 3, 3, 3, 3, 1, 1, 1, 1};
  m.scale = {.low = 0.1, .high = 20.0, .is_logarithmic = true, .marks = {0.1, 1.0, 20.0}, .unit = "%"};
  m.lines = {2.0, 5.0};
  m.decimals = 1;
  return m;
}

TEST(MetricPlan, has_a_grid_of_the_cells_that_were_measured) {
  const auto grid = rectangular_grid({1, 2, 3}, {1, 6, 3}, {4, 2, 3}, 4, 2);
  EXPECT_EQ(grid.points(), 8u);
  EXPECT_NEAR(glm::length(grid.position[0] - Vec3d(1.75, 2.5, 3.0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(grid.position[7] - Vec3d(3.25, 5.5, 3.0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(grid.normal - Vec3d(0, 0, -1)), 0.0, 1e-12);
}

TEST(MetricPlan, sees_a_window_from_above_as_a_line) {
  const auto openings = ground().openings;
  ASSERT_EQ(openings.size(), 1u);
  for (const auto& p : openings[0]) {
    EXPECT_NEAR(p.y, -0.5, 1e-12);
    EXPECT_GE(p.x, 0.5 - 1e-12);
    EXPECT_LE(p.x, 2.5 + 1e-12);
  }
}

TEST(MetricPlan, has_cells_numbers_lines_legend_scale_bar_and_north) {
  const auto svg = metric_plans_svg(ground(), {metric()});
  EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(count(svg, "<svg"), count(svg, "</svg>"));
  EXPECT_EQ(count(svg, "<g"), count(svg, "</g>"));
  EXPECT_EQ(count(svg, "class=\"cell\""), 12u);
  EXPECT_EQ(count(svg, "class=\"line\""), 4u) << "two lines with their dark edges";
  EXPECT_NE(svg.find("Factor &amp; &lt;more&gt;"), std::string::npos);
  EXPECT_NE(svg.find("mean 2 % (1 &lt; 3)"), std::string::npos);
  for (const char* text : {">2 %</text>", ">5 %</text>", ">20 %</text>", ">1 m</text>", ">N</text>",
                           ">window or opening</text>", ">8.0</text>", ">1.0</text>"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(svg.find("nan"), std::string::npos);

  auto bare = ground();
  bare.openings.clear();
  bare.north.reset();
  const auto without = metric_plans_svg(bare, {metric()});
  EXPECT_EQ(without.find(">N</text>"), std::string::npos);
  EXPECT_EQ(without.find("window or opening"), std::string::npos);
}

// All texts lie inside of the picture, and numbers do not stand under lines or labels.
TEST(MetricPlan, numbers_keep_clear_of_lines) {
  auto m = metric();
  m.values = {8, 8, 8, 8, 2, 2, 2, 2, 1, 1, 1, 1};  // the line of 2 runs through the second row
  m.lines = {2.0};
  const auto svg = metric_plans_svg(ground(), {m});
  EXPECT_EQ(count(svg, ">8.0</text>"), 4u);
  EXPECT_EQ(count(svg, ">1.0</text>"), 4u);
  EXPECT_EQ(count(svg, ">2.0</text>"), 0u);
  const auto width = std::stod(svg.substr(svg.find("width=\"") + 7));
  const std::regex place("<text[^>]* x=\"([0-9.-]+)\"");
  for (std::sregex_iterator i(svg.begin(), svg.end(), place), end; i != end; ++i) {
    EXPECT_GE(std::stod((*i)[1]), 0.0);
    EXPECT_LE(std::stod((*i)[1]), width);
  }
}

TEST(MetricPlan, brighter_cells_are_brighter_and_the_ends_hold) {
  const ColourScale scale{.low = 0.1, .high = 20.0, .is_logarithmic = true};
  EXPECT_EQ(scale.fraction(0.0), 0.0);
  EXPECT_EQ(scale.fraction(0.1), 0.0);
  EXPECT_NEAR(scale.fraction(std::sqrt(2.0)), 0.5, 1e-12);
  EXPECT_EQ(scale.fraction(500.0), 1.0);
  EXPECT_EQ(scale.colour(0.0), "#000004");
  EXPECT_EQ(scale.colour(20.0), "#fcffa4");
  EXPECT_STREQ(scale.text_colour(0.2), "#fff");
  EXPECT_STREQ(scale.text_colour(15.0), "#000");
  // Luminance grows evenly, so that the order is seen without the hue.
  const ColourScale even;
  double last = -1.0;
  for (int percent = 0; percent <= 100; percent += 5) {
    const auto rgb = std::stoi(even.colour(percent).substr(1), nullptr, 16);
    const auto grey = 0.2126 * std::pow((rgb >> 16 & 255) / 255.0, 2.2) +
                      0.7152 * std::pow((rgb >> 8 & 255) / 255.0, 2.2) +
                      0.0722 * std::pow((rgb & 255) / 255.0, 2.2);
    EXPECT_GT(grey, last) << percent;
    last = grey;
  }
}

// Several plans stand beside each other in one picture of its size; in a page each is a picture.
TEST(MetricPlan, several_plans_are_one_picture_or_one_each) {
  const auto together = metric_plans_svg(ground(), {metric(), metric(), metric()});
  EXPECT_EQ(count(together, "<g transform"), 3u);
  EXPECT_EQ(count(together, "translate(440.0 0.0)"), 1u);
  const auto each = metric_plan_svgs(ground(), {metric(), metric()});
  ASSERT_EQ(each.size(), 2u);
  for (const auto& svg : each) EXPECT_TRUE(svg.starts_with("<svg xmlns"));
  // For a long room there is one plan per row.
  auto lengthy = ground();
  lengthy.grid = rectangular_grid({0, 0, 0}, {12, 0, 0}, {0, 3, 0}, 4, 3);
  EXPECT_TRUE(is_wide_plan(lengthy.grid));
  EXPECT_EQ(count(metric_plans_svg(lengthy, {metric(), metric()}), "translate(0.0 "), 2u);
}

TEST(MetricPlan, figures_have_their_intervals) {
  EXPECT_EQ(per_cent_text({0.5, 0.5, 0.5}, 0), "50 %");
  EXPECT_EQ(per_cent_text({0.852, 0.849, 0.856}, 1), "85.2 % (84.9 to 85.6)");
  EXPECT_EQ(per_cent_text({0.42, 0.418, 0.422}, 0), "42.0 % (41.8 to 42.2)");
  EXPECT_EQ(per_cent_text({0.99, 0.95, 1.03}, 0), "99 % (95 to 100)");
  YearMetrics year;
  year.sun_hours.value = {0.0f, 1241.0f};
  const auto plans = plans_of(year);
  ASSERT_EQ(plans.size(), 3u);
  EXPECT_EQ(plans[2].scale.high, 1500.0);
  EXPECT_EQ(plans[2].lines, std::vector<double>{250.0});
  EXPECT_EQ(plans[0].lines, std::vector<double>{50.0});
  year.sun_hours.value = {0.0f, 3.0f};
  EXPECT_EQ(plans_of(year)[2].scale.high, 500.0);
}

}  // namespace
}  // namespace luxel
