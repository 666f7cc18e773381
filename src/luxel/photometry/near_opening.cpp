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
// Fraction of the points that are spread evenly over the opening's area. It bounds the weights (Hesterberg
// 1995).
constexpr double even_part = 0.1;

// A rectangular face, or the rectangle around a round one: its plane is `axis` = `level`.
struct Face {
  int axis = 2;
  double level = 0.0;
};

Vec3d sides_of(const LuminousOpening& opening, const Face& face) {
  auto size = opening.size;
  size[face.axis] = 0.0;
  return size;
}

// A face as seen by a receiver.
class SeenFace {
 public:
  SeenFace(const LuminousOpening& opening, const Face& face, const Vec3d& receiver)
      : face_(face), receiver_(receiver), halves_(halves_of(opening, face, receiver)) {}

  // 0 where the receiver lies in its plane.
  double solid_angle() const { return halves_[0].solid_angle() + halves_[1].solid_angle(); }

  // A point of the face, uniform in the solid angle that the receiver sees.
  Vec3d point(const std::array<double, 2>& u) const {
    const auto first = halves_[0].solid_angle() / solid_angle();
    const bool is_second = u[0] >= first;
    const auto part = is_second ? (u[0] - first) / (1.0 - first) : u[0] / first;
    const auto way = halves_[is_second ? 1 : 0].direction(std::clamp(part, 0.0, 1.0), u[1]);
    auto at = receiver_ + (face_.level - receiver_[face_.axis]) / way[face_.axis] * way;
    at[face_.axis] = face_.level;
    return at;
  }

  // Probability density of point() at a point of the face, 1/m².
  double density(const Vec3d& at) const {
    const auto way = at - receiver_;
    const auto squared = glm::dot(way, way);
    return std::abs(way[face_.axis]) / (squared * std::sqrt(squared) * solid_angle());
  }

 private:
  static std::array<SphericalTriangle, 2> halves_of(const LuminousOpening& opening, const Face& face,
                                                    const Vec3d& receiver) {
    const auto half = 0.5 * sides_of(opening, face);
    const auto corner = [&](double u, double v) {
      auto at = half;
      at[(face.axis + 1) % 3] *= u;
      at[(face.axis + 2) % 3] *= v;
      at[face.axis] = face.level;
      return at - receiver;
    };
    const auto a = corner(-1.0, -1.0), c = corner(1.0, 1.0);
    return {SphericalTriangle({a, corner(1.0, -1.0), c}), SphericalTriangle({a, c, corner(-1.0, 1.0)})};
  }

  Face face_;
  Vec3d receiver_;
  std::array<SphericalTriangle, 2> halves_;
};

// The faces of a sheet or a box, and how often each is chosen: about by its solid angle, hidden faces too,
// since they have a part of the light. Made for each sample: a DiscreteDistribution would allocate.
class FaceChoice {
 public:
  FaceChoice(const LuminousOpening& opening, const Vec3d& receiver) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto half = 0.5 * opening.size[axis];
      if (is_flat(opening)) {
        if (half == 0.0) add(opening, {axis, 0.0}, receiver);
      } else {
        add(opening, {axis, -half}, receiver);
        add(opening, {axis, half}, receiver);
      }
    }
  }

  // Leaves u uniform in [0, 1).
  std::size_t choose(double& u) const {
    auto rest = u * sum_;
    std::size_t i = 0;
    while (i + 1 < count_ && rest >= weights_[i]) rest -= weights_[i++];
    u = std::min(rest / weights_[i], std::nextafter(1.0, 0.0));
    return i;
  }
  // The face that a point of the opening lies in.
  std::size_t face_of(const Vec3d& at) const {
    for (std::size_t i = 0; i + 1 < count_; ++i)
      if (at[faces_[i].axis] == faces_[i].level) return i;
    return count_ - 1;
  }
  const Face& face(std::size_t i) const { return faces_[i]; }
  double probability(std::size_t i) const { return weights_[i] / sum_; }

 private:
  // Far away a face's area over the squared distance, close to it a hemisphere.
  void add(const LuminousOpening& opening, const Face& face, const Vec3d& receiver) {
    const auto size = sides_of(opening, face);
    auto outside = glm::max(glm::abs(receiver) - 0.5 * size, Vec3d(0.0));
    outside[face.axis] = receiver[face.axis] - face.level;
    const auto area = size[(face.axis + 1) % 3] * size[(face.axis + 2) % 3];
    const auto weight = area / (glm::dot(outside, outside) + area / (2.0 * std::numbers::pi));
    faces_[count_] = face;
    weights_[count_++] = weight;
    sum_ += weight;
  }

  std::array<Face, 6> faces_;
  std::array<double, 6> weights_{};
  std::size_t count_ = 0;
  double sum_ = 0.0;
};

bool is_round(OpeningShape shape) {
  return shape == OpeningShape::ellipse || shape == OpeningShape::vertical_disk;
}

// m² over which sample_opening() is uniform; nothing for shapes that have other than flat faces.
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
  if (!area) return {sample_opening(opening, u)};
  const FaceChoice faces(opening, receiver);
  const bool is_even = u[0] < even_part;
  std::array<double, 2> rest = {is_even ? u[0] / even_part : (u[0] - even_part) / (1.0 - even_part), u[1]};
  OpeningPoint chosen;
  if (is_even) chosen.at = sample_opening(opening, rest);
  const auto i = is_even ? faces.face_of(chosen.at) : faces.choose(rest[0]);
  const SeenFace face(opening, faces.face(i), receiver);
  const bool is_seen = face.solid_angle() > 0.0;
  if (!is_even) {
    if (!is_seen) return {Vec3d(0.0), 0.0};
    chosen.at = face.point(rest);
    if (is_round(opening.shape) && !is_in_ellipse(opening, chosen.at)) return {chosen.at, 0.0};
  }
  const auto by_angle = is_seen ? faces.probability(i) * face.density(chosen.at) : 0.0;
  chosen.weight = 1.0 / (even_part + (1.0 - even_part) * *area * by_angle);
  return chosen;
}

}  // namespace luxel
