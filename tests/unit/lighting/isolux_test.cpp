// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/isolux.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "luxel/lighting/plane_svg.h"
#include "luxel/lighting/plane_vtp.h"

namespace luxel {
namespace {

// A grid of 2 x 1 m with a value at each point.
PlaneResult plane(std::size_t columns, std::size_t rows, const std::vector<double>& values) {
  PlaneResult r;
  r.area.name = "desk & <chair>";
  r.grid.width = 2.0;
  r.grid.height = 1.0;
  r.grid.columns = columns;
  r.grid.rows = rows;
  r.grid.outline = {{{0, 0}, {2, 0}, {2, 1}, {0, 1}}};
  for (std::uint32_t c = 0; c < values.size(); ++c) {
    if (values[c] < 0.0) continue;  // no point
    const auto m = r.grid.middle(c);
    r.grid.cell.push_back(c);
    r.grid.position.push_back({m.x, m.y, 0.0});
    ProbedLight light;
    light.illuminance = values[c];
    r.light.push_back(light);
  }
  r.mean.value = 150.0;
  return r;
}

std::vector<double> values_of(const PlaneResult& r) {
  std::vector<double> values;
  for (const auto& light : r.light) values.push_back(light.illuminance);
  return values;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Isolux, levels_are_those_of_the_trade_or_round) {
  EXPECT_EQ(isolux_levels(90, 520), (std::vector<double>{100, 150, 200, 300, 500}));
  EXPECT_EQ(isolux_levels(460, 505), (std::vector<double>{470, 480, 490, 500}));
  EXPECT_TRUE(isolux_levels(5, 5).empty());
  for (const auto& [low, high] : {std::pair{0.0, 1.0}, {0.0, 730.0}, {3.0, 41'000.0}, {100.0, 101.0}}) {
    const auto levels = isolux_levels(low, high);
    EXPECT_GE(levels.size(), 4u) << high;
    EXPECT_LE(levels.size(), 14u) << high;
    EXPECT_GT(levels.front(), low);
    EXPECT_LT(levels.back(), high);
  }
}

// Values that grow along x: the line of 150 lx lies half-way between the columns of 100 and 200 lx.
TEST(Isolux, lines_of_a_slope_are_straight) {
  const auto r = plane(4, 2, {0, 100, 200, 300, 0, 100, 200, 300});
  const auto lines = isolux_lines(r.grid, values_of(r), {150});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].is_closed);
  EXPECT_EQ(lines[0].points.size(), 9u);
  for (const auto& p : lines[0].points) EXPECT_NEAR(p.x, 1.0, 1e-12);
  EXPECT_NEAR(std::abs(lines[0].points.front().y - lines[0].points.back().y), 0.5, 1e-12);
}

// The bilinear interpolant of one square is 100 s t: its lines are the hyperbolas s t = constant.
TEST(Isolux, lines_follow_the_bilinear_interpolant) {
  const auto r = plane(2, 2, {0, 0, 0, 100});
  const auto lines = isolux_lines(r.grid, values_of(r), {25});
  ASSERT_EQ(lines.size(), 1u);
  for (const auto& p : lines[0].points) {
    const auto s = (p.x - 0.5) / 1.0, t = (p.y - 0.25) / 0.5;
    EXPECT_NEAR(s * t, 0.25, 0.25 / 64) << "to the size of the lattice, squared";
  }
}

// A paraboloid is reproduced between inner points, so that its lines are circles although the grid is coarse:
// the chords of a bilinear interpolant would be off by up to an eighth of the spacing squared over the
// radius.
TEST(Isolux, lines_of_a_paraboloid_are_circles) {
  std::vector<double> values;
  const auto empty = plane(9, 9, std::vector<double>(81, 0.0));
  const Vec2d middle(1.0, 0.5);
  for (const auto& at : empty.grid.position) {
    const auto d = (Vec2d(at.x, at.y) - middle) * Vec2d(1.0, 2.0);
    values.push_back(1000.0 - 1000.0 * glm::dot(d, d));
  }
  const auto r = plane(9, 9, values);
  const auto lines = isolux_lines(r.grid, values_of(r), {750});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].is_closed);
  for (const auto& p : lines[0].points)
    EXPECT_NEAR(glm::length((p - middle) * Vec2d(1.0, 2.0)), 0.5, 2e-3) << "spacing 0.22, radius 0.5";
}

TEST(Isolux, hills_have_closed_lines_and_saddles_two_open_ones) {
  const auto hill = plane(3, 3, {0, 0, 0, 0, 100, 0, 0, 0, 0});
  const auto closed = isolux_lines(hill.grid, values_of(hill), {50});
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_TRUE(closed[0].is_closed);
  const auto saddle = plane(2, 2, {100, 0, 0, 100});
  EXPECT_EQ(isolux_lines(saddle.grid, values_of(saddle), {40}).size(), 2u);
  EXPECT_EQ(isolux_lines(saddle.grid, values_of(saddle), {60}).size(), 2u);
  EXPECT_EQ(isolux_lines(saddle.grid, values_of(saddle), {100.1}).size(), 0u);
}

TEST(Isolux, lines_end_beside_cells_without_a_point) {
  const auto r = plane(4, 2, {0, 100, 200, 300, 0, 100, -1, 300});
  const auto values = values_of(r);
  EXPECT_EQ(isolux_lines(r.grid, values, {50}).size(), 1u);
  EXPECT_EQ(isolux_lines(r.grid, values, {150}).size(), 0u);
}

