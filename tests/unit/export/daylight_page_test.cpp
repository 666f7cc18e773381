// SPDX-License-Identifier: Apache-2.0
// The report of daylight from made numbers.
#include "luxel/export/daylight_page.h"

#include <gtest/gtest.h>

namespace luxel {
namespace {

DaylightPage made_page() {
  DaylightPage page;
  page.title = "Daylight: <room>";
  page.scene = "a & b.obj";
  page.place = "Town \"X\", \xfc";  // a byte that is not UTF-8
  page.weather = "town.epw";
  page.points_description = "3 points";
  page.version = "0";
  page.command = "luxel daylight 'a & b.obj'";
  page.notes = {"light passes freely through 'glass<1>'"};
  DaylightFactors f;
  f.value = {0.01f, 0.02f, 0.03f};
  for (auto& part : f.components) part = f.value;
  f.mean = {0.02, 0.019, 0.021};
  f.median = {0.02, 0.018, 0.022};
  page.factors = {f};
  return page;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(DaylightPage, escapes_texts_and_has_nothing_active) {
  const auto html = daylight_page(made_page());
  EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(html.ends_with("</html>\n"));
  for (const char* text : {"<h1>Daylight: &lt;room&gt;</h1>", "a &amp; b.obj", "Town &quot;X&quot;, ?",
                           "glass&lt;1&gt;", "<b>2.00 %</b><span>1.90 to 2.10 %</span>"})
    EXPECT_TRUE(has(html, text)) << text;
  for (const char* text : {"<script", "javascript:", " style=", " onload", "https://", "<room>"})
    EXPECT_FALSE(has(html, text)) << text;
}

// Without a climate there are no requirements; with one each has its verdict.
TEST(DaylightPage, judges_what_it_can) {
  auto page = made_page();
  EXPECT_TRUE(has(daylight_page(page), "EN 17037 needs a weather file"));
  EXPECT_FALSE(has(daylight_page(page), "Not assessed"));
  FactorProvision p;
  p.level = "minimum";
  p.target_factor = 0.0189;
  p.minimum_factor = 0.0063;
  p.on_target = {0.58, 0.55, 0.61};
  p.on_minimum = {1.0, 1.0, 1.0};
  p.verdict = FactorProvision::Verdict::cannot_tell;
  page.provision = {p};
  page.median_diffuse = 15'900.0;
  const auto html = daylight_page(page);
  for (const char* text :
       {"58 % <span class=\"i\">(55 to 61)</span>", "1.89 % on 50 % of the points", "0.63 % on 95 %",
        "<span class=\"verdict open\">cannot be told yet</span>", "15,900 lx", "Not assessed"})
    EXPECT_TRUE(has(html, text)) << text;
}

TEST(DaylightPage, has_the_ratings_of_a_year) {
  auto page = made_page();
  page.provision.emplace_back();
  page.year.emplace();
  auto& m = page.year->metrics;
  m.autonomy_with_blinds = {0.56, 0.53, 0.59};
  m.sun_exposure = {0.33, 0.33, 0.33};
  m.exposure.mean = {12'345'678.0, 12'000'000.0, 12'500'000.0};
  page.year->hours_mean_300 = {2500.0, 2400.0, 2600.0};
  page.year->hours_min_90 = {2100.0, 2050.0, 2150.0};
  page.plans = {"<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>\n"};
  page.heat_map = page.plans[0];
  auto html = daylight_page(page);
  for (const char* text :
       {"1 to 2 of 3 points, cannot be told yet", "explanation needed", "12,346 klx h",
        "<div class=\"plans\">", "2500 h <span class=\"i\">(2400 to 2600)</span>", "<h2>The year</h2>"})
    EXPECT_TRUE(has(html, text)) << text;
  m.autonomy_with_blinds = {0.3, 0.3, 0.3};
  m.sun_exposure = {0.05, 0.05, 0.05};
  html = daylight_page(page);
  EXPECT_FALSE(has(html, "of 3 points"));
  EXPECT_FALSE(has(html, "explanation needed"));
}

}  // namespace
}  // namespace luxel
