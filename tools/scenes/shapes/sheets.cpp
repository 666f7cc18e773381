// SPDX-License-Identifier: Apache-2.0
#include "scenes/shapes/sheets.h"

#include <algorithm>
#include <cmath>

namespace luxel::scenes {

Mesh sheet(int columns, int rows, const std::function<Vec3d(double, double)>& point) {
  auto mesh = Mesh{};
  for (auto j = 0; j <= rows; ++j) {
    for (auto i = 0; i <= columns; ++i) {
      mesh.add_point(point(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    }
  }
  const auto row = static_cast<std::uint32_t>(columns + 1);
  for (auto j = 0; j < rows; ++j) {
    for (auto i = 0; i < columns; ++i) {
      const auto a = static_cast<std::uint32_t>(j) * row + static_cast<std::uint32_t>(i);
      mesh.add_quad(a, a + 1, a + row + 1, a + row);
    }
  }
  return mesh;
}

Mesh panel(const Vec3d& origin, const Vec3d& u, const Vec3d& v, const std::vector<double>& a,
           const std::vector<double>& b, const Skip& skip) {
  auto mesh = Mesh{};
  for (const auto t : b) {
    for (const auto s : a) mesh.add_point(origin + s * u + t * v);
  }
  const auto row = a.size();
  for (std::size_t j = 0; j + 1 < b.size(); ++j) {
    for (std::size_t i = 0; i + 1 < row; ++i) {
      if (skip && skip(0.5 * (a[i] + a[i + 1]), 0.5 * (b[j] + b[j + 1]))) continue;
      const auto first = static_cast<std::uint32_t>(j * row + i);
      const auto next = static_cast<std::uint32_t>(first + row);
      mesh.add_quad(first, first + 1, next + 1, next);
    }
  }
  return mesh;
}

Mesh disc(double radius, double inner_radius, double from, double to, int segments) {
  auto mesh = Mesh{};
  auto on_circle = [&](double r, int k) {
    const auto angle = glm::radians(from + (to - from) * k / segments);
    return mesh.add_point({r * std::cos(angle), r * std::sin(angle), 0.0});
  };
  const auto center = mesh.add_point(Vec3d(0.0));
  auto inner = inner_radius > 0.0 ? on_circle(inner_radius, 0) : center;
  auto outer = on_circle(radius, 0);
  for (auto k = 1; k <= segments; ++k) {
    const auto next_outer = on_circle(radius, k);
    if (inner_radius > 0.0) {
      const auto next_inner = on_circle(inner_radius, k);
      mesh.add_quad(inner, outer, next_outer, next_inner);
      inner = next_inner;
    } else {
      mesh.add_triangle(center, outer, next_outer);
    }
    outer = next_outer;
  }
  return mesh;
}

std::vector<double> steps(const std::vector<double>& stops, double longest) {
  auto result = std::vector<double>{stops.front()};
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const auto length = stops[i + 1] - stops[i];
    const auto n = std::max(1, static_cast<int>(std::ceil(length / longest - 1e-9)));
    for (auto k = 1; k <= n; ++k) result.push_back(stops[i] + length * k / n);
  }
  return result;
}

}  // namespace luxel::scenes
