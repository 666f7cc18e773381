// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

// How triangles of glass make up panes.
enum class GlassBody : std::uint8_t {
  sheet,      // a surface: each crossing counts
  thin_body,  // a body with two large parallel faces, closed or without some of its narrow sides
  body        // any other closed body
};

// A triangle of a material that is not opaque.
struct GlassTriangle {
  std::uint32_t triangle = 0;  // in the scene
  std::uint32_t object = 0;    // of connected triangles of one material: the lowest position in the list
  GlassBody body = GlassBody::sheet;
  Vec3d axis{0.0};  // unit: angles of incidence are measured from it
};

// Finds the scene's glass. Triangles of one material that share corners (of the same place) are one object.
// It is a body if each of its edges has an even number of triangles, or if it has two parallel faces of
// nearly the same area, close together. Triangles without area are left out, and those that lie exactly on
// another one of the material. Angles of incidence on all faces of a thin body, the narrow ones too, are
// those on its large faces: light that enters at a narrow side has gone through as much glass as light that
// enters beside it. n log n.
std::vector<GlassTriangle> find_glass(const Scene& scene);

// The panes that absorb light: the glass of materials whose transmittance is below 1. A ray crosses two faces
// of a body, so each counts half.
std::vector<Pane> make_panes(const Scene& scene);
// The scene's triangle of each of them.
std::vector<std::uint32_t> pane_triangles(const Scene& scene);

}  // namespace luxel
