// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/luminaire_mesh.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/photometry/opening.h"

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;

// Half the area of a closed mesh as seen in a direction is its projected area; of a sheet it is the whole.
double mesh_area(const LuminaireMesh& mesh, const Vec3d& direction, bool is_sheet) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    sum += 0.5 * std::abs(glm::dot(glm::cross(b - a, c - a), direction));
  }
  return is_sheet ? sum : 0.5 * sum;
}

std::vector<LuminousOpening> shapes() {
  using enum OpeningShape;
  return {{rectangle, {1.2, 0.5, 0.0}},
          {ellipse, {1.2, 0.5, 0.0}},
          {vertical_disk, {0.0, 0.5, 0.3}},
          {vertical_disk, {0.5, 0.0, 0.3}},
          {box, {1.2, 0.5, 0.3}},
          {vertical_cylinder, {1.2, 0.5, 0.3}},
          {cylinder_along_x, {1.2, 0.5, 0.3}},
          {cylinder_along_y, {1.2, 0.5, 0.3}},
          {ellipsoid, {1.2, 0.5, 0.3}}};
}

// 32 parts of a circle have 0.64 % less area than the circle; a sphere of 32 x 16 parts about 1.3 % less.
TEST(OpeningMesh, has_the_projected_area_of_its_opening) {
  for (const auto& opening : shapes())
    for (const auto& direction :
         {Vec3d(0.0, 0.0, -1.0), Vec3d(1.0, 0.0, 0.0), Vec3d(0.0, 1.0, 0.0), Vec3d(0.48, 0.6, -0.64)}) {
      const auto expected = projected_area(opening, direction);
      for (const int steps : {1, 4}) {
        const auto found = mesh_area(opening_mesh(opening, steps), direction, is_flat(opening));
        EXPECT_NEAR(found, expected, 0.015 * expected + 1e-9) << static_cast<int>(opening.shape);
      }
    }
}

// Windings and normals agree; of a closed mesh both look away from the centre, of a horizontal sheet down.
TEST(OpeningMesh, looks_outwards) {
  for (const auto& opening : shapes()) {
    const auto mesh = opening_mesh(opening, 2);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_FALSE(mesh.triangles.empty());
    for (const auto& t : mesh.triangles) {
      const auto& p = mesh.positions;
      const auto across = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
      const auto centre = (p[t[0]] + p[t[1]] + p[t[2]]) / 3.0f;
      for (const auto v : t) EXPECT_GT(glm::dot(across, mesh.normals[v]), 0.0f);
      if (!is_flat(opening)) {
        EXPECT_GT(glm::dot(across, centre), 0.0f) << static_cast<int>(opening.shape);
      } else if (opening.size.z == 0.0) {
        EXPECT_LT(across.z, 0.0f);
      }
    }
    for (const auto& p : mesh.positions)
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_LE(std::abs(static_cast<double>(p[axis])), 0.5 * opening.size[axis] + 1e-6);
  }
}

TEST(OpeningMesh, of_a_point_is_a_small_sphere) {
  EXPECT_TRUE(opening_mesh({}).triangles.empty());
  const auto shown = shown_opening({});
  EXPECT_EQ(shown.shape, OpeningShape::ellipsoid);
  EXPECT_NEAR(projected_area(shown, {0.0, 0.0, 1.0}), exact_pi * 0.02 * 0.02, 1e-12);
  const LuminousOpening panel{OpeningShape::rectangle, {0.6, 0.6, 0.0}};
  EXPECT_EQ(shown_opening(panel).size, panel.size);
}

// A cosine distribution: the solid is a sphere of diameter 1 below its centre.
TEST(PhotometricSolid, of_a_cosine_distribution_is_a_sphere) {
  std::vector<double> angles, candela;
  for (int i = 0; i <= 180; ++i) {
    angles.push_back(0.5 * i);
    candela.push_back(800.0 * std::cos(angles.back() * exact_pi / 180.0));
  }
  candela.back() = 0.0;
  const auto solid = photometric_solid({GoniometerType::c, angles, {0.0}, candela});
  ASSERT_EQ(solid.radius.size(), PhotometricSolid::rows * PhotometricSolid::columns);
  for (std::size_t row = 0; row < PhotometricSolid::rows; ++row)
    for (std::size_t column = 0; column <= PhotometricSolid::columns; ++column) {
      const auto at = solid.point(row, column);
      if (row <= 36) {
        EXPECT_NEAR(glm::length(at - Vec3d(0.0, 0.0, -0.5)), 0.5, 1e-4);
      } else {
        EXPECT_EQ(glm::length(at), 0.0);
      }
    }
}

// Horizontal angle 90 lies along +Y: only there does this distribution have its largest intensity.
TEST(PhotometricSolid, has_the_orientation_of_the_distribution) {
  const IntensityDistribution intensity(GoniometerType::c, {0.0, 90.0}, {0.0, 90.0, 180.0, 270.0},
                                        {100.0, 200.0, 100.0, 400.0, 100.0, 200.0, 100.0, 100.0});
  const auto solid = photometric_solid(intensity);
  EXPECT_NEAR(solid.radius[0], 0.25, 1e-6);
  const auto largest = solid.point(36, 6);
  EXPECT_NEAR(largest.y, 1.0, 1e-6);
  EXPECT_NEAR(glm::length(largest), 1.0, 1e-6);
  EXPECT_NEAR(solid.point(36, 0).x, 0.5, 1e-6);
  EXPECT_NEAR(solid.point(36, 18).y, -0.25, 1e-6);
}

}  // namespace
}  // namespace luxel
