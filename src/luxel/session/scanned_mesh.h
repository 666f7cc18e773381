// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/scene/boundary_loops.h"
#include "luxel/scene/components.h"
#include "luxel/scene/scene.h"
#include "luxel/session/diagnostic.h"

namespace luxel {

// A scene's triangles that carry light, and their connections.
struct ScannedMesh {
  const Scene* scene = nullptr;  // must outlive this
  std::vector<Vec3> places;      // m; no two are the same
  CleanTriangles clean;
  Edges edges;
  Components components;
  TJunctions junctions;
  std::vector<BoundaryLoop> loops;
  Bounds box;  // of the places, m

  // Corners of a clean triangle.
  std::array<Vec3, 3> points(std::size_t triangle) const;
  double area(std::size_t triangle) const;  // m²
  std::uint32_t in_scene(std::size_t triangle) const { return clean.kept[triangle].triangle; }
  std::array<Vec3, 2> ends(std::size_t edge) const {
    return {places[edges.ends[edge][0]], places[edges.ends[edge][1]]};
  }
};

// Cost: n log n, about 3 s per million triangles. After the monitor's stop the result is incomplete and
// is_whole is false.
ScannedMesh scan_mesh(const Scene& scene, const Context& context, bool& is_whole);

// A place that may be reported; larger `weight` first.
struct Candidate {
  std::uint32_t triangle = 0;  // index in the scene
  Vec3 at{0.0f};               // m
  double weight = 0.0;
  std::uint32_t item = 0;  // an index that the diagnostic defines
};

// The centroid of a triangle of the scene, m.
Vec3 centroid(const Scene& scene, std::uint32_t triangle);
double area(const Scene& scene, std::uint32_t triangle);  // m²

// Adds the candidates of largest weight, the earlier of equal ones, with their names in the file and a detail
// each; counts all.
void tell_places(const Scene& scene, const std::vector<Candidate>& candidates, std::size_t most,
                 const std::function<std::string(const Candidate&)>& detail, Diagnostic& diagnostic);

}  // namespace luxel
