// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/opening_faces.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "luxel/core/trig.h"
#include "luxel/photometry/opening.h"

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;
constexpr double faintest = 1e-4;  // of the whole flux: a face with less is not shown

// Radiance times solid angle, of all directions; relative to the largest intensity.
struct Direction {
  Vec3d to;
  double radiance = 0.0;  // sr/m²
};

// In the middles of the cells of a grid of angles, none of which lies on both sides of the horizontal.
std::vector<Direction> emitted(const IntensityDistribution& intensity, const LuminousOpening& opening) {
  constexpr std::size_t rows = 72, columns = 48;
  constexpr auto row_step = exact_pi / rows, column_step = 2.0 * exact_pi / columns;
  const auto angle_at_horizon = 2.0 * column_step * sin_cos(0.5 * row_step).sine;  // sr, of a cell
  std::vector<Direction> all;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto vertical = sin_cos((static_cast<double>(row) + 0.5) * row_step);
    for (std::size_t column = 0; column < columns; ++column) {
      const auto horizontal = sin_cos((static_cast<double>(column) + 0.5) * column_step);
      const Vec3d to(vertical.sine * horizontal.cosine, vertical.sine * horizontal.sine, -vertical.cosine);
      const auto relative = intensity.at(to) / intensity.maximum();
      if (relative > 0.0)
        all.push_back({to, angle_at_horizon * vertical.sine * relative / projected_area(opening, to)});
    }
  }
  return all;
}

// The triangles whose three normals sum up to a z in this range, -3 to 3.
LuminaireMesh part_of(const LuminaireMesh& whole, float from, float to) {
  LuminaireMesh part;
  std::unordered_map<std::uint32_t, std::uint32_t> number_of;
  const auto vertex = [&](std::uint32_t of_whole) {
    const auto next = static_cast<std::uint32_t>(part.positions.size());
    const auto [found, is_new] = number_of.try_emplace(of_whole, next);
    if (is_new) {
      part.positions.push_back(whole.positions[of_whole]);
      part.normals.push_back(whole.normals[of_whole]);
    }
    return found->second;
  };
  for (const auto& [a, b, c] : whole.triangles) {
    const auto z = whole.normals[a].z + whole.normals[b].z + whole.normals[c].z;
    if (z >= from && z < to) part.triangles.push_back({vertex(a), vertex(b), vertex(c)});
  }
  return part;
}

LuminaireMesh turned_over(LuminaireMesh sheet, double apart) {
  for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
    sheet.positions[v] -= static_cast<float>(apart) * sheet.normals[v];
    sheet.normals[v] = -sheet.normals[v];
  }
  for (auto& triangle : sheet.triangles) std::swap(triangle[1], triangle[2]);
  return sheet;
}

std::vector<LuminaireMesh> parts_of(const LuminousOpening& opening, double apart) {
  const auto whole = opening_mesh(opening);
  if (is_flat(opening)) return {whole, turned_over(whole, apart)};
  constexpr auto beyond = 4.0f, steep = 3.0f * 0.7f;
  return {part_of(whole, -beyond, -steep), part_of(whole, -steep, steep), part_of(whole, steep, beyond)};
}

struct Emission {
  double area = 0.0;  // m²
  double flux = 0.0;  // sr, at the largest intensity 1
};

Emission emission_of(const LuminaireMesh& mesh, const std::vector<Direction>& directions) {
  Emission sum;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d at(mesh.positions[a]);
    const auto across =
        0.5 * glm::cross(Vec3d(mesh.positions[b]) - at, Vec3d(mesh.positions[c]) - at);  // normal times area
    sum.area += glm::length(across);
    for (const auto& [to, radiance] : directions) sum.flux += std::max(0.0, glm::dot(across, to)) * radiance;
  }
  return sum;
}

}  // namespace

std::vector<OpeningFace> opening_faces(const Photometry& photometry, double apart) {
  const auto& intensity = photometry.intensity;
  if (!(intensity.maximum() > 0.0)) return {};
  const auto opening = shown_opening(photometry.opening);
  const auto directions = emitted(intensity, opening);
  auto parts = parts_of(opening, apart);
  std::vector<Emission> emissions;
  double flux = 0.0;
  for (const auto& part : parts) flux += emissions.emplace_back(emission_of(part, directions)).flux;

  std::vector<OpeningFace> faces;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto [area, part_flux] = emissions[i];
    if (!(part_flux > faintest * flux)) continue;
    // The grid of directions is coarse for narrow beams: the faces have the whole flux together.
    const auto angle = part_flux / flux * intensity.linear_flux() / intensity.maximum();  // sr
    faces.push_back({std::move(parts[i]), angle / (exact_pi * area)});
  }
  return faces;
}

}  // namespace luxel
