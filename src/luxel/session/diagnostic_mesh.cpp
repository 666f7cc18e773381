// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/diagnostic_mesh.h"

#include <algorithm>

#include "luxel/core/none.h"
#include "luxel/core/warp.h"

namespace luxel {
namespace {

// Adds a three-sided rod around an edge, no thicker than a third of its length or than `radius`.
void add_rod(const std::array<Vec3, 2>& edge, float radius, FaultPart& part) {
  const auto way = edge[1] - edge[0];
  const auto length = glm::length(way);
  if (!(length > 0.0f)) return;
  const auto r = std::max(std::min(radius, length / 3.0f), 0.1f * radius);
  const Frame frame(way / length);
  const auto first = static_cast<std::uint32_t>(part.positions.size());
  for (const auto& end : edge)
    for (const auto& [x, y] : {std::pair{1.0f, 0.0f}, {-0.5f, 0.866f}, {-0.5f, -0.866f}})
      part.positions.push_back(end + r * (x * frame.s + y * frame.t));
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto a = first + k;
    const auto b = first + (k + 1) % 3;
    part.triangles.push_back({a, b, b + 3});
    part.triangles.push_back({a, b + 3, a + 3});
  }
}

void add_triangle(const Scene& scene, std::uint32_t triangle, FaultPart& part) {
  const auto first = static_cast<std::uint32_t>(part.positions.size());
  for (const auto v : scene.triangles[triangle]) part.positions.push_back(scene.positions[v]);
  part.triangles.push_back({first, first + 1, first + 2});
}

// Returns whether the diagnostic is about faces, not about the edges between them.
bool concerns_faces(const Diagnostic& diagnostic) { return diagnostic.edges.empty(); }

}  // namespace

std::vector<FaultPart> fault_parts(const Scene& scene, const CheckReport& report) {
  constexpr auto well = none;
  std::vector<std::uint32_t> diagnostic_of(scene.triangles.size(), well);
  for (std::uint32_t f = 0; f < report.diagnostics.size(); ++f)
    if (concerns_faces(report.diagnostics[f]))
      for (const auto t : report.diagnostics[f].triangles) diagnostic_of[t] = std::min(diagnostic_of[t], f);

  std::vector<FaultPart> parts(report.diagnostics.size() + 1);
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
    add_triangle(scene, t, parts[diagnostic_of[t] == well ? 0 : diagnostic_of[t] + 1]);
  const auto radius = glm::length(report.box.size()) / 1200.0f;
  for (std::size_t f = 0; f < report.diagnostics.size(); ++f) {
    parts[f + 1].kind = report.diagnostics[f].kind;
    for (const auto& edge : report.diagnostics[f].edges) add_rod(edge, radius, parts[f + 1]);
  }
  return parts;
}

}  // namespace luxel
