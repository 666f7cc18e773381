// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/opening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "luxel/core/trig.h"

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;

// Uniform over the unit disk.
std::array<double, 2> disk_point(const std::array<double, 2>& u) {
  const auto radius = std::sqrt(u[0]);
  const auto angle = sin_cos(2.0 * exact_pi * u[1]);
  return {radius * angle.cosine, radius * angle.sine};
}

// The axis of a cylinder, 0 to 2.
int axis_of(OpeningShape shape) {
  if (shape == OpeningShape::cylinder_along_x) return 0;
  return shape == OpeningShape::cylinder_along_y ? 1 : 2;
}

// Areas of the faces of a box that are seen in a direction, [axis].
Vec3d box_faces(const Vec3d& size, const Vec3d& direction) {
  const auto d = glm::abs(direction);
  return {size.y * size.z * d.x, size.z * size.x * d.y, size.x * size.y * d.z};
}

Vec3d sample_box(const Vec3d& size, const std::array<double, 2>& u) {
  const auto faces = box_faces(size, Vec3d(1.0));
  auto place = 2.0 * u[0] * (faces.x + faces.y + faces.z);
  int axis = 0;
  while (axis < 2 && place >= 2.0 * faces[axis]) place -= 2.0 * faces[axis++];
  const auto on_axis = faces[axis] > 0.0 ? std::min(2.0, place / faces[axis]) : 1.0;
  Vec3d at(0.0);
  at[axis] = on_axis < 1.0 ? -0.5 : 0.5;
  at[(axis + 1) % 3] = (on_axis < 1.0 ? on_axis : on_axis - 1.0) - 0.5;
  at[(axis + 2) % 3] = u[1] - 0.5;
  return at * size;
}

// The axis is Z. The side of an elliptic cylinder is sampled by angle.
Vec3d sample_cylinder(const Vec3d& size, const std::array<double, 2>& u) {
  const auto side = exact_pi * 0.5 * (size.x + size.y) * size.z, cap = exact_pi / 4.0 * size.x * size.y;
  const auto place = u[0] * (side + 2.0 * cap);
  if (place < side) {
    const auto angle = sin_cos(2.0 * exact_pi * u[1]);
    return {0.5 * size.x * angle.cosine, 0.5 * size.y * angle.sine, size.z * (place / side - 0.5)};
  }
  const bool upper = place - side >= cap;
  const auto [x, y] = disk_point({std::clamp((place - side) / cap - (upper ? 1.0 : 0.0), 0.0, 1.0), u[1]});
  return {0.5 * size.x * x, 0.5 * size.y * y, upper ? 0.5 * size.z : -0.5 * size.z};
}

Vec3d sample_ellipsoid(const Vec3d& size, const std::array<double, 2>& u) {
  const auto z = 2.0 * u[0] - 1.0, radius = std::sqrt(std::max(0.0, 1.0 - z * z));
  const auto angle = sin_cos(2.0 * exact_pi * u[1]);
  return 0.5 * size * Vec3d(radius * angle.cosine, radius * angle.sine, z);
}

// Part of a ray, in m.
struct Span {
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();

  void cut(const Span& other) {
    from = std::max(from, other.from);
    to = std::min(to, other.to);
  }
  // Where it begins before the ray's origin there is nothing to see: the eye is inside.
  std::optional<double> first() const {
    return from <= to && from > 0.0 ? std::optional(from) : std::nullopt;
  }
};

Span within_slab(double half, double origin, double direction) {
  if (direction == 0.0) return std::abs(origin) <= half ? Span{} : Span{1.0, 0.0};
  const auto a = (-half - origin) / direction, b = (half - origin) / direction;
  return {std::min(a, b), std::max(a, b)};
}

// Within the unit sphere, or circle of the first two axes where the third is 0.
Span within_unit(const Vec3d& origin, const Vec3d& direction) {
  const auto a = glm::dot(direction, direction), b = glm::dot(origin, direction);
  const auto c = glm::dot(origin, origin) - 1.0;
  if (!(a > 0.0)) return c <= 0.0 ? Span{} : Span{1.0, 0.0};
  const auto root = b * b - a * c;
  if (root < 0.0) return {1.0, 0.0};
  return {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a};
}

std::optional<double> meet_box(const Vec3d& half, const Vec3d& origin, const Vec3d& direction) {
  Span span;
  for (int axis = 0; axis < 3; ++axis) span.cut(within_slab(half[axis], origin[axis], direction[axis]));
  return span.first();
}

// The axis is Z.
std::optional<double> meet_cylinder(const Vec3d& half, const Vec3d& origin, const Vec3d& direction) {
  const Vec3d scale(1.0 / half.x, 1.0 / half.y, 0.0);
  auto span = within_unit(origin * scale, direction * scale);
  span.cut(within_slab(half.z, origin.z, direction.z));
  return span.first();
}

std::optional<double> meet_ellipsoid(const Vec3d& half, const Vec3d& origin, const Vec3d& direction) {
  return within_unit(origin / half, direction / half).first();
}

// Swaps the axis with Z.
Vec3d with_axis_up(Vec3d v, int axis) {
  std::swap(v[axis], v.z);
  return v;
}

}  // namespace

