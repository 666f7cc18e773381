// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/shadow_receivers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "luxel/lamps/shadow_projection.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/patch/flat_triangle.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr std::size_t max_rays = 64;        // per edge that look for receivers, and as many shadow rays
constexpr double rays_per_edge = 12.0;      // per `detail` of the edge's length
constexpr std::size_t max_receivers = 256;  // per edge
constexpr double narrowest = 0.005;         // height of a receiver, in `detail`
constexpr double longest_crossing = 3.0;    // of a narrower one that is crossed, in its height
constexpr double move_reach = 2.0;          // distance, in `reach`, from which lines move to edges
constexpr double flat_cosine = 0.999;       // of the normals of triangles that continue each other

}  // namespace

ShadowReceivers::ShadowReceivers(const PatchSet& triangles, const VertexTriangles& neighbours,
                                 const Tracer& tracer, const Lengths& lengths)
    : triangles_(triangles), neighbours_(neighbours), tracer_(tracer), lengths_(lengths) {}

void ShadowReceivers::add_shadows(std::uint32_t light, const OutlineEdge& edge,
                                  std::vector<EdgeShadow>& shadows) const {
  auto receivers = hit_beyond(triangles_.point_lights[light].light, edge);
  for (std::size_t next = 0; next < receivers.size() && next < max_receivers; ++next) {
    const auto on = receivers[next];
    if (!add_shadow(on, light, edge, shadows)) continue;
    const auto& c = triangles_.corners[on];
    for (std::size_t k = 0; k < 3; ++k)
      neighbours_.any_at_edge(c[k], c[(k + 1) % 3], on, [&](std::uint32_t other, std::uint32_t) {
        if (std::find(receivers.begin(), receivers.end(), other) == receivers.end())
          receivers.push_back(other);
        return false;
      });
  }
}

// The surfaces that light reaches beside the edge, in order along it.
std::vector<std::uint32_t> ShadowReceivers::hit_beyond(const PointLight& light,
                                                       const OutlineEdge& edge) const {
  const auto length = glm::distance(edge.a, edge.b);
  const auto wanted = std::ceil(rays_per_edge * length / lengths_.detail);
  const auto rays = static_cast<std::size_t>(std::clamp(wanted, 3.0, static_cast<double>(max_rays)));
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < rays; ++i) {
    const auto along = (static_cast<double>(i) + 0.5) / static_cast<double>(rays);
    const auto start = edge.a + along * (edge.b - edge.a) + lengths_.reach * edge.outward;
    const auto sight = sight_of(light, start, Vec3d(0.0));
    const auto distance = static_cast<float>(static_cast<double>(sight.distance) * (1.0 - 1e-5));
    if (tracer_.occluded({Vec3(start), Vec3(sight.direction)}, distance)) continue;
    const auto hit = tracer_.nearest({Vec3(start), Vec3(-sight.direction)});
    if (hit && std::find(found.begin(), found.end(), hit.patch) == found.end()) found.push_back(hit.patch);
  }
  return found;
}

// Returns whether the edge has a shadow here.
bool ShadowReceivers::add_shadow(std::uint32_t triangle, std::uint32_t light, const OutlineEdge& edge,
                                 std::vector<EdgeShadow>& shadows) const {
  const auto points = triangles_.points(triangle);
  const FlatTriangle plane(points);
  const ShadowProjection projection(triangles_.point_lights[light].light, plane);
  if (!projection.reaches()) return false;
  if (projection.from_behind() && !triangles_.material_of(triangle).two_sided) return false;
  const auto slack = slack_roundings * coordinate_rounding(points);
  const auto whole = projection.shadow(edge, slack);
  if (!whole) return false;
  const auto& [p, q] = *whole;
  if (glm::distance(p, q) < shortest_shadow * lengths_.detail) return false;
  const auto interval = interval_on(plane, p, q, slack);
  if (!interval) return false;
  const auto length = (interval->end - interval->begin) * glm::distance(p, q);
  const auto height = plane.smallest_height();
  const bool is_narrow = height < narrowest * lengths_.detail;
  if (is_narrow && length > longest_crossing * height) return false;
  EdgeShadow shadow;
  shadow.triangle = triangle;
  shadow.light = light;
  shadow.ends = {p + interval->begin * (q - p), p + interval->end * (q - p)};
  shadow.outward = edge.outward;
  shadow.lit_side = projection.lit_side();
  shadow.penumbra = edge.penumbra;
  if (interval->begin == 0.0 && projection.is_between(edge.a, slack)) shadow.corner[0] = edge.corners[0];
  if (interval->end == 1.0 && projection.is_between(edge.b, slack)) shadow.corner[1] = edge.corners[1];
  shadow.is_link = is_narrow || length < shortest_tested * lengths_.reach;
  if (!shadow.is_link && !move_to_edge(triangle, shadow)) return true;
  if (is_too_soft(shadow, edge)) return true;
  shadow.weight = glm::distance(shadow.ends[0], shadow.ends[1]) * irradiance_at(light, shadow);
  if (shadow.weight > 0.0) shadows.push_back(shadow);
  return true;
}

// Patches follow a wide penumbra without lines.
bool ShadowReceivers::is_too_soft(const EdgeShadow& shadow, const OutlineEdge& edge) const {
  const auto middle = 0.5 * (shadow.ends[0] + shadow.ends[1]);
  const auto along = edge.b - edge.a;
  const auto t = std::clamp(glm::dot(middle - edge.a, along) / glm::dot(along, along), 0.0, 1.0);
  return edge.spread * glm::distance(middle, edge.a + t * along) > lengths_.widest_penumbra;
}

double ShadowReceivers::irradiance_at(std::uint32_t light, const EdgeShadow& shadow) const {
  const auto& lamp = triangles_.point_lights[light];
  const auto power = std::accumulate(lamp.intensity.begin(), lamp.intensity.end(), 0.0);
  return power * sight_of(lamp.light, 0.5 * (shadow.ends[0] + shadow.ends[1]), shadow.lit_side).irradiance;
}

// A line close to an edge would leave a sliver beside it: it moves to the edge, if the surface goes on there.
// Returns false where it ends or bends: light is discontinuous there anyway.
bool ShadowReceivers::move_to_edge(std::uint32_t triangle, EdgeShadow& shadow) const {
  const FlatTriangle plane(triangles_.points(triangle));
  const auto found = interval_on_edge(plane, shadow.ends[0], shadow.ends[1], move_reach * lengths_.reach);
  if (!found) return true;
  if (!goes_on(triangle, found->edge)) return false;
  const auto& from = plane.corner[found->edge];
  const auto along = plane.corner[(found->edge + 1) % 3] - from;
  shadow.ends = {from + found->interval.begin * along, from + found->interval.end * along};
  shadow.on_edge = true;
  return found->length > move_reach * lengths_.reach;
}

bool ShadowReceivers::goes_on(std::uint32_t triangle, std::size_t k) const {
  const auto& c = triangles_.corners[triangle];
  const FlatTriangle plane(triangles_.points(triangle));
  return neighbours_.any_at_edge(c[k], c[(k + 1) % 3], triangle,
                                 [&](std::uint32_t other, std::uint32_t apex) {
                                   const FlatTriangle beside(triangles_.points(other));
                                   return std::fabs(glm::dot(beside.normal, plane.normal)) > flat_cosine &&
                                          plane.inside(k, Vec3d(triangles_.vertices[apex])) < 0.0;
                                 });
}

}  // namespace luxel
