// SPDX-License-Identifier: Apache-2.0
#include "bench/mesher.h"

#include <algorithm>
#include <cmath>

namespace luxel::bench {
namespace {

// The same bits from either end.
Vec3d between(const Vec3d& a, const Vec3d& b, int step, int steps) {
  return (a * static_cast<double>(steps - step) + b * static_cast<double>(step)) / static_cast<double>(steps);
}

int cells_along(const Vec3& a, const Vec3& b, float cell) {
  return std::max(1, static_cast<int>(std::ceil(glm::distance(a, b) / cell - 1e-3f)));
}

}  // namespace

void Mesher::material(const char* name, const Vec3& reflectance, const Vec3& emittance) {
  scene_.materials.push_back({name, reflectance, emittance, true});
}

void Mesher::quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  grid({a, b, c, d}, std::max(cells_along(a, b, cell_), cells_along(d, c, cell_)),
       std::max(cells_along(a, d, cell_), cells_along(b, c, cell_)));
}

void Mesher::whole_quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  grid({a, b, c, d}, 1, 1);
}

void Mesher::box(const Vec3& low, const Vec3& high, bool inwards) {
  const auto corner = [&](int i) {
    return Vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
  };
  constexpr int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                               {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces)
    inwards ? quad(corner(f[3]), corner(f[2]), corner(f[1]), corner(f[0]))
            : quad(corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3]));
}

Scene Mesher::take() {
  scene_.source = "bench";
  scene_.groups = {"default"};
  return std::move(scene_);
}

void Mesher::grid(const std::array<Vec3, 4>& corners, int columns, int rows) {
  const auto first = static_cast<std::uint32_t>(scene_.positions.size());
  const auto& [a, b, c, d] = corners;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      scene_.positions.emplace_back(between(between(a, b, i, columns), between(d, c, i, columns), j, rows));
  const auto row = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j)
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(columns); ++i) {
      const auto p = first + j * row + i;
      for (const auto& t : {std::array{p, p + 1, p + row + 1}, std::array{p, p + row + 1, p + row}}) {
        scene_.triangles.push_back(t);
        scene_.triangle_material.push_back(static_cast<MaterialId>(scene_.materials.size() - 1));
        scene_.triangle_line.push_back(0);
        scene_.triangle_group.push_back(0);
      }
    }
}

}  // namespace luxel::bench
