// SPDX-License-Identifier: Apache-2.0
#include "support/point_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace luxel::truth {
namespace {

// Metres: points closer to a plane count as in it. Rooms here measure metres, corners are floats.
constexpr double in_plane = 1e-6;

struct Plane {
  Vec3d normal;  // unit
  double offset = 0.0;

  double height(const Vec3d& p) const { return glm::dot(normal, p) - offset; }
};

Plane plane_through(const Vec3d& point, const Vec3d& normal) {
  const auto n = glm::normalize(normal);
  return {n, glm::dot(n, point)};
}

Plane plane_of(const ConvexPolygon& p) {
  return plane_through(p.corner[0], glm::cross(p.corner[1] - p.corner[0], p.corner[2] - p.corner[0]));
}

// Cuts in two along a plane (Sutherland and Hodgman 1974).
void cut(const ConvexPolygon& polygon, const Plane& plane, ConvexPolygon& above, ConvexPolygon& below) {
  above.size = below.size = 0;
  for (std::size_t k = 0; k < polygon.size; ++k) {
    const auto& p = polygon.corner[k];
    const auto& q = polygon.corner[(k + 1) % polygon.size];
    const auto hp = plane.height(p);
    const auto hq = plane.height(q);
    if (hp >= 0.0) above.add(p);
    if (hp <= 0.0) below.add(p);
    if ((hp > 0.0 && hq < 0.0) || (hp < 0.0 && hq > 0.0)) {
      const auto between = p + hp / (hp - hq) * (q - p);
      above.add(between);
      below.add(between);
    }
  }
}

double whole_factor(const Vec3d& point, const Vec3d& n, const ConvexPolygon& polygon) {
  if (polygon.size < 3) return 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < polygon.size; ++k) {
    const auto a = polygon.corner[k] - point;
    const auto b = polygon.corner[(k + 1) % polygon.size] - point;
    const auto normal = glm::cross(a, b);
    const auto sine = glm::length(normal);
    if (sine > 0.0) sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(normal, n) / sine;
  }
  return std::abs(sum) / (2.0 * std::numbers::pi);
}

// Replaces the polygons by their parts that the screen does not hide.
void hide(const Vec3d& point, const ConvexPolygon& screen, std::vector<ConvexPolygon>& pieces) {
  auto plane = plane_of(screen);
  const auto height = plane.height(point);
  if (std::abs(height) < in_plane) return;
  if (height > 0.0) plane = {-plane.normal, -plane.offset};  // the far side is above
  Vec3d centre(0.0);
  for (std::size_t k = 0; k < screen.size; ++k) centre += screen.corner[k] / static_cast<double>(screen.size);

  std::vector<ConvexPolygon> visible;
  for (const auto& piece : pieces) {
    if (std::all_of(piece.corner.begin(), piece.corner.begin() + static_cast<std::ptrdiff_t>(piece.size),
                    [&](const Vec3d& p) { return plane.height(p) < in_plane; })) {
      visible.push_back(piece);
      continue;
    }
    ConvexPolygon behind, seen, rest;
    cut(piece, plane, behind, seen);
    if (seen.size > 2) visible.push_back(seen);
    for (std::size_t k = 0; k < screen.size && behind.size > 2; ++k) {
      const auto& p = screen.corner[k];
      auto side = plane_through(point, glm::cross(p - point, screen.corner[(k + 1) % screen.size] - point));
      if (side.height(centre) > 0.0) side = {-side.normal, -side.offset};  // outside is above
      cut(behind, side, seen, rest);
      if (seen.size > 2) visible.push_back(seen);
      behind = rest;
    }
  }
  pieces = std::move(visible);
}

}  // namespace

void ConvexPolygon::add(const Vec3d& p) {
  if (size == corner.size())
    throw std::logic_error("a polygon was cut into more corners than it has room for");
  corner[size++] = p;
}

ConvexPolygon convex_polygon(std::span<const Vec3> corners) {
  ConvexPolygon polygon;
  for (const auto& c : corners) polygon.add(Vec3d(c));
  return polygon;
}

double point_factor(const Vec3d& point, const Vec3d& n, const ConvexPolygon& polygon,
                    std::span<const ConvexPolygon> screens) {
  ConvexPolygon risen, sunk;
  cut(polygon, plane_through(point, n), risen, sunk);
  if (risen.size < 3) return 0.0;
  if (screens.empty()) return whole_factor(point, n, risen);
  std::vector<ConvexPolygon> pieces = {risen};
  for (const auto& screen : screens) hide(point, screen, pieces);
  double sum = 0.0;
  for (const auto& piece : pieces) sum += whole_factor(point, n, piece);
  return sum;
}

}  // namespace luxel::truth
