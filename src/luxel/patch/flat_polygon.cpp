// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/flat_polygon.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "luxel/core/convex_hull.h"
#include "luxel/core/triangle.h"

namespace luxel {
namespace {

constexpr std::size_t angle_classes = 180;  // per quarter turn: half a degree each
constexpr double normal_classes = 64.0;     // per unit of a normal's coordinate: about a degree each
constexpr double class_shift = 0.377;       // moves round numbers away from the limits of classes

// Returns n or -n: the same result for both.
Vec3d canonical(const Vec3d& n) {
  for (int i = 0; i < 3; ++i)
    if (std::fabs(n[i]) > 1e-3) return n[i] < 0.0 ? -n : n;
  return n;
}

struct PlaneKey {
  std::array<std::int64_t, 4> numbers;
  bool operator==(const PlaneKey&) const = default;
};
struct PlaneHash {
  std::size_t operator()(const PlaneKey& key) const {
    std::uint64_t h = 0;
    for (const auto n : key.numbers)
      h = (h ^ static_cast<std::uint64_t>(n)) * 0x9e3779b97f4a7c15u + (h >> 29);
    return static_cast<std::size_t>(h);
  }
};

// The direction of the maximum length of edges, modulo a quarter turn, as a vector of the plane.
Vec3d main_direction(std::span<const Triangle3> triangles, std::span<const std::uint32_t> members,
                     const Vec3d& a, const Vec3d& b) {
  std::array<double, angle_classes> length{};
  std::array<double, angle_classes> longest{};
  std::array<Vec3d, angle_classes> along{};
  for (const auto t : members)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto edge = Vec3d(triangles[t][(k + 1) % 3]) - Vec3d(triangles[t][k]);
      auto x = glm::dot(edge, a), y = glm::dot(edge, b);
      const auto l = std::sqrt(x * x + y * y);
      if (!(l > 0.0)) continue;
      // Into the first quadrant by quarter turns.
      while (!(x > 0.0 && y >= 0.0)) {
        const auto old = x;
        x = y;
        y = -old;
      }
      const auto quarter = std::min(1.0, (1.0 - x / (x + y)));  // grows with the angle, 0 to 1
      const auto i = static_cast<std::size_t>(quarter * angle_classes + class_shift) % angle_classes;
      length[i] += l;
      if (l > longest[i]) {
        longest[i] = l;
        along[i] = edge;
      }
    }
  const auto best = std::max_element(length.begin(), length.end()) - length.begin();
  return along[static_cast<std::size_t>(best)];
}

double cross(const std::array<double, 2>& o, const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

}  // namespace

std::array<double, 2> FlatFrame::flat(const Vec3& point) const {
  const auto from = Vec3d(point) - origin;
  return {glm::dot(from, axis[0]), glm::dot(from, axis[1])};
}

Vec3 FlatFrame::in_space(const std::array<double, 2>& point) const {
  return Vec3(origin + point[0] * axis[0] + point[1] * axis[1]);
}

FlatFrame frame_of(std::span<const Triangle3> triangles, std::span<const std::uint32_t> members) {
  FlatFrame frame;
  double area = 0.0;
  for (const auto t : members) {
    const auto& [a, b, c] = triangles[t];
    const auto normal2 = canonical(area_vector2(a, b, c));
    const auto own = glm::length(normal2);
    frame.normal += normal2;
    frame.origin += own / 3.0 * (Vec3d(a) + Vec3d(b) + Vec3d(c));
    area += own;
  }
  frame.origin /= area;
  frame.normal = glm::normalize(frame.normal);
  const auto other = std::fabs(frame.normal.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const auto a = glm::normalize(glm::cross(frame.normal, other));
  const auto along = main_direction(triangles, members, a, glm::cross(frame.normal, a));
  frame.axis[0] = glm::normalize(along - glm::dot(along, frame.normal) * frame.normal);
  frame.axis[1] = glm::cross(frame.normal, frame.axis[0]);
  return frame;
}

std::vector<std::array<double, 2>> convex_hull(std::vector<std::array<double, 2>> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  const auto extent = std::max(points.back()[0] - points.front()[0], 1e-30);
  const auto least = 1e-9 * extent * extent;
  return hull_of_sorted(
      points, [&](const auto& a, const auto& b, const auto& c) { return !(cross(a, b, c) <= least); });
}

double area_of(std::span<const std::array<double, 2>> polygon) {
  double area2 = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) area2 += cross(polygon[0], polygon[i - 1], polygon[i]);
  return 0.5 * area2;
}

std::vector<std::vector<std::uint32_t>> group_by_plane(std::span<const Triangle3> triangles,
                                                       double tolerance) {
  std::vector<std::vector<std::uint32_t>> planes;
  std::unordered_map<PlaneKey, std::size_t, PlaneHash> plane_of;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const auto normal2 = area_vector2(a, b, c);
    const auto length = glm::length(normal2);
    if (!(length > 0.0)) continue;
    const auto n = canonical(normal2 / length);
    const auto class_of = [](double x) { return static_cast<std::int64_t>(std::floor(x + class_shift)); };
    const PlaneKey key{{class_of(normal_classes * n.x), class_of(normal_classes * n.y),
                        class_of(normal_classes * n.z), class_of(glm::dot(n, Vec3d(a)) / tolerance)}};
    const auto [at, is_new] = plane_of.try_emplace(key, planes.size());
    if (is_new) planes.emplace_back();
    planes[at->second].push_back(t);
  }
  return planes;
}

}  // namespace luxel
