// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/lamps/outline_edges.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/vertex_triangles.h"
#include "luxel/scene/point_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Shadows shorter than this, in `reach`, are not tested.
inline constexpr double shortest_tested = 6.0;
// Shorter pieces of lines, in `reach`, are left out.
inline constexpr double shortest_line = 4.0;
// Shadows of whole edges that are shorter than this, in `detail`, are left out.
inline constexpr double shortest_shadow = 0.05;

// The shadow of an edge on one triangle, if nothing else stood between.
struct EdgeShadow {
  std::uint32_t triangle = 0;     // receiver: an index into PatchSet::corners
  std::uint32_t light = 0;        // an index into PatchSet::point_lights
  std::array<Vec3d, 2> ends{};    // m, in the plane of the triangle, on it or along its edge
  Vec3d outward{0.0};             // OutlineEdge::outward: light is on this side of the line
  Vec3d lit_side{0.0};            // unit normal of the triangle, where the light is
  bool on_edge = false;           // it was moved to an edge of the triangle that is nearer than `reach`
  std::uint32_t penumbra = none;  // OutlineEdge::penumbra
  // Vertices of which the ends are the shadows; none: the line ends before.
  std::array<std::uint32_t, 2> corner{none, none};
  double weight = 0.0;     // length (m) times irradiance (W/m², of the bands together)
  std::uint32_t edge = 0;  // a number of the edge that casts it
  // It is too short to be tested, or crosses a triangle that is narrow: a part if it joins two others.
  bool is_link = false;
};

// Finds the triangles that may receive the shadow of an edge, and projects the edge onto them.
class ShadowReceivers {
 public:
  struct Lengths {
    double detail;           // m, scale of shadow features: distance of the rays along a shadow
    double reach;            // m, small: at this distance beside an edge there is light
    double widest_penumbra;  // m: wider ones have no lines
  };

  // Keeps references. Each triangle of `triangles` is one of the tracer's.
  ShadowReceivers(const PatchSet& triangles, const VertexTriangles& neighbours, const Tracer& tracer,
                  const Lengths& lengths);

  // Appends the shadows of an edge. Rays start beside the edge, where it is lit, and go on from the light to
  // the first surface; from there the shadow is followed to the neighbours of each triangle. Triangles of
  // less height than a two-hundredth of `detail` are no receivers, unless they are crossed. Thread-safe.
  // Cost: at most 128 rays and 256 triangles.
  void add_shadows(std::uint32_t light, const OutlineEdge& edge, std::vector<EdgeShadow>& shadows) const;

 private:
  std::vector<std::uint32_t> hit_beyond(const PointLight& light, const OutlineEdge& edge) const;
  bool add_shadow(std::uint32_t triangle, std::uint32_t light, const OutlineEdge& edge,
                  std::vector<EdgeShadow>& shadows) const;
  bool move_to_edge(std::uint32_t triangle, EdgeShadow& shadow) const;
  bool is_too_soft(const EdgeShadow& shadow, const OutlineEdge& edge) const;
  bool goes_on(std::uint32_t triangle, std::size_t k) const;
  double irradiance_at(std::uint32_t light, const EdgeShadow& shadow) const;

  const PatchSet& triangles_;
  const VertexTriangles& neighbours_;
  const Tracer& tracer_;
  Lengths lengths_;
};

}  // namespace luxel
