// SPDX-License-Identifier: Apache-2.0
// The picture of a year, of open ground whose light is known from the weather.
#include "luxel/lighting/heat_map.h"

#include <cmath>
#include <map>
#include <regex>

#include <gtest/gtest.h>

#include "luxel/lighting/metrics.h"
#include "luxel/patch/make_patches.h"

#include "scenes/weather/temperate_year.h"
#include "support/open_sky.h"

namespace luxel {
namespace {

// A point above ground, which hides nothing of the sky, and one below: it has no light from the sky, and none
// from the sun.
struct OpenGround {
  Weather weather = read_weather(scenes::temperate_year(), "made.wea");
  PatchSet patches;
  Context context;
  Tracer tracer;
  DaylightCoefficients coefficients = truth::open_sky(2);
  std::vector<ProbePoint> points = {{Vec3(0, 0, 1), Vec3(0, 0, 1)}, {Vec3(1, 0.3f, -0.02f), Vec3(0, 0, 1)}};
  YearSkies skies = skies_of_year(weather, coefficients.sky, 0.2);
  WindowLight windows = all_windows(0.05);
  DaylightYear year;

  OpenGround()
      : patches(make_patches(truth::open_ground(), {})),
        tracer(patches, context),
        year({coefficients, windows}, skies, points, {patches, tracer}, context) {}
};

TEST(HeatMap, open_ground_has_the_light_of_the_weather) {
  const OpenGround open;
  const auto of_point = hourly_illuminance(open.year, 0), dark = hourly_illuminance(open.year, 1),
             mean = hourly_illuminance(open.year, std::nullopt);
  ASSERT_EQ(of_point.size(), open.year.hours().size());
  for (std::size_t h = 0; h < of_point.size(); ++h) {
    const auto& hour = open.year.hours()[h];
    const auto by_sun = hour.sun_illuminance * std::max(0.0, hour.sun.direction.z);
    // 145 patches have the horizontal illuminance of a sky to 1 %; the disc of the sun is not a point.
    EXPECT_NEAR(static_cast<double>(of_point[h]), hour.sky_illuminance + by_sun,
                0.015 * hour.sky_illuminance + 0.005 * hour.sun_illuminance)
        << h;
    EXPECT_LT(dark[h], 1.0f) << "under the rim of the ground, the setting sun";
    EXPECT_FLOAT_EQ(mean[h], 0.5f * (of_point[h] + dark[h]));
  }
}

// The areas of the colours, days times hours.
std::map<std::string, double> areas_of(const std::string& svg) {
  std::map<std::string, double> areas;
  const std::regex cell("M(\\d+) ([0-9.]+)h1V([0-9.]+)h-1z");
  const std::string path = "<path class=\"hours\" fill=\"", then = "\" d=\"";
  // A path is long: a regular expression over all of it would need more stack than there is.
  for (auto at = svg.find(path); at != std::string::npos; at = svg.find(path, at)) {
    at += path.size();
    const auto colour = svg.substr(at, svg.find('"', at) - at);
    const auto begin = svg.find(then, at) + then.size();
    const auto d = svg.substr(begin, svg.find('"', begin) - begin);
    for (std::sregex_iterator k(d.begin(), d.end(), cell), end; k != end; ++k)
      areas[colour] += std::stod((*k)[2]) - std::stod((*k)[3]);
  }
  return areas;
}

TEST(HeatMap, every_hour_has_a_colour_and_night_is_black) {
  const OpenGround open;
  HeatMap map{
      .title = "Roof & <ground>", .figures = {"a < b"}, .illuminance = hourly_illuminance(open.year, 0)};
  const auto svg = heat_map_svg(map, open.year, open.weather);
  EXPECT_TRUE(svg.starts_with("<svg xmlns"));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_NE(svg.find("Roof &amp; &lt;ground&gt;"), std::string::npos);
  EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
  for (const char* text : {">Jan<", ">Dec<", ">0:00<", ">12:00<", ">24:00<", ">100,000 lx<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  auto areas = areas_of(svg);
  double whole = 0.0;
  for (const auto& [colour, area] : areas) whole += area;
  EXPECT_NEAR(whole, 365.0 * 24.0, 1e-6);
  double dark = 0.0;  // below half a step of the scale from 10 lx to 100,000
  for (const auto lux : map.illuminance) dark += lux < 10.0f * std::pow(1e4f, 0.5f / 39.0f) ? 1.0 : 0.0;
  EXPECT_NEAR(areas["#000004"], 8760.0 - static_cast<double>(map.illuminance.size()) + dark, 1e-6);

  map.illuminance.assign(map.illuminance.size(), 1e6f);
  areas = areas_of(heat_map_svg(map, open.year, open.weather));
  EXPECT_NEAR(areas["#fcffa4"], static_cast<double>(map.illuminance.size()), 1e-6);
}

// A part of a year: what the file lacks is neither dark nor lit.
TEST(HeatMap, hours_that_the_weather_lacks_have_no_colour) {
  OpenGround open;
  auto part = open.weather;
  part.hours.resize(24 * 31);  // January
  const auto skies = skies_of_year(part, open.coefficients.sky, 0.2);
  const DaylightYear year({open.coefficients, open.windows}, skies, open.points, {open.patches, open.tracer},
                          open.context);
  const HeatMap map{.title = "", .figures = {}, .illuminance = hourly_illuminance(year, 0)};
  const auto svg = heat_map_svg(map, year, part);
  double whole = 0.0;
  for (const auto& [colour, area] : areas_of(svg)) whole += area;
  EXPECT_NEAR(whole, 31.0 * 24.0, 1e-6);
  EXPECT_NE(svg.find("fill=\"#999\""), std::string::npos);
}

}  // namespace
}  // namespace luxel
