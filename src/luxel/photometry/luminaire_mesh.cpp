// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/luminaire_mesh.h"

#include <algorithm>
#include <numbers>

#include "luxel/core/trig.h"

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;
constexpr double point_diameter = 0.04;  // m, of what stands for a point
constexpr std::uint32_t around = 32;     // parts of a circle

// Adds vertices in a grid and the triangles between them.
class MeshMaker {
 public:
  // place(u, v), normal(u, v): u and v run from 0 to 1 along `columns` and `rows` parts; the faces look where
  // the u-direction turned towards the v-direction anticlockwise is seen.
  template <typename Place, typename Normal>
  void add(std::uint32_t columns, std::uint32_t rows, Place place, Normal normal) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t j = 0; j <= rows; ++j)
      for (std::uint32_t i = 0; i <= columns; ++i) {
        const auto u = static_cast<double>(i) / columns, v = static_cast<double>(j) / rows;
        mesh.positions.push_back(Vec3(place(u, v)));
        mesh.normals.push_back(Vec3(normal(u, v)));
      }
    for (std::uint32_t j = 0; j < rows; ++j)
      for (std::uint32_t i = 0; i < columns; ++i) {
        const auto at = first + j * (columns + 1) + i, above = at + columns + 1;
        add_triangle({at, at + 1, above + 1});
        add_triangle({at, above + 1, above});
      }
  }

  LuminaireMesh mesh;

 private:
  // At poles two corners are one place.
  void add_triangle(const std::array<std::uint32_t, 3>& t) {
    const auto& p = mesh.positions;
    if (p[t[0]] != p[t[1]] && p[t[1]] != p[t[2]] && p[t[2]] != p[t[0]]) mesh.triangles.push_back(t);
  }
};

// Axes of a face: u, v and the normal u x v, one to the right of the other.
struct Axes {
  Vec3d u, v;
  Vec3d normal() const { return glm::cross(u, v); }
};

Axes axes_of(int axis) {
  Axes axes{Vec3d(0.0), Vec3d(0.0)};
  axes.u[(axis + 1) % 3] = 1.0;
  axes.v[(axis + 2) % 3] = 1.0;
  return axes;
}

void add_rectangle(MeshMaker& maker, const Axes& axes, const Vec3d& centre, const Vec3d& size,
                   std::uint32_t steps) {
  maker.add(
      steps, steps,
      [&](double u, double v) { return centre + size * ((u - 0.5) * axes.u + (v - 0.5) * axes.v); },
      [&](double, double) { return axes.normal(); });
}

// Rings about the centre, so that a radius is cut as an edge is.
void add_disk(MeshMaker& maker, const Axes& axes, const Vec3d& centre, const Vec3d& size,
              std::uint32_t steps) {
  maker.add(
      around, std::max(1u, steps / 2),
      [&](double u, double v) {
        const auto turn = sin_cos(2.0 * exact_pi * (u < 1.0 ? u : 0.0));
        return centre + 0.5 * (1.0 - v) * size * (turn.cosine * axes.u + turn.sine * axes.v);
      },
      [&](double, double) { return axes.normal(); });
}

void add_box(MeshMaker& maker, const Vec3d& size, std::uint32_t steps) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto axes = axes_of(axis);
    const auto shift = 0.5 * size * axes.normal();
    add_rectangle(maker, axes, shift, size, steps);
    add_rectangle(maker, {axes.v, axes.u}, -shift, size, steps);
  }
}

void add_cylinder(MeshMaker& maker, int axis, const Vec3d& size, std::uint32_t steps) {
  const auto axes = axes_of(axis);
  const auto up = axes.normal();
  const auto outwards = [&](double u) {
    const auto turn = sin_cos(2.0 * exact_pi * (u < 1.0 ? u : 0.0));
    return turn.cosine * axes.u + turn.sine * axes.v;
  };
  maker.add(
      around, steps, [&](double u, double v) { return size * (0.5 * outwards(u) + (v - 0.5) * up); },
      [&](double u, double) { return glm::normalize(outwards(u) / glm::max(size, Vec3d(1e-9))); });
  add_disk(maker, axes, 0.5 * size * up, size, steps);
  add_disk(maker, {axes.v, axes.u}, -0.5 * size * up, size, steps);
}

void add_ellipsoid(MeshMaker& maker, const Vec3d& size) {
  const auto on_sphere = [](double u, double v) {
    const auto turn = sin_cos(2.0 * exact_pi * (u < 1.0 ? u : 0.0));
    const auto rise = sin_cos(exact_pi * (v - 0.5));
    const auto radius = v > 0.0 && v < 1.0 ? rise.cosine : 0.0;
    return Vec3d(radius * turn.cosine, radius * turn.sine, rise.sine);
  };
  maker.add(
      around, around / 2, [&](double u, double v) { return 0.5 * size * on_sphere(u, v); },
      [&](double u, double v) { return glm::normalize(on_sphere(u, v) / glm::max(size, Vec3d(1e-9))); });
}

// Seen from the aim, -Z.
constexpr int z_axis = 2;
Axes downwards() {
  const auto axes = axes_of(z_axis);
  return {axes.v, axes.u};
}

}  // namespace

LuminousOpening shown_opening(const LuminousOpening& opening) {
  if (opening.shape != OpeningShape::point) return opening;
  return {OpeningShape::ellipsoid, Vec3d(point_diameter)};
}

LuminaireMesh opening_mesh(const LuminousOpening& opening, int steps) {
  MeshMaker maker;
  const auto& size = opening.size;
  const auto parts = static_cast<std::uint32_t>(std::max(1, steps));
  switch (opening.shape) {
    case OpeningShape::point:
      break;
    case OpeningShape::rectangle:
      add_rectangle(maker, downwards(), Vec3d(0.0), size, parts);
      break;
    case OpeningShape::ellipse:
      add_disk(maker, downwards(), Vec3d(0.0), size, parts);
      break;
    case OpeningShape::vertical_disk:
      add_disk(maker, axes_of(size.x < size.y ? 0 : 1), Vec3d(0.0), size, parts);
      break;
    case OpeningShape::box:
      add_box(maker, size, parts);
      break;
    case OpeningShape::vertical_cylinder:
      add_cylinder(maker, z_axis, size, parts);
      break;
    case OpeningShape::cylinder_along_x:
      add_cylinder(maker, 0, size, parts);
      break;
    case OpeningShape::cylinder_along_y:
      add_cylinder(maker, 1, size, parts);
      break;
    case OpeningShape::ellipsoid:
      add_ellipsoid(maker, size);
      break;
  }
  return std::move(maker.mesh);
}

Vec3d PhotometricSolid::direction(std::size_t row, std::size_t column) {
  const auto vertical = sin_cos(exact_pi * static_cast<double>(row) / (rows - 1));
  const auto horizontal = sin_cos(2.0 * exact_pi * static_cast<double>(column % columns) / columns);
  const auto across = row == 0 || row == rows - 1 ? 0.0 : vertical.sine;
  return {across * horizontal.cosine, across * horizontal.sine, -vertical.cosine};
}

PhotometricSolid photometric_solid(const IntensityDistribution& intensity) {
  PhotometricSolid solid;
  const auto largest = intensity.maximum();
  for (std::size_t row = 0; row < PhotometricSolid::rows; ++row)
    for (std::size_t column = 0; column < PhotometricSolid::columns; ++column) {
      const auto candela = intensity.at(PhotometricSolid::direction(row, column));
      solid.radius.push_back(largest > 0.0 ? static_cast<float>(candela / largest) : 0.0f);
    }
  return solid;
}

}  // namespace luxel
