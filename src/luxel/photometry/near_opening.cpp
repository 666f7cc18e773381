// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/near_opening.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "luxel/core/spherical_triangle.h"
#include "luxel/photometry/opening.h"

namespace luxel {
namespace {

constexpr double close = 0.5;  // of the opening's largest extent, from its surface

// A rectangular face, or the rectangle around a round one: its plane is `axis` = `level`.
struct Face {
  int axis = 2;
  double level = 0.0;
};

// A face as seen by a receiver that is not in its plane.
class SeenFace {
 public:
  SeenFace(const LuminousOpening& opening, const Face& face, const Vec3d& receiver)
      : face_(face), receiver_(receiver), halves_(halves_of(opening, face, receiver)) {}

  double solid_angle() const { return halves_[0].solid_angle() + halves_[1].solid_angle(); }

  // Evenly in solid angle.
  Vec3d point(const std::array<double, 2>& u) const {
    const auto first = halves_[0].solid_angle() / solid_angle();
    const bool is_second = u[0] >= first;
    const auto part = is_second ? (u[0] - first) / (1.0 - first) : u[0] / first;
    const auto way = halves_[is_second ? 1 : 0].direction(std::clamp(part, 0.0, 1.0), u[1]);
    auto at = receiver_ + (face_.level - receiver_[face_.axis]) / way[face_.axis] * way;
    at[face_.axis] = face_.level;
    return at;
  }

  // Of a point of the opening, per m²: 0 unless it lies in this face.
  double density(const Vec3d& at) const {
    if (at[face_.axis] != face_.level) return 0.0;
    const auto way = at - receiver_;
    const auto squared = glm::dot(way, way);
    return std::abs(way[face_.axis]) / (squared * std::sqrt(squared) * solid_angle());
  }

 private:
  static std::array<SphericalTriangle, 2> halves_of(const LuminousOpening& opening, const Face& face,
                                                    const Vec3d& receiver) {
    const auto corner = [&](double u, double v) {
      Vec3d at(0.0);
      at[face.axis] = face.level;
      at[(face.axis + 1) % 3] = u * opening.size[(face.axis + 1) % 3];
      at[(face.axis + 2) % 3] = v * opening.size[(face.axis + 2) % 3];
      return at - receiver;
    };
    const auto a = corner(-0.5, -0.5), c = corner(0.5, 0.5);
    return {SphericalTriangle({a, corner(0.5, -0.5), c}), SphericalTriangle({a, c, corner(-0.5, 0.5)})};
  }

  Face face_;
  Vec3d receiver_;
  std::array<SphericalTriangle, 2> halves_;
};

bool is_round(OpeningShape shape) {
  return shape == OpeningShape::ellipse || shape == OpeningShape::vertical_disk;
}

// m² over which sample_opening() is uniform; nothing for shapes that have no flat faces alone.
std::optional<double> area_of(const LuminousOpening& opening) {
  const auto& s = opening.size;
  switch (opening.shape) {
    case OpeningShape::rectangle:
      return s.x * s.y;
    case OpeningShape::ellipse:
      return std::numbers::pi / 4.0 * s.x * s.y;
    case OpeningShape::vertical_disk:
      return std::numbers::pi / 4.0 * std::max(s.x, s.y) * s.z;
    case OpeningShape::box:
      return 2.0 * (s.x * s.y + s.y * s.z + s.z * s.x);
    default:
      return std::nullopt;
  }
}

std::optional<SeenFace> largest_face(const LuminousOpening& opening, const Vec3d& receiver) {
  std::optional<SeenFace> largest;
  for (int axis = 0; axis < 3; ++axis) {
    if (is_flat(opening) && opening.size[axis] > 0.0) continue;
    const auto half = 0.5 * opening.size[axis];
    if (!(std::abs(receiver[axis]) > half)) continue;
    const SeenFace face(opening, {axis, std::copysign(half, receiver[axis])}, receiver);
    if (!largest || face.solid_angle() > largest->solid_angle()) largest = face;
  }
  return largest;
}

// Returns whether a point of the rectangle around a round face lies in the face.
bool is_in_ellipse(const LuminousOpening& opening, const Vec3d& at) {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    if (opening.size[axis] > 0.0) sum += std::pow(2.0 * at[axis] / opening.size[axis], 2);
  return sum <= 1.0;
}

}  // namespace

bool is_close_to(const LuminousOpening& opening, const Vec3d& receiver) {
  const auto outside = glm::max(glm::abs(receiver) - 0.5 * opening.size, Vec3d(0.0));
  const auto reach = close * std::max({opening.size.x, opening.size.y, opening.size.z});
  return glm::dot(outside, outside) < reach * reach;
}

OpeningPoint sample_opening_from(const LuminousOpening& opening, const Vec3d& receiver,
                                 const std::array<double, 2>& u) {
  const auto area = area_of(opening);
  const auto face = area ? largest_face(opening, receiver) : std::nullopt;
  if (!face || !(face->solid_angle() > 0.0)) return {sample_opening(opening, u)};
  const bool by_angle = u[0] < 0.5;
  const std::array<double, 2> rest = {by_angle ? 2.0 * u[0] : 2.0 * u[0] - 1.0, u[1]};
  const auto at = by_angle ? face->point(rest) : sample_opening(opening, rest);
  if (by_angle && is_round(opening.shape) && !is_in_ellipse(opening, at)) return {at, 0.0};
  return {at, 1.0 / (0.5 + 0.5 * *area * face->density(at))};
}

}  // namespace luxel
