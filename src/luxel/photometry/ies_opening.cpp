// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/ies_opening.h"

#include <cmath>
#include <utility>

namespace luxel {
namespace {

constexpr int sign_of(double x) { return x < 0.0 ? 0 : x > 0.0 ? 2 : 1; }

// One number per combination of signs, each -1, 0 or 1.
constexpr int signs(int length, int width, int height) {
  return 9 * (length + 1) + 3 * (width + 1) + height + 1;
}

// The opening's sizes along its length, across it, and upright.
using Found = std::optional<LuminousOpening>;

// In the tables, x is length, y is width. d: the sizes without signs.
Found common(int key, const Vec3d& d) {
  switch (key) {
    case signs(0, 0, 0):
      return {{OpeningShape::point, Vec3d(0.0)}};
    case signs(1, 1, 0):
    // Flat ones without a width or a length: lines.
    case signs(1, 0, 0):
    case signs(0, 1, 0):
      return {{OpeningShape::rectangle, d}};
    case signs(1, 1, 1):
    case signs(0, 1, 1):
    case signs(1, 0, 1):
    case signs(0, 0, 1):
      return {{OpeningShape::box, d}};
    case signs(0, -1, 0):
      return {{OpeningShape::ellipse, {d.y, d.y, 0.0}}};
    default:
      return std::nullopt;
  }
}

Found of_1986(int key, const Vec3d& d) {
  switch (key) {
    case signs(0, -1, 1):
      return {{OpeningShape::vertical_cylinder, {d.y, d.y, d.z}}};
    case signs(1, -1, 0):
      return {{OpeningShape::ellipse, d}};
    case signs(1, -1, 1):
      return {{OpeningShape::ellipsoid, d}};
    default:
      return std::nullopt;
  }
}

Found of_1995(int key, const Vec3d& d) {
  switch (key) {
    case signs(0, -1, 1):
      return {{OpeningShape::vertical_cylinder, {d.y, d.y, d.z}}};
    case signs(0, -1, -1):
      return {{OpeningShape::ellipsoid, Vec3d(d.y)}};  // a sphere
    case signs(1, 0, -1):
      return {{OpeningShape::cylinder_along_x, {d.x, d.z, d.z}}};
    case signs(0, 1, -1):
      return {{OpeningShape::cylinder_along_y, {d.z, d.y, d.z}}};
    case signs(-1, 1, 1):
    case signs(1, -1, 1):
      return {{OpeningShape::vertical_cylinder, d}};
    case signs(-1, 1, -1):
    case signs(1, -1, -1):
      return {{OpeningShape::ellipsoid, d}};
    case signs(1, -1, 0):
    case signs(-1, 1, 0):
      return {{OpeningShape::ellipse, d}};
    default:
      return std::nullopt;
  }
}

Found of_2002(int key, const Vec3d& d) {
  switch (key) {
    case signs(-1, -1, 0):
      return {{OpeningShape::ellipse, d}};
    case signs(-1, -1, 1):
      return {{OpeningShape::vertical_cylinder, d}};
    case signs(-1, -1, -1):
      return {{OpeningShape::ellipsoid, d}};
    case signs(1, -1, -1):
      return {{OpeningShape::cylinder_along_x, d}};
    case signs(-1, 1, -1):
      return {{OpeningShape::cylinder_along_y, d}};
    // Facing photometric horizontal; files and codes name either size beside the height.
    case signs(-1, 0, -1):
      return {{OpeningShape::vertical_disk, {0.0, d.x, d.z}}};
    case signs(0, -1, -1):
      return {{OpeningShape::vertical_disk, {0.0, d.y, d.z}}};
    default:
      return std::nullopt;
  }
}

Found any_round(int key, const Vec3d& d) {
  // A diameter where the length should be.
  if (key == signs(-1, 0, 0)) return {{OpeningShape::ellipse, {d.x, d.x, 0.0}}};
  if (key == signs(-1, 0, 1)) return {{OpeningShape::vertical_cylinder, {d.x, d.x, d.z}}};
  return std::nullopt;
}

// Width along X in place of Y.
void turn(LuminousOpening& opening) {
  std::swap(opening.size.x, opening.size.y);
  if (opening.shape == OpeningShape::cylinder_along_x)
    opening.shape = OpeningShape::cylinder_along_y;
  else if (opening.shape == OpeningShape::cylinder_along_y)
    opening.shape = OpeningShape::cylinder_along_x;
}

}  // namespace

std::optional<LuminousOpening> opening_of(int version, GoniometerType type, const Vec3d& width_length_height,
                                          bool& is_other) {
  const auto& given = width_length_height;
  const Vec3d d(std::abs(given.y), std::abs(given.x), std::abs(given.z));
  const auto key = signs(sign_of(given.y) - 1, sign_of(given.x) - 1, sign_of(given.z) - 1);
  const auto own = version < 1995 ? of_1986 : version < 2002 ? of_1995 : of_2002;
  auto found = common(key, d);
  if (!found) found = own(key, d);
  is_other = !found;
  for (const auto other : {of_2002, of_1995, of_1986, any_round})
    if (!found) found = other(key, d);
  if (found && type != GoniometerType::c && found->shape != OpeningShape::vertical_disk) turn(*found);
  return found;
}

}  // namespace luxel
