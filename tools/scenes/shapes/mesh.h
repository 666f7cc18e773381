// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "luxel/core/vector.h"

#include "scenes/shapes/palette.h"

namespace luxel::scenes {

struct Triangle {
  std::array<std::uint32_t, 3> corners;  // counter-clockwise seen from the front
  Paint paint = Paint::ceiling_white;
};

// Painted triangles over shared points, in metres, Y up.
struct Mesh {
  std::vector<Vec3d> points;
  std::vector<Triangle> triangles;

  std::uint32_t add_point(const Vec3d& p);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  // Split along the shorter diagonal, which keeps bent surfaces plump.
  void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
};

// A named thing in the room. A closed one bounds a volume: each of its edges has two sides.
struct Object {
  std::string name;
  Mesh mesh;
  bool closed = true;
};

Vec3d centroid(const Mesh& mesh, const Triangle& triangle);
Vec3d area_vector(const Mesh& mesh, const Triangle& triangle);  // length: area in m²; direction: the front

Mesh joined(std::initializer_list<Mesh> parts);
void append(Mesh& mesh, const Mesh& part);

// Points at the same place become one.
Mesh welded(const Mesh& mesh);
// Rounded to a micrometre, as the file holds it, and welded.
Mesh rounded(const Mesh& mesh);

Mesh painted(Mesh mesh, Paint paint);
using Where = std::function<bool(const Vec3d& centroid, const Vec3d& normal)>;
Mesh painted(Mesh mesh, Paint paint, const Where& where);

using Deformation = std::function<Vec3d(const Vec3d&)>;
Mesh deformed(Mesh mesh, const Deformation& deformation);
Mesh moved(Mesh mesh, const Vec3d& by);
// Turned about an axis through the origin, counter-clockwise seen against the axis.
Mesh turned_x(Mesh mesh, double degrees);
Mesh turned_y(Mesh mesh, double degrees);
Mesh turned_z(Mesh mesh, double degrees);
// Turned about the vertical, then moved: how a piece of furniture comes to its place.
Mesh placed(Mesh mesh, const Vec3d& at, double turn_degrees = 0.0);

}  // namespace luxel::scenes
