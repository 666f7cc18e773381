// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/ies_opening.h"

#include <gtest/gtest.h>

#include "support/photometric_files.h"

namespace luxel {
namespace {

struct Case {
  int version;
  Vec3d size;  // width, length, height, m
  OpeningShape shape;
  Vec3d extents;  // along X, Y, Z, m
};

// The tables of the standard's versions, for type C: length along X, width along Y.
const Case cases[] = {
    {1986, {0, 0, 0}, OpeningShape::point, {0, 0, 0}},
    {1991, {1, 2, 0}, OpeningShape::rectangle, {2, 1, 0}},
    {1986, {1, 2, 3}, OpeningShape::box, {2, 1, 3}},
    {1986, {1, 0, 3}, OpeningShape::box, {0, 1, 3}},
    {1991, {0, 2, 3}, OpeningShape::box, {2, 0, 3}},
    {1991, {-1, 0, 0}, OpeningShape::ellipse, {1, 1, 0}},
    {1991, {-1, 0, 3}, OpeningShape::vertical_cylinder, {1, 1, 3}},
    {1986, {-1, 2, 0}, OpeningShape::ellipse, {2, 1, 0}},
    {1986, {-1, 2, 3}, OpeningShape::ellipsoid, {2, 1, 3}},
    {1995, {-1, 0, 0}, OpeningShape::ellipse, {1, 1, 0}},
    {1995, {-1, 0, 3}, OpeningShape::vertical_cylinder, {1, 1, 3}},
    {1995, {-1, 0, -1}, OpeningShape::ellipsoid, {1, 1, 1}},
    {1995, {0, 2, -3}, OpeningShape::cylinder_along_x, {2, 3, 3}},
    {1995, {1, 0, -3}, OpeningShape::cylinder_along_y, {3, 1, 3}},
    {1995, {1, -2, 3}, OpeningShape::vertical_cylinder, {2, 1, 3}},
    {1995, {-1, 2, 3}, OpeningShape::vertical_cylinder, {2, 1, 3}},
    {1995, {1, -2, -3}, OpeningShape::ellipsoid, {2, 1, 3}},
    {1995, {-1, 2, -3}, OpeningShape::ellipsoid, {2, 1, 3}},
    {2002, {-1, -1, 0}, OpeningShape::ellipse, {1, 1, 0}},
    {2019, {-1, -2, 0}, OpeningShape::ellipse, {2, 1, 0}},
    {2002, {-1, -2, 3}, OpeningShape::vertical_cylinder, {2, 1, 3}},
    {2019, {-1, -2, -3}, OpeningShape::ellipsoid, {2, 1, 3}},
    {2002, {-1, 2, -3}, OpeningShape::cylinder_along_x, {2, 1, 3}},
    {2019, {1, -2, -3}, OpeningShape::cylinder_along_y, {2, 1, 3}},
    {2002, {-1, 0, -3}, OpeningShape::vertical_disk, {0, 1, 3}},
    {2002, {0, -2, -3}, OpeningShape::vertical_disk, {0, 2, 3}},
    {2002, {1, 2, 0}, OpeningShape::rectangle, {2, 1, 0}},
};

TEST(IesOpening, has_the_shapes_of_each_version) {
  for (const auto& c : cases) {
    bool is_other = true;
    const auto opening = opening_of(c.version, GoniometerType::c, c.size, is_other);
    ASSERT_TRUE(opening) << c.version;
    EXPECT_FALSE(is_other) << c.version << ' ' << c.size.x << ' ' << c.size.y << ' ' << c.size.z;
    EXPECT_EQ(opening->shape, c.shape) << c.version << ' ' << c.size.x << ' ' << c.size.y << ' ' << c.size.z;
    EXPECT_EQ(opening->size, c.extents) << c.version;
  }
}

TEST(IesOpening, takes_a_lone_negative_width_as_a_disk_in_all_versions_and_warns_from_2002_on) {
  MadeIes file;
  file.size = "-0.3 0 0";
  for (const auto* tag : {"IESNA91\n", "IESNA:LM-63-1995\n", "IESNA:LM-63-2002\n", "IES:LM-63-2019\n"}) {
    file.tag = tag;
    const auto read = file.read();
    EXPECT_EQ(read.opening.shape, OpeningShape::ellipse);
    EXPECT_EQ(read.opening.size, Vec3d(0.3, 0.3, 0.0));
    const bool is_old = std::string(tag) < "IESNA:LM-63-2" && tag[3] == 'N';
    EXPECT_EQ(warnings_of(read).empty(), is_old) << tag << warnings_of(read);
  }
}

TEST(IesOpening, reads_signs_of_other_versions_with_a_warning) {
  MadeIes file;
  file.tag = "IESNA:LM-63-1995\n";
  file.size = "-0.3 -0.3 0";
  EXPECT_EQ(file.read().opening.shape, OpeningShape::ellipse);
  EXPECT_NE(warnings_of(file.read()).find("made.ies:4: the signs of"), std::string::npos);
  file.size = "0 0 -0.3";
  EXPECT_EQ(file.read().opening.shape, OpeningShape::point);
  EXPECT_NE(warnings_of(file.read()).find("a point is taken"), std::string::npos);
}

TEST(IesOpening, is_in_feet_or_metres_and_lies_across_in_types_a_and_b) {
  MadeIes file;
  file.size = "1 2 0";
  EXPECT_EQ(file.read().opening.size, Vec3d(2.0, 1.0, 0.0));
  file.units = "1";
  EXPECT_NEAR(file.read().opening.size.x, 0.6096, 1e-12);
  EXPECT_NEAR(file.read().opening.size.y, 0.3048, 1e-12);
  file.units = "2";
  file.vertical = file.horizontal = "-60 0 60";
  file.candela = "0 1 0 2 9 3 0 4 0";
  for (const char* type : {"2", "3"}) {
    file.type = type;
    EXPECT_EQ(file.read().opening.size, Vec3d(1.0, 2.0, 0.0));
  }
}

}  // namespace
}  // namespace luxel