bool is_flat(const LuminousOpening& opening) {
  return opening.shape == OpeningShape::rectangle || opening.shape == OpeningShape::ellipse ||
         opening.shape == OpeningShape::vertical_disk;
}

double projected_area(const LuminousOpening& opening, const Vec3d& direction) {
  const auto& s = opening.size;
  const auto d = glm::normalize(direction);
  switch (opening.shape) {
    case OpeningShape::point:
      return 0.0;
    case OpeningShape::rectangle:
      return s.x * s.y * std::abs(d.z);
    case OpeningShape::ellipse:
      return exact_pi / 4.0 * s.x * s.y * std::abs(d.z);
    case OpeningShape::vertical_disk:
      return exact_pi / 4.0 * s.z * (s.y * std::abs(d.x) + s.x * std::abs(d.y));
    case OpeningShape::box: {
      const auto faces = box_faces(s, d);
      return faces.x + faces.y + faces.z;
    }
    case OpeningShape::ellipsoid:
      return exact_pi / 4.0 *
             std::sqrt(std::pow(s.y * s.z * d.x, 2) + std::pow(s.z * s.x * d.y, 2) +
                       std::pow(s.x * s.y * d.z, 2));
    case OpeningShape::vertical_cylinder:
    case OpeningShape::cylinder_along_x:
    case OpeningShape::cylinder_along_y: {
      const auto axis = axis_of(opening.shape);
      const auto t = with_axis_up(s, axis), e = with_axis_up(d, axis);
      return t.z * std::hypot(t.y * e.x, t.x * e.y) + exact_pi / 4.0 * t.x * t.y * std::abs(e.z);
    }
  }
  return 0.0;
}

Vec3d sample_opening(const LuminousOpening& opening, const std::array<double, 2>& u) {
  const auto& s = opening.size;
  switch (opening.shape) {
    case OpeningShape::point:
      return Vec3d(0.0);
    case OpeningShape::rectangle:
      return {s.x * (u[0] - 0.5), s.y * (u[1] - 0.5), 0.0};
    case OpeningShape::ellipse: {
      const auto [x, y] = disk_point(u);
      return {0.5 * s.x * x, 0.5 * s.y * y, 0.0};
    }
    case OpeningShape::vertical_disk: {
      const auto [across, z] = disk_point(u);
      return {0.5 * s.x * across, 0.5 * s.y * across, 0.5 * s.z * z};
    }
    case OpeningShape::box:
      return sample_box(s, u);
    case OpeningShape::ellipsoid:
      return sample_ellipsoid(s, u);
    case OpeningShape::vertical_cylinder:
    case OpeningShape::cylinder_along_x:
    case OpeningShape::cylinder_along_y: {
      const auto axis = axis_of(opening.shape);
      return with_axis_up(sample_cylinder(with_axis_up(s, axis), u), axis);
    }
  }
  return Vec3d(0.0);
}

std::optional<double> meet_opening(const LuminousOpening& opening, const Vec3d& origin,
                                   const Vec3d& direction) {
  const auto half = 0.5 * opening.size;
  switch (opening.shape) {
    case OpeningShape::point:
      return std::nullopt;
    case OpeningShape::rectangle:
    case OpeningShape::box:
      return meet_box(half, origin, direction);
    case OpeningShape::ellipse:
      return meet_cylinder(half, origin, direction);
    case OpeningShape::vertical_disk: {
      const auto axis = half.x < half.y ? 0 : 1;
      return meet_cylinder(with_axis_up(half, axis), with_axis_up(origin, axis),
                           with_axis_up(direction, axis));
    }
    case OpeningShape::ellipsoid:
      return meet_ellipsoid(half, origin, direction);
    case OpeningShape::vertical_cylinder:
    case OpeningShape::cylinder_along_x:
    case OpeningShape::cylinder_along_y: {
      const auto axis = axis_of(opening.shape);
      return meet_cylinder(with_axis_up(half, axis), with_axis_up(origin, axis),
                           with_axis_up(direction, axis));
    }
  }
  return std::nullopt;
}

bool holds(const LuminousOpening& opening, const Vec3d& point, double margin) {
  if (opening.shape == OpeningShape::point) return false;
  const auto half = 0.5 * opening.size + margin;
  if (glm::any(glm::greaterThan(glm::abs(point), half))) return false;
  const auto p = point / half;
  switch (opening.shape) {
    case OpeningShape::ellipsoid:
      return glm::dot(p, p) <= 1.0;
    case OpeningShape::ellipse:
    case OpeningShape::vertical_cylinder:
      return p.x * p.x + p.y * p.y <= 1.0;
    case OpeningShape::cylinder_along_x:
      return p.y * p.y + p.z * p.z <= 1.0;
    case OpeningShape::cylinder_along_y:
      return p.x * p.x + p.z * p.z <= 1.0;
    default:
      return true;
  }
}

double bounding_radius(const LuminousOpening& opening) {
  const auto& s = opening.size;
  switch (opening.shape) {
    case OpeningShape::point:
      return 0.0;
    case OpeningShape::ellipse:
    case OpeningShape::vertical_disk:
    case OpeningShape::ellipsoid:
      return 0.5 * std::max({s.x, s.y, s.z});
    default:
      return 0.5 * glm::length(s);
  }
}

}  // namespace luxel
