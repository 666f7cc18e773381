// SPDX-License-Identifier: Apache-2.0
#include "scenes/shapes/sweeping.h"

#include <cmath>
#include <numbers>

#include "scenes/shapes/turning.h"

namespace luxel::scenes {
namespace {

Vec3d direction_at(const std::vector<Vec3d>& path, std::size_t i) {
  const auto& before = path[i == 0 ? 0 : i - 1];
  const auto& after = path[i + 1 == path.size() ? i : i + 1];
  return glm::normalize(after - before);
}

// Some unit vector across t, the same for the same t.
Vec3d across(const Vec3d& t) {
  return glm::normalize(glm::cross(t, std::abs(t.y) < 0.9 ? Vec3d(0.0, 1.0, 0.0) : Vec3d(1.0, 0.0, 0.0)));
}

}  // namespace

Mesh tube(const std::vector<Vec3d>& path, const std::vector<double>& radii, int segments) {
  auto mesh = Mesh{};
  const auto n = static_cast<std::uint32_t>(segments);
  auto normal = across(direction_at(path, 0));
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto t = direction_at(path, i);
    normal = glm::normalize(normal - glm::dot(normal, t) * t);
    const auto binormal = glm::cross(t, normal);
    for (auto j = 0; j < segments; ++j) {
      const auto angle = 2.0 * std::numbers::pi * j / segments;
      mesh.add_point(path[i] + radii[i] * (std::cos(angle) * normal + std::sin(angle) * binormal));
    }
  }
  const auto start = mesh.add_point(path.front());
  const auto end = mesh.add_point(path.back());
  const auto last = static_cast<std::uint32_t>(path.size() - 1) * n;
  for (auto j = 0u; j < n; ++j) {
    const auto k = (j + 1) % n;
    for (auto ring = 0u; ring < last; ring += n) {
      mesh.add_quad(ring + j, ring + k, ring + n + k, ring + n + j);
    }
    mesh.add_triangle(start, k, j);
    mesh.add_triangle(end, last + j, last + k);
  }
  return mesh;
}

Mesh tube(const std::vector<Vec3d>& path, double radius, int segments) {
  return tube(path, std::vector<double>(path.size(), radius), segments);
}

Mesh leg(const Vec3d& foot, const Vec3d& head, double foot_radius, double head_radius) {
  // A turned cone, sheared: so its ends stay level, on the floor and under the seat.
  const auto rise = head - foot;
  const auto upright = lathe({{0.0, 0.0}, {foot_radius, 0.0}, {head_radius, rise.y}, {0.0, rise.y}}, 10);
  return deformed(upright, [&](const Vec3d& p) {
    const auto t = p.y / rise.y;
    return Vec3d(p.x + t * rise.x, p.y, p.z + t * rise.z) + foot;
  });
}

std::vector<Vec3d> curve(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, int pieces) {
  auto path = std::vector<Vec3d>{};
  for (auto k = 0; k <= pieces; ++k) {
    const auto t = static_cast<double>(k) / pieces;
    const auto s = 1.0 - t;
    path.push_back(s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d);
  }
  return path;
}

Mesh frame(double width, double height, const std::vector<glm::dvec2>& section) {
  constexpr double corner[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
  auto mesh = Mesh{};
  const auto n = static_cast<std::uint32_t>(section.size());
  for (const auto& [x, y] : corner) {
    for (const auto& s : section) mesh.add_point({x * (0.5 * width + s.x), y * (0.5 * height + s.x), s.y});
  }
  for (auto k = 0u; k < 4; ++k) {
    const auto here = k * n;
    const auto next = (k + 1) % 4 * n;
    for (auto i = 0u; i < n; ++i) {
      const auto j = (i + 1) % n;
      mesh.add_quad(here + i, next + i, next + j, here + j);
    }
  }
  return mesh;
}

}  // namespace luxel::scenes
