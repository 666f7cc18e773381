// SPDX-License-Identifier: Apache-2.0
#include "scenes/shapes/solids.h"

#include <algorithm>
#include <cmath>

#include "scenes/shapes/sheets.h"

namespace luxel::scenes {
namespace {

// Where a rounded box's face is cut along one axis: two facets of each quarter round belong to this face
// (45 degrees, in equal angles: tan 22.5 = sqrt 2 - 1), the flat part lies between them.
std::vector<double> cuts(double half, double radius, int cells) {
  const auto flat = half - radius;
  const auto facet = radius * (std::sqrt(2.0) - 1.0);
  auto result = std::vector<double>{-half, -flat - facet};
  if (flat < 1e-9) cells = 0;
  for (auto k = 0; k <= cells; ++k) {
    result.push_back(cells == 0 ? 0.0 : flat * (2.0 * k - cells) / cells);
  }
  result.push_back(flat + facet);
  result.push_back(half);
  return result;
}

Vec3d onto_rounded_box(const Vec3d& p, const Vec3d& half, double radius) {
  const auto core = glm::clamp(p, -(half - radius), half - radius);
  return core + radius * glm::normalize(p - core);
}

void add_face(Mesh& mesh, int axis, double side, const Vec3d& half, double radius,
              const std::vector<double>& u, const std::vector<double>& v) {
  const auto first = mesh.points.size();
  for (const auto a : u) {
    for (const auto b : v) {
      auto p = Vec3d(0.0);
      p[axis] = side * half[axis];
      p[(axis + 1) % 3] = a;
      p[(axis + 2) % 3] = b;
      mesh.add_point(onto_rounded_box(p, half, radius));
    }
  }
  for (auto i = 0u; i + 1 < u.size(); ++i) {
    for (auto j = 0u; j + 1 < v.size(); ++j) {
      const auto row = static_cast<std::uint32_t>(v.size());
      const auto a = static_cast<std::uint32_t>(first) + i * row + j;
      if (side > 0.0) {
        mesh.add_quad(a, a + row, a + row + 1, a + 1);
      } else {
        mesh.add_quad(a, a + 1, a + row + 1, a + row);
      }
    }
  }
}

}  // namespace

Mesh box(const Vec3d& size) {
  auto mesh = Mesh{};
  for (auto k = 0; k < 8; ++k) {
    mesh.add_point({(k & 1 ? 0.5 : -0.5) * size.x, k & 2 ? size.y : 0.0, (k & 4 ? 0.5 : -0.5) * size.z});
  }
  mesh.add_quad(0, 1, 5, 4);  // bottom
  mesh.add_quad(2, 6, 7, 3);  // top
  mesh.add_quad(0, 4, 6, 2);  // left
  mesh.add_quad(1, 3, 7, 5);  // right
  mesh.add_quad(0, 2, 3, 1);  // back
  mesh.add_quad(4, 5, 7, 6);  // front
  return mesh;
}

Mesh cut_box(const std::vector<double>& x, double height, const std::vector<double>& z) {
  constexpr auto along = Vec3d(1.0, 0.0, 0.0);
  constexpr auto up = Vec3d(0.0, 1.0, 0.0);
  constexpr auto front = Vec3d(0.0, 0.0, 1.0);
  const auto y = std::vector<double>{0.0, height};
  return welded(
      joined({panel({}, along, front, x, z), panel(height * up, front, along, z, x),
              panel(x.front() * along, front, up, z, y), panel(x.back() * along, up, front, y, z),
              panel(z.front() * front, up, along, y, x), panel(z.back() * front, along, up, x, y)}));
}

Mesh rounded_box(const Vec3d& size, double radius, const glm::ivec3& cells) {
  const auto half = 0.5 * size;
  const std::vector<double> lines[3] = {cuts(half.x, radius, cells.x), cuts(half.y, radius, cells.y),
                                        cuts(half.z, radius, cells.z)};
  auto mesh = Mesh{};
  for (auto axis = 0; axis < 3; ++axis) {
    for (const auto side : {-1.0, 1.0}) {
      add_face(mesh, axis, side, half, radius, lines[(axis + 1) % 3], lines[(axis + 2) % 3]);
    }
  }
  return moved(welded(mesh), {0.0, half.y, 0.0});
}

Mesh chamfered_box(const Vec3d& size, double chamfer) {
  const auto half = 0.5 * size;
  auto mesh = Mesh{};
  // Three points at each corner: the point k of corner c lies on the face across the axis k.
  for (auto corner = 0; corner < 8; ++corner) {
    const auto sign = Vec3d(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
    for (auto axis = 0; axis < 3; ++axis) {
      auto p = half - chamfer;
      p[axis] = half[axis];
      mesh.add_point(sign * p);
    }
  }
  const auto add = [&](const std::vector<std::uint32_t>& ring) {
    const auto& p = mesh.points;
    const auto outwards =
        glm::dot(glm::cross(p[ring[1]] - p[ring[0]], p[ring[2]] - p[ring[0]]), p[ring[0]] + p[ring[2]]) > 0.0;
    if (ring.size() == 3) {
      outwards ? mesh.add_triangle(ring[0], ring[1], ring[2]) : mesh.add_triangle(ring[0], ring[2], ring[1]);
    } else {
      outwards ? mesh.add_quad(ring[0], ring[1], ring[2], ring[3])
               : mesh.add_quad(ring[0], ring[3], ring[2], ring[1]);
    }
  };
  for (auto axis = 0u; axis < 3; ++axis) {
    const auto a = 1u << axis, b = 1u << (axis + 1) % 3, c = 1u << (axis + 2) % 3;
    for (const auto side : {0u, a}) {
      add({3 * side + axis, 3 * (side + b) + axis, 3 * (side + b + c) + axis, 3 * (side + c) + axis});
    }
    // The four edges along the axis.
    for (const auto corner : {0u, b, c, b + c}) {
      const auto u = (axis + 1) % 3, v = (axis + 2) % 3;
      add({3 * corner + u, 3 * (corner + a) + u, 3 * (corner + a) + v, 3 * corner + v});
    }
  }
  for (auto corner = 0u; corner < 8; ++corner) add({3 * corner, 3 * corner + 1, 3 * corner + 2});
  return moved(mesh, {0.0, half.y, 0.0});
}

Mesh cushion(const Vec3d& size, double radius, double puff) {
  return deformed(rounded_box(size, radius, {3, 1, 3}), [&](const Vec3d& p) {
    const auto x = 2.0 * p.x / size.x;
    const auto z = 2.0 * p.z / size.z;
    const auto swell = p.y > 0.5 * size.y ? puff * (1.0 - x * x) * (1.0 - z * z) : 0.0;
    return Vec3d(p.x, p.y + swell, p.z);
  });
}

Mesh pillow(double width, double height, double thickness) {
  const auto seam = std::min(0.04, 0.5 * thickness);
  const auto flat =
      moved(rounded_box({width, height, seam}, 0.5 * seam, {2, 2, 0}), {0.0, -0.5 * height, 0.0});
  return deformed(flat, [&](const Vec3d& p) {
    const auto u = 2.0 * p.x / width;
    const auto v = 2.0 * p.y / height;
    const auto swell = 1.0 + (thickness / seam - 1.0) * std::sqrt((1.0 - u * u) * (1.0 - v * v));
    return Vec3d(p.x * (0.90 + 0.10 * v * v), p.y * (0.90 + 0.10 * u * u), p.z * swell);
  });
}

Mesh prism(const std::vector<glm::dvec2>& outline, double depth) {
  auto mesh = Mesh{};
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const auto z : {0.0, depth}) {
    for (const auto& p : outline) mesh.add_point({p.x, p.y, z});
  }
  for (auto i = 0u; i < n; ++i) {
    const auto next = (i + 1) % n;
    mesh.add_quad(i, next, n + next, n + i);
  }
  for (auto i = 1u; i + 1 < n; ++i) {
    mesh.add_triangle(0, i + 1, i);
    mesh.add_triangle(n, n + i, n + i + 1);
  }
  return mesh;
}

}  // namespace luxel::scenes
