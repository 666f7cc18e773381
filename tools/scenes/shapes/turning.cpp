// SPDX-License-Identifier: Apache-2.0
#include "scenes/shapes/turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace luxel::scenes {
namespace {

constexpr auto axis = 1e-9;  // m; a radius below it is a point of the axis

// One ring of points, or the single point where the profile meets the axis.
std::vector<std::uint32_t> add_ring(Mesh& mesh, const glm::dvec2& at, int segments) {
  auto ring = std::vector<std::uint32_t>{};
  for (auto j = 0; j < segments; ++j) {
    if (at.x < axis && j > 0) {
      ring.push_back(ring.front());
      continue;
    }
    const auto angle = 2.0 * std::numbers::pi * j / segments;
    ring.push_back(mesh.add_point({at.x * std::cos(angle), at.y, at.x * std::sin(angle)}));
  }
  return ring;
}

void add_band(Mesh& mesh, const std::vector<std::uint32_t>& low, const std::vector<std::uint32_t>& high) {
  for (auto j = 0u; j < low.size(); ++j) {
    const auto k = (j + 1) % low.size();
    if (low[j] == low[k]) {
      mesh.add_triangle(low[j], high[j], high[k]);
    } else if (high[j] == high[k]) {
      mesh.add_triangle(low[j], high[j], low[k]);
    } else {
      mesh.add_quad(low[j], high[j], high[k], low[k]);
    }
  }
}

}  // namespace

Mesh lathe(const Profile& profile, int segments) {
  auto mesh = Mesh{};
  auto last = add_ring(mesh, profile.front(), segments);
  for (auto i = 1u; i < profile.size(); ++i) {
    auto ring = add_ring(mesh, profile[i], segments);
    add_band(mesh, last, ring);
    last = std::move(ring);
  }
  return mesh;
}

Profile smooth(const Profile& profile, int steps) {
  auto result = Profile{profile.front()};
  const auto n = static_cast<int>(profile.size());
  for (auto i = 0; i + 1 < n; ++i) {
    const auto a = profile[static_cast<std::size_t>(std::max(i - 1, 0))];
    const auto b = profile[static_cast<std::size_t>(i)];
    const auto c = profile[static_cast<std::size_t>(i + 1)];
    const auto d = profile[static_cast<std::size_t>(std::min(i + 2, n - 1))];
    for (auto k = 1; k <= steps; ++k) {
      const auto t = static_cast<double>(k) / steps;
      const auto p = 0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t +
                            (3.0 * b - a - 3.0 * c + d) * t * t * t);
      result.push_back(k == steps ? c : glm::dvec2(std::max(p.x, 0.002), p.y));
    }
  }
  return result;
}

Mesh sphere(double radius, int segments) {
  auto profile = Profile{};
  const auto rings = segments / 2;
  for (auto i = 0; i <= rings; ++i) {
    const auto angle = std::numbers::pi * i / rings;
    const auto at_pole = i == 0 || i == rings;
    profile.emplace_back(at_pole ? 0.0 : radius * std::sin(angle), -radius * std::cos(angle));
  }
  return lathe(profile, segments);
}

Mesh cylinder(double radius, double height, int segments) {
  return lathe({{0.0, 0.0}, {radius, 0.0}, {radius, height}, {0.0, height}}, segments);
}

}  // namespace luxel::scenes
