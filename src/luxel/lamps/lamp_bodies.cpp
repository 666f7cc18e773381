// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_bodies.h"

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>

#include "luxel/core/bounds.h"
#include "luxel/patch/lamp_surfaces.h"

namespace luxel {
namespace {

constexpr double largest = 0.25;  // diagonal of a body over that of the scene
constexpr double dimmest = 0.02;  // flux of a body over that of the brightest small one

struct Body {
  std::vector<std::uint32_t> triangles;
  std::vector<double> flux;  // [band], W
  double whole_flux = 0.0;
};

Body body_of(const PatchSet& triangles, LampSurface surface) {
  Body body{std::move(surface.patches), std::vector<double>(triangles.band_count(), 0.0)};
  for (const auto t : body.triangles)
    for (std::size_t b = 0; b < body.flux.size(); ++b) {
      const auto flux =
          static_cast<double>(triangles.area[t]) * static_cast<double>(triangles.emittance(t, b));
      body.flux[b] += flux;
      body.whole_flux += flux;
    }
  return body;
}

LampBody as_lamp(const PatchSet& triangles, const Body& body) {
  LampBody lamp;
  std::vector<std::uint32_t> vertices;
  Vec3d centre(0.0);
  double area = 0.0;
  for (const auto t : body.triangles) {
    const auto a = static_cast<double>(triangles.area[t]);
    centre += a * Vec3d(triangles.centroid(t));
    area += a;
    vertices.insert(vertices.end(), triangles.corners[t].begin(), triangles.corners[t].end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  lamp.centre.light.position = Vec3(centre / area);
  for (const auto v : vertices) {
    lamp.vertices.emplace_back(triangles.vertices[v]);
    lamp.radius = std::max(lamp.radius, glm::distance(lamp.vertices.back(), centre / area));
  }
  for (const auto flux : body.flux)  // into a half space: between a disc's axis and a sphere
    lamp.centre.intensity.push_back(static_cast<float>(flux / (2.0 * std::numbers::pi)));
  return lamp;
}

double diagonal(const PatchSet& triangles, const std::vector<std::uint32_t>& some) {
  Bounds box;
  for (const auto t : some)
    for (const auto& p : triangles.points(t)) box.add(p);
  return static_cast<double>(glm::length(box.size()));
}

}  // namespace

std::vector<LampBody> find_lamp_bodies(const PatchSet& triangles, std::size_t most) {
  std::vector<Body> bodies;
  for (auto& surface : find_lamp_surfaces(triangles))
    bodies.push_back(body_of(triangles, std::move(surface)));
  if (bodies.empty()) return {};
  std::vector<std::uint32_t> all(triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  const auto limit = largest * diagonal(triangles, all);
  std::stable_sort(bodies.begin(), bodies.end(),
                   [](const Body& a, const Body& b) { return a.whole_flux > b.whole_flux; });
  std::vector<LampBody> lamps;
  double least = 0.0;  // W
  for (const auto& body : bodies) {
    if (lamps.size() == most || !(body.whole_flux > least)) break;
    if (!(diagonal(triangles, body.triangles) < limit)) continue;
    if (lamps.empty()) least = dimmest * body.whole_flux;
    lamps.push_back(as_lamp(triangles, body));
  }
  return lamps;
}

}  // namespace luxel
