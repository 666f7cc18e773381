// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_bodies.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>

#include "luxel/core/bounds.h"
#include "luxel/core/disjoint_sets.h"

namespace luxel {
namespace {

constexpr double largest = 0.25;  // diagonal of a body over that of the scene
constexpr double dimmest = 0.02;  // flux of a body over that of the brightest small one

struct Body {
  std::vector<std::uint32_t> triangles;
  std::vector<double> flux;  // [band], W
  double whole_flux = 0.0;
};

// Emissive triangles that share vertices, in the order of their first triangles.
std::vector<Body> bodies_of(const PatchSet& triangles) {
  DisjointSets sets(triangles.vertices.size());
  const auto is_lamp = [&](std::size_t t) { return triangles.material_of(t).is_lamp(); };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& c = triangles.corners[t];
    if (!is_lamp(t)) continue;
    sets.join(c[0], c[1]);
    sets.join(c[1], c[2]);
  }
  std::map<std::uint32_t, std::size_t> number;  // of the body, by its lowest vertex
  std::vector<Body> bodies;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!is_lamp(t)) continue;
    const auto [entry, is_new] = number.try_emplace(sets.of(triangles.corners[t][0]), bodies.size());
    if (is_new) bodies.push_back({{}, std::vector<double>(triangles.band_count(), 0.0)});
    auto& body = bodies[entry->second];
    body.triangles.push_back(t);
    for (std::size_t b = 0; b < body.flux.size(); ++b) {
      const auto flux =
          static_cast<double>(triangles.area[t]) * static_cast<double>(triangles.emittance(t, b));
      body.flux[b] += flux;
      body.whole_flux += flux;
    }
  }
  return bodies;
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
  auto bodies = bodies_of(triangles);
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