TEST(PlaneSvg, has_lines_labels_and_values_inside_of_the_picture) {
  const auto r = plane(4, 2, {0, 100, 200, 300, 0, 100, 200, 300});
  PlaneDrawing drawing;
  drawing.plan = {{{-1, -1}, {3, -1}, {3, 2}, {-1, 2}, {-1, -1}}};
  const auto lines = isolux_svg(r, drawing);
  EXPECT_TRUE(lines.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_TRUE(lines.ends_with("</svg>\n"));
  EXPECT_EQ(count(lines, "<svg"), count(lines, "</svg>"));
  const auto levels = isolux_levels(0, 300).size();
  EXPECT_EQ(count(lines, "class=\"isolux\""), levels);
  EXPECT_NE(lines.find("desk &amp; &lt;chair&gt;"), std::string::npos);
  EXPECT_EQ(lines.find("class=\"value\""), std::string::npos);
  EXPECT_NE(lines.find("0.5 m</text>"), std::string::npos) << "scale bar";
  drawing.has_values = true;
  EXPECT_EQ(count(isolux_svg(r, drawing), "class=\"value\""), 8u);
  const auto grid = value_grid_svg(r, drawing);
  EXPECT_EQ(count(grid, "class=\"value\""), 8u);
  EXPECT_EQ(count(grid, "class=\"isolux\""), 0u);
  EXPECT_EQ(count(grid, "fill-opacity=\"0.22\""), 8u);
  EXPECT_EQ(grid.find("\"nan"), std::string::npos);
  // Even light has no lines; a single point has a picture.
  EXPECT_EQ(count(isolux_svg(plane(1, 1, {5})), "class=\"isolux\""), 0u);
}

// Numbers of neighbouring points do not meet and are large enough for paper, on any grid.
TEST(PlaneSvg, values_can_be_read_on_fine_grids) {
  for (const auto& [columns, rows] :
       {std::pair<std::size_t, std::size_t>{10, 6}, {90, 4}, {8, 60}, {120, 80}}) {
    const auto r = plane(columns, rows, std::vector<double>(columns * rows, 734.0));
    const auto svg = value_grid_svg(r, {.plan = {}, .max_height = 290.0, .title = {}});
    double size = 0.0, last_x = -1e9, last_y = -1e9;
    std::size_t found = 0;
    for (auto at = svg.find("class=\"value\" x=\""); at != std::string::npos;
         at = svg.find("class=\"value\" x=\"", at + 1)) {
      double x = 0.0, y = 0.0;
      ASSERT_EQ(std::sscanf(svg.c_str() + at,
                            "class=\"value\" x=\"%lf\" y=\"%lf\" text-anchor=\"middle\" font-size=\"%lf\"",
                            &x, &y, &size),
                3);
      EXPECT_GE(size, 7.0);
      constexpr double digit = 0.556;  // width of a digit of Helvetica over the text size
      if (y == last_y) {
        EXPECT_GE(x - last_x, 3.0 * digit * size) << columns;
      } else if (found > 0) {
        EXPECT_GE(std::abs(y - last_y), size) << rows;
      }
      last_x = x;
      last_y = y;
      ++found;
    }
    EXPECT_GT(found, 20u) << columns << " x " << rows;
  }
}

TEST(PlaneSvg, an_escape_route_has_a_profile_with_its_required_minimum) {
  auto r = plane(5, 1, {3, 2, 1.5, 2, 3});
  r.grid.height = 0.0;
  r.area.requirement.Emin = 1.0;
  r.area.is_direct = true;
  const auto svg = isolux_svg(r);
  EXPECT_EQ(count(svg, "<circle"), 5u);
  EXPECT_EQ(count(svg, "class=\"profile\""), 1u);
  EXPECT_NE(svg.find("required 1 lx"), std::string::npos);
  EXPECT_NE(svg.find("direct light only"), std::string::npos);
  EXPECT_TRUE(has_isolux_lines(r));
}

TEST(PlaneSvg, a_band_of_one_row_has_no_lines) {
  const auto band = plane(3, 3, {1, 2, 3, 4, -1, 5, 6, 7, 8});
  EXPECT_FALSE(has_isolux_lines(band));
  EXPECT_TRUE(has_isolux_lines(plane(2, 2, {1, 2, 3, 4})));
}

TEST(PlaneSvg, states_the_maintenance_that_applies) {
  auto r = plane(2, 2, {1, 2, 3, 4});
  EXPECT_NE(isolux_svg(r).find("illuminance in lx, initial"), std::string::npos);
  r.luminaires = {0.8, 0.8};
  EXPECT_NE(isolux_svg(r).find("maintenance factor of the luminaires 0.80"), std::string::npos);
  EXPECT_EQ(value_grid_svg(r).find("initial"), std::string::npos);
}

TEST(PlaneVtp, has_a_rectangle_per_point) {
  const auto r = plane(4, 2, {0, 100, 200, 300, 0, 100, -1, 300});
  const auto text = vtp_of(std::vector{r, r});
  EXPECT_NE(text.find("NumberOfPoints=\"56\" NumberOfVerts=\"0\""), std::string::npos);
  EXPECT_NE(text.find("NumberOfPolys=\"14\""), std::string::npos);
  EXPECT_NE(text.find("Name=\"illuminance_lx\" format=\"ascii\">0 100 200 300 0 100 300 0 100"),
            std::string::npos);
  EXPECT_NE(text.find("Name=\"area\" format=\"ascii\">0 0 0 0 0 0 0 1 1"), std::string::npos);
}

}  // namespace
}  // namespace luxel
