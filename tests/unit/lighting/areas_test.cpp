// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/areas.h"

#include <gtest/gtest.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

const Vec3d up(0, 0, 1);

std::vector<CalculationArea> areas(const std::string& text, const Vec3d& axis = up) {
  const auto file = parse_toml(text, "a.toml");
  RequirementTable table;
  table.add(file);
  return areas_of(file, table, axis);
}

void refuses(const std::string& text, const std::string& message) {
  try {
    areas(text);
    FAIL() << text;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

const std::string desk =
    "[[area]]\nname = \"desk\"\nkind = \"task\"\npolygon = [[0, 0], [2, 0], [2, 1], [0, 1]]\nheight = 0.75\n";

TEST(Areas, have_shape_requirement_and_maintenance) {
  const auto all = areas("maintenance = { LLMF = 0.9, LSF = 1, LMF = 0.95, RMF = 0.96 }\n" + desk +
                         "requirement = \"writing\"\nEm = 600\nsurround = true\nEz_height = 1.1\n");
  ASSERT_EQ(all.size(), 3u);
  const auto& task = all[0];
  EXPECT_EQ(task.polygon[2], Vec3d(2, 1, 0.75));
  EXPECT_EQ(task.requirement.Em, 600.0);
  EXPECT_EQ(task.requirement.U0, 0.6);
  EXPECT_EQ(task.requirement.Ez, 150.0);
  EXPECT_EQ(task.requirement.ugr, 19.0);
  EXPECT_TRUE(task.has_cylinders);
  EXPECT_EQ(task.Ez_height, 1.1);
  EXPECT_DOUBLE_EQ(task.maintenance.factor, 0.9 * 0.95 * 0.96);
  EXPECT_EQ(task.maintenance.rmf, 0.96);
  EXPECT_FALSE(task.is_direct);
  // The surround is 0.5 m wide, the background 3 m around that; requirements of 600 lx are those of 750 lx.
  EXPECT_EQ(all[1].name, "desk surround");
  EXPECT_EQ(all[1].requirement.Em, 500.0);
  EXPECT_EQ(all[1].requirement.U0, 0.4);
  EXPECT_NEAR(glm::length(all[1].polygon[0] - Vec3d(-0.5, -0.5, 0.75)), 0.0, 1e-12);
  EXPECT_EQ(all[2].name, "desk background");
  EXPECT_NEAR(*all[2].requirement.Em, 500.0 / 3.0, 1e-12);
  EXPECT_EQ(all[2].requirement.U0, 0.1);
  EXPECT_NEAR(glm::length(all[2].polygon[2] - Vec3d(5.5, 4.5, 0.75)), 0.0, 1e-12);
  EXPECT_EQ(all[2].without[0], all[1].polygon);
}

// A corner twice in succession made an edge without length, and a surround at no finite place.
TEST(Areas, corners_given_twice_count_once) {
  const auto all = areas(
      "[[area]]\nname = \"desk\"\nkind = \"task\"\nheight = 0.75\n"
      "requirement = \"writing\"\nsurround = true\n"
      "polygon = [[0, 0], [2, 0], [2, 0], [2, 1], [0, 1], [0, 0]]\n");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].polygon.size(), 4u);
  EXPECT_NEAR(glm::length(all[1].polygon[0] - Vec3d(-0.5, -0.5, 0.75)), 0.0, 1e-12);
}

TEST(Areas, surrounds_follow_the_scale_of_EN_12464_1) {
  EXPECT_EQ(surround_of(750).Em, 500.0);
  EXPECT_EQ(surround_of(500).Em, 300.0);
  EXPECT_EQ(surround_of(300).Em, 200.0);
  EXPECT_EQ(surround_of(200).Em, 150.0);
  EXPECT_EQ(surround_of(100).Em, 100.0);
  EXPECT_NEAR(*background_of(500).Em, 100.0, 1e-12);
}

TEST(Areas, emergency_areas_are_direct_and_have_the_limits_of_EN_1838) {
  const auto all = areas(
      "[[area]]\nname = \"way\"\nkind = \"escape_route\"\nline = [[0, 0, 0], [8, 0, 0]]\n"
      "[[area]]\nname = \"hall\"\nkind = \"anti_panic\"\ncorner = [0, 0, 0]\nfirst = [8, 0, 0]\nsecond = [0, "
      "5, 0]\n");
  EXPECT_TRUE(all[0].is_direct && all[1].is_direct);
  EXPECT_EQ(all[0].requirement.Emin, 1.0);
  EXPECT_EQ(all[1].requirement.Emin, 0.5);
  EXPECT_EQ(all[1].requirement.max_over_min, 40.0);
  EXPECT_EQ(all[1].border, 0.5);
  EXPECT_EQ(all[1].polygon[2], Vec3d(8, 5, 0));
}

