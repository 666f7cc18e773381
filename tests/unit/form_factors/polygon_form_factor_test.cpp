// SPDX-License-Identifier: Apache-2.0
// Two polygons against Howell's catalogue of closed forms, against closure, and against each other's inverse.
#include "luxel/form_factors/polygon_form_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/core/logarithm.h"
#include "luxel/form_factors/dilogarithm.h"
#include "luxel/form_factors/edge_pair_integral.h"
#include "luxel/lamps/polygon_irradiance.h"

namespace luxel {
namespace {

using Polygon = std::vector<Vec3d>;

constexpr double tight = 1e-13;

const Polygon floor_square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

// In the plane z = height, facing up; or down.
Polygon level(double x0, double x1, double y0, double y1, double height, bool up) {
  Polygon p = {{x0, y0, height}, {x1, y0, height}, {x1, y1, height}, {x0, y1, height}};
  if (!up) std::reverse(p.begin(), p.end());
  return p;
}
// In the plane x = 0, facing +x.
Polygon upright(double z0, double z1, double y0, double y1) {
  return {{0, y0, z0}, {0, y1, z0}, {0, y1, z1}, {0, y0, z1}};
}
// A regular polygon of the same area as the disk.
Polygon disk(double radius, double height, bool up, int sides) {
  const auto turn = 2.0 * M_PI / sides;
  const auto r = radius * std::sqrt(turn / std::sin(turn));
  Polygon p;
  for (int k = 0; k < sides; ++k) p.push_back({r * std::cos(k * turn), r * std::sin(k * turn), height});
  if (!up) std::reverse(p.begin(), p.end());
  return p;
}

Vec3d random_point(std::uint64_t i) {
  const auto u = uniform4(stream_key(7, 0, 0), i);
  return {2.0 * u[0] - 1.0, 2.0 * u[1] - 1.0, 2.0 * u[2] - 1.0};
}

TEST(Logarithm, is_that_of_the_library_to_the_last_digits) {
  for (double x = 1e-300; x < 1e300; x *= 1.37)
    EXPECT_NEAR(natural_logarithm(x), std::log(x), 4e-16 * std::fabs(std::log(x))) << x;
  for (double d = 1e-15; d < 0.1; d *= 3.0) {
    EXPECT_NEAR(natural_logarithm(1.0 + d) / std::log(1.0 + d), 1.0, 4e-16);
    EXPECT_NEAR(natural_logarithm(1.0 - d) / std::log(1.0 - d), 1.0, 4e-16);
  }
  EXPECT_EQ(natural_logarithm(1.0), 0.0);
}

TEST(Dilogarithm, has_its_known_values_and_its_series) {
  const auto at = [](double radius, double angle) {
    return dilogarithm_imaginary(radius, angle, std::cos(angle), std::sin(angle));
  };
  EXPECT_NEAR(at(1.0, M_PI / 2.0), 0.915965594177219015, 2e-15);  // Catalan
  EXPECT_NEAR(at(1.0, M_PI / 3.0), 1.014941606409653625, 2e-15);  // Gieseking
  EXPECT_NEAR(at(1.0, M_PI), 0.0, 2e-15);
  EXPECT_EQ(at(0.0, 1.0), 0.0);
  for (double radius = 0.05; radius < 0.96; radius += 0.05)
    for (double angle = 0.0; angle <= M_PI; angle += M_PI / 16.0) {
      double sum = 0.0;
      for (int k = 900; k > 0; --k) sum += std::pow(radius, k) * std::sin(k * angle) / (k * k);
      EXPECT_NEAR(at(radius, angle), sum, 3e-15) << radius << ", " << angle;
    }
}

TEST(EdgePair, closed_form_and_quadrature_agree_however_the_edges_lie) {
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const Edge p{random_point(4 * i), random_point(4 * i + 1)};
    Edge q{random_point(4 * i + 2), random_point(4 * i + 3)};
    switch (i % 8) {
      case 1:
        q.from = p.from;
        break;  // a shared corner
      case 2:
        q = p;
        break;  // the same edge
      case 3:
        q = {p.to, p.from};
        break;  // seen from the neighbour
      case 4:
        q.to = q.from + 1.3 * (p.to - p.from);
        break;  // parallel
      case 5:
        q.from = p.from + 0.3 * (p.to - p.from);
        break;  // a corner on the other edge
      case 6:
        q.from = p.from + 1e-7 * q.from;
        break;  // all but touching
      case 7:
        q.to = q.from + (p.to - p.from) + 1e-6 * q.to;
        break;  // all but parallel
      default:
        break;
    }
    EXPECT_NEAR(edge_pair_integral(p, q), edge_pair_quadrature(p, q), tight) << i;
    EXPECT_NEAR(edge_pair_quadrature(q, p), edge_pair_quadrature(p, q), tight) << i;
  }
  EXPECT_EQ(edge_pair_integral({{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {2, 0, 0}}), 0.0);
}

TEST(PolygonFormFactor, parallel_rectangles_are_those_of_the_catalogue) {
  const std::vector<std::array<double, 2>> squares = {{0.1, 0.8269945223972565},
                                                      {0.5, 0.4152532835771469},
                                                      {1.0, 0.19982489569838746},
                                                      {2.0, 0.06858958881855287},
                                                      {5.0, 0.012403977313244396}};
  for (const auto& [height, factor] : squares)
    EXPECT_NEAR(polygon_form_factor(floor_square, level(0, 1, 0, 1, height, false)), factor, tight) << height;
  EXPECT_NEAR(polygon_form_factor(level(0, 2, 0, 1, 0, true), level(0, 2, 0, 1, 0.75, false)),
              0.3768301002251056, tight);
  EXPECT_NEAR(polygon_form_factor(floor_square, level(1, 2, 0, 1, 1, false)), 0.08605048915232738, tight);
  EXPECT_NEAR(polygon_form_factor(floor_square, level(2, 4, 1, 2, 1.5, false)), 0.020165025854632312, tight);
}

TEST(PolygonFormFactor, perpendicular_rectangles_are_those_of_the_catalogue) {
  const auto hinged = [](double width, double height, double length) {
    return polygon_form_factor(level(0, width, 0, length, 0, true), upright(0, height, 0, length));
  };
  EXPECT_NEAR(hinged(1, 1, 1), 0.20004377607540316, tight);
  EXPECT_NEAR(hinged(2, 1, 1), 0.11642630139768095, tight);
  EXPECT_NEAR(hinged(1, 2, 1), 0.2328526027953619, tight);
  EXPECT_NEAR(hinged(0.5, 3, 1), 0.3196089562644446, tight);
  EXPECT_NEAR(hinged(1, 0.1, 4), 0.04639418278297642, tight);
  EXPECT_NEAR(polygon_form_factor(level(1, 2, 0, 1, 0, true), upright(0.5, 1.5, 2, 3)), 0.00932689774556128,
              tight);
  EXPECT_NEAR(polygon_form_factor(floor_square, upright(0, 1, 1, 2)), 0.0405922301015587,
              tight);  // at a corner
}

TEST(PolygonFormFactor, squares_hinged_at_any_angle_are_those_of_the_catalogue) {
  const auto hinged = [](double degrees) {
    const auto c = std::cos(degrees * M_PI / 180.0), s = std::sin(degrees * M_PI / 180.0);
    return polygon_form_factor(floor_square, Polygon{{0, 0, 0}, {0, 1, 0}, {c, 1, s}, {c, 0, s}});
  };
  EXPECT_NEAR(hinged(30), 0.619028323091, 1e-12);
  EXPECT_NEAR(hinged(60), 0.370905321150, 1e-12);
  EXPECT_NEAR(hinged(120), 0.086615001118, 1e-12);
  EXPECT_NEAR(hinged(150), 0.021345325413, 1e-12);
  // Folded flat, each sees only the other; unfolded, the factor vanishes as the square of the remaining angle
  // to pi.
  EXPECT_NEAR(hinged(1e-4), 1.0, 3e-6);
  EXPECT_NEAR(hinged(179.99) / hinged(179.9), 0.01, 1e-7);
}

TEST(PolygonFormFactor, triangles_are_those_of_quadrature) {
  const Polygon a = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_NEAR(polygon_exchange_area(a, Polygon{{0.1, 0.2, 1}, {0.3, 1.1, 1.3}, {1.2, 0.4, 0.8}}),
              0.045954893170, 1e-12);
  EXPECT_NEAR(polygon_exchange_area(a, Polygon{{2, 0, 0.5}, {2, 0.5, 2}, {2.2, 1.5, 0.2}}), 0.016649198604,
              1e-12);
  EXPECT_NEAR(polygon_exchange_area(a, Polygon{{0, 0, 0}, {0, 1, 0}, {0.3, 0.2, 0.9}}), 0.151560100573,
              1e-12);
}

TEST(PolygonFormFactor, polygons_of_many_sides_tend_to_disks) {
  const auto disks = [](double r1, double r2, double h, int sides) {
    return polygon_form_factor(disk(r1, 0, true, sides), disk(r2, h, false, sides));
  };
  struct Case {
    double r1, r2, h, factor;
  };
  for (const auto& [r1, r2, h, factor] :
       {Case{1, 1, 1, 0.3819660112501051}, Case{1, 2, 1, 0.7639320225002102},
        Case{0.5, 1, 2, 0.1922359359558481}, Case{1, 1, 0.2, 0.8190024875775822}}) {
    // A polygon of equal area errs as the fourth power of 1 / sides; two of them make that vanish.
    const auto coarse = disks(r1, r2, h, 32), fine = disks(r1, r2, h, 64);
    EXPECT_NEAR(fine, factor, 1e-5);
    EXPECT_NEAR(fine + (fine - coarse) / 15.0, factor, 3e-7) << r1 << ", " << r2 << ", " << h;
  }
}

TEST(PolygonFormFactor, a_meshed_sphere_tends_to_the_sphere) {
  // From a small square to a sphere of radius 1, twice as far: 1/4 head on; the mesh is of equal outline.
  const auto from = [](int rings) {
    const auto turn = M_PI / rings;
    const auto at = [&](int ring, int k) {
      return Vec3d(std::sin(ring * turn) * std::cos(k * turn), std::sin(ring * turn) * std::sin(k * turn),
                   2.0 + std::cos(ring * turn));
    };
    const auto e = 5e-4;
    const Polygon plate = {{-e, -e, 0}, {e, -e, 0}, {e, e, 0}, {-e, e, 0}};
    double sum = 0.0;
    // A convex body does not hide fronts that all points of the plate see, since the plate is small.
    for (int ring = 0; ring < rings; ++ring)
      for (int k = 0; k < 2 * rings; ++k) {
        const Polygon quad = {at(ring, k), at(ring + 1, k), at(ring + 1, k + 1), at(ring, k + 1)};
        sum += polygon_form_factor(plate, Polygon{quad[0], quad[1], quad[2]});
        sum += polygon_form_factor(plate, Polygon{quad[0], quad[2], quad[3]});
      }
    return sum;
  };
  const auto coarse = from(16), fine = from(32);
  EXPECT_NEAR(fine, 0.25, 3e-3);
  EXPECT_NEAR(fine + (fine - coarse) / 3.0, 0.25, 3e-5);
}

TEST(PolygonFormFactor, a_point_is_the_limit_of_a_small_polygon) {
  const auto ceiling = level(0, 1, 0, 1, 1, false);
  EXPECT_NEAR(unit_irradiance(ceiling, {0, 0, 0}, {0, 0, 1}) / M_PI, 0.13853160599489298, 1e-14);
  EXPECT_NEAR(unit_irradiance(upright(0, 1, 0, 1), {1, 0, 0}, {-1, 0, 0}) / M_PI, 0.13853160599489298, 1e-14);
  EXPECT_NEAR(unit_irradiance(upright(0, 1, 0, 1), {1, 0, 0}, {0, 0, 1}) / M_PI, 0.05573419700255351, 1e-14);
  const auto e = 1e-7;
  const auto small = level(-e, e, -e, e, 0, true);
  EXPECT_NEAR(polygon_form_factor(small, ceiling), 0.13853160599489298, 1e-12);
  EXPECT_NEAR(polygon_form_factor(ceiling, small) / (4.0 * e * e), 0.13853160599489298, 1e-12);
}

// Faces of a tetrahedron, inwards: each row sums to one. Needles and flat ones too, which touch everywhere.
TEST(PolygonFormFactor, rows_of_any_tetrahedron_sum_to_one) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    std::array<Vec3d, 4> v;
    for (std::uint64_t k = 0; k < 4; ++k) v[k] = random_point(4 * i + k);
    if (i % 3 == 1) v[3] = v[0] + 1e-3 * (v[3] - v[0]);
    if (i % 3 == 2)
      for (auto& p : v) p.z *= 1e-2;
    if (glm::dot(glm::cross(v[1] - v[0], v[2] - v[0]), v[3] - v[0]) < 0.0) std::swap(v[0], v[1]);
    const std::array<Polygon, 4> faces = {Polygon{v[0], v[1], v[2]}, Polygon{v[0], v[3], v[1]},
                                          Polygon{v[1], v[3], v[2]}, Polygon{v[0], v[2], v[3]}};
    for (const auto& face : faces) {
      double sum = 0.0;
      for (const auto& other : faces)
        if (&other != &face) sum += polygon_exchange_area(face, other);
      const auto area = glm::length(polygon_area_vector(face));
      EXPECT_NEAR(sum, area, 1e-14) << i;
    }
  }
}

TEST(PolygonFormFactor, is_the_same_from_both_sides_and_at_any_place_and_scale) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Polygon a, b;
    for (std::uint64_t k = 0; k < 3; ++k) {
      a.push_back(random_point(6 * i + k));
      b.push_back(random_point(6 * i + 3 + k) * (i % 2 == 0 ? 1.0 : 0.01));
    }
    const auto exchange = polygon_exchange_area(a, b);
    EXPECT_NEAR(polygon_exchange_area(b, a), exchange, 1e-14);
    for (auto* polygon : {&a, &b})
      for (auto& p : *polygon) p = 1000.0 * p + Vec3d(5000.0, 0.0, -3000.0);
    EXPECT_NEAR(polygon_exchange_area(a, b) * 1e-6, exchange, 1e-12);
  }
}

TEST(PolygonFormFactor, far_away_keeps_its_digits) {
  const auto far = level(-0.5, 0.5, -0.5, 0.5, 1e5, false);
  const auto expected = 1.0 / (M_PI * 1e10);
  EXPECT_NEAR(polygon_form_factor(level(-0.5, 0.5, -0.5, 0.5, 0, true), far) / expected, 1.0, 1e-9);
}

TEST(PolygonFormFactor, what_is_behind_neither_gives_nor_gets) {
  // A wall that passes through the floor: only its upper half counts.
  EXPECT_NEAR(polygon_form_factor(floor_square, upright(-1, 1, 0, 1)), 0.20004377607540316, tight);
  // Each through the plane of the other.
  const auto wide = level(-1, 1, 0, 1, 0, true);
  EXPECT_NEAR(polygon_form_factor(wide, upright(-1, 1, 0, 1)), 0.5 * 0.20004377607540316, tight);
  EXPECT_EQ(polygon_form_factor(floor_square, level(0, 1, 0, 1, 1, true)), 0.0);    // seen from behind
  EXPECT_EQ(polygon_form_factor(floor_square, level(0, 1, 0, 1, -1, false)), 0.0);  // below
}

TEST(PolygonFormFactor, what_has_no_area_or_lies_in_one_plane_is_zero) {
  EXPECT_EQ(polygon_form_factor(floor_square, level(1, 2, 0, 1, 0, true)), 0.0);
  EXPECT_EQ(polygon_form_factor(floor_square, level(1, 2, 0, 1, 0, false)), 0.0);
  EXPECT_EQ(polygon_form_factor(floor_square, floor_square), 0.0);
  const Polygon line = {{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}, point = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  for (const auto& nothing : {line, point, Polygon{{0, 0, 1}, {1, 1, 1}}, Polygon{}}) {
    EXPECT_EQ(polygon_form_factor(floor_square, nothing), 0.0);
    EXPECT_EQ(polygon_form_factor(nothing, floor_square), 0.0);
  }
  // A corner given twice changes nothing.
  auto twice = level(0, 1, 0, 1, 1, false);
  twice.insert(twice.begin(), twice.front());
  EXPECT_NEAR(polygon_form_factor(floor_square, twice), 0.19982489569838746, tight);
}

}  // namespace
}  // namespace luxel