// The whole table is read, names are unique, every row has a source, and planes can judge the requirements of
// each row.
TEST(Requirements, are_a_table_with_sources) {
  const RequirementTable table;
  EXPECT_GE(table.all().size(), 20u);
  for (const auto& r : table.all()) {
    EXPECT_EQ(table.find(r.name), &r) << r.name;
    EXPECT_TRUE(r.source.starts_with("EN 12464-1:2021") || r.source.starts_with("EN 1838")) << r.source;
    EXPECT_TRUE((r.Em && r.U0) || (r.Emin && r.max_over_min)) << r.name;
  }
  const auto& corridor = *table.find("corridor");
  EXPECT_EQ(corridor.Em, 100.0);
  EXPECT_EQ(corridor.U0, 0.4);
  EXPECT_EQ(corridor.ugr, 28.0);
  EXPECT_EQ(table.find("technical-drawing")->ugr, 16.0);
  EXPECT_EQ(table.find("school-stairs")->E_ceiling, 30.0);
  EXPECT_EQ(table.find("castle"), nullptr);
}

TEST(Areas, take_requirements_tilts_and_the_up_axis_of_a_file) {
  const auto all = areas("[requirement.shop]\nEm = 750\nmodelling = [0.3, 0.6]\n" + desk +
                             "requirement = \"shop\"\ntilt = 90\ntowards = [0, 0, 2]\n",
                         Vec3d(0, 1, 0));
  EXPECT_EQ(all[0].polygon[2], Vec3d(2, 0.75, 1)) << "x and z where y is up";
  EXPECT_NEAR(glm::length(*all[0].normal - Vec3d(0, 0, 1)), 0.0, 1e-12);
  EXPECT_EQ(all[0].requirement.source, "a.toml");
  EXPECT_EQ(all[0].requirement.modelling_max, 0.6);
  EXPECT_EQ(all[0].Ez_height, 1.2);
  const auto wall =
      areas("[[area]]\nname = \"w\"\nkind = \"wall\"\nsurface = \"wall*\"\nrequirement = \"writing\"\n");
  EXPECT_EQ(wall[0].requirement.Em, 150.0);
  EXPECT_EQ(wall[0].requirement.U0, 0.1);
  EXPECT_FALSE(wall[0].has_cylinders);
}

TEST(Areas, names_file_and_line_of_errors) {
  refuses("", "a.toml: expected at least one [[area]]");
  refuses("[area]\n", "a.toml:1: expected [[area]] or [requirement.NAME], found [area]");
  refuses("[[area]]\nnam = 1\n", "a.toml:2: there is no key 'nam' here");
  refuses("[[area]]\nkind = \"task\"\n", "a.toml:1: expected a name");
  refuses("[[area]]\nname = \"a\"\nkind = \"desk\"\n", "a.toml:3: kind: expected task, surround");
  refuses("[[area]]\nname = \"a\"\n", "a.toml:1: expected one of corner");
  refuses("[[area]]\nname = \"a\"\nsurface = \"\"\n", "a.toml:3: surface: expected text between");
  refuses("[[area]]\nname = \"a\"\npolygon = [[0, 0], [1, 0], [1, 1]]\n",
          "height: expected it together with");
  refuses("[[area]]\nname = \"a\"\npolygon = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]\n",
          "a.toml:3: polygon: expected");
  refuses("[[area]]\nname = \"a\"\npolygon = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 1]]\n", "in one plane");
  refuses("[[area]]\nname = \"a\"\npolygon = 3\n", "a.toml:3: polygon: expected a list of points");
  refuses("[[area]]\nname = \"a\"\nline = [[0, 0, 0]]\n", "a.toml:3: line: expected two points");
  refuses("[[area]]\nname = \"a\"\ncorner = [0, 0, 0]\n", "expected first and second");
  refuses(desk + "requirement = \"none\"\n", "a.toml:6: requirement: there is no requirement \"none\"");
  refuses(desk + "maintenance = 0\n", "a.toml:6: maintenance: expected a number from 0.01 to 1");
  refuses(desk + "maintenance = { LLMF = 0.9 }\n", "a.toml:6: maintenance: expected a number, or all of");
  refuses(desk + "surround = true\n", "a.toml:6: surround: expected it at an area of kind");
  refuses(desk + "tilt = 30\n", "a.toml:6: tilt: expected it with towards");
  refuses(desk + "normal = [0, 0, 0]\n", "a.toml:6: normal: expected a direction");
  refuses(desk + "facing = [0, 0, 3]\nnormal = [0, 0, 1]\n", "a.toml:6: facing: expected a place");
  refuses(desk + "modelling = [0.6, 0.3]\n", "a.toml:6: modelling: expected the smallest");
  refuses(desk + desk, "a.toml:7: name: there is an area of this name already");
  refuses("[[area]]\nname = \"a\"\nsurface = \"x\"\nEz = 150\n", "expected Ez_height");
}

}  // namespace
}  // namespace luxel
