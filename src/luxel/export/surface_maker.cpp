// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/surface_maker.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "luxel/core/barycentric.h"
#include "luxel/core/none.h"

namespace luxel {
namespace {

constexpr double on_edge = 1e-5;  // points with smaller weights are on an edge

DrawnCorner own_corner(std::uint32_t vertex) {
  return {.place = {{vertex, vertex, vertex}, {1.0, 0.0, 0.0}}};
}

// Points on an edge are computed from its two ends alone, in the order of their positions, so that all
// surfaces at the edge have bitwise the same points.
RoundTripVertex on_the_edge(const std::array<std::uint32_t, 2>& of, std::array<Vec3, 2> ends,
                            const Vec3& point) {
  auto ordered = of;
  const auto key = [](const Vec3& p) { return std::tuple(p.x, p.y, p.z); };
  if (key(ends[1]) < key(ends[0])) {
    std::swap(ends[0], ends[1]);
    std::swap(ordered[0], ordered[1]);
  }
  const auto along = Vec3d(ends[1]) - Vec3d(ends[0]);
  const auto t =
      std::clamp(glm::dot(Vec3d(point) - Vec3d(ends[0]), along) / glm::dot(along, along), 0.0, 1.0);
  return {{ordered[0], ordered[1], ordered[1]}, {1.0 - t, t, 0.0}};
}

std::array<Vec3, 3> corners_of(const RoundTripScene& round_trip, std::uint32_t triangle) {
  const auto& corners = round_trip.scene.triangles[triangle];
  return {round_trip.scene.positions[corners[0]], round_trip.scene.positions[corners[1]],
          round_trip.scene.positions[corners[2]]};
}

// Returns the edge on which a point with these weights lies; 3: none.
std::size_t edge_at(const Vec3d& weights) {
  for (std::size_t c = 0; c < 3; ++c)
    if (std::abs(weights[static_cast<int>(c)]) < on_edge) return (c + 1) % 3;
  return 3;
}

}  // namespace

std::optional<EdgePlace> place_on_edge(const RoundTripScene& round_trip, std::uint32_t triangle,
                                       std::uint32_t point) {
  const auto corners = corners_of(round_trip, triangle);
  const auto& at = round_trip.patches.vertices[point];
  if (std::find(corners.begin(), corners.end(), at) != corners.end()) return std::nullopt;
  const auto weights = barycentric(corners, at);
  const auto edge = edge_at(weights);
  if (edge == 3) return std::nullopt;
  return EdgePlace{edge, weights[static_cast<int>((edge + 1) % 3)]};
}

DrawnCorner corner_of(const RoundTripScene& round_trip, const RoundTripPart& part, std::size_t i,
                      std::uint32_t point) {
  const auto& of_file = part.corners[i];
  const auto corners = corners_of(round_trip, part.triangles[i]);
  const auto& at = round_trip.patches.vertices[point];
  for (std::size_t c = 0; c < 3; ++c)
    if (corners[c] == at) return own_corner(of_file[c]);
  const auto weights = barycentric(corners, at);
  DrawnCorner corner{.place = {of_file, weights}, .point = point};
  if (const auto a = edge_at(weights), b = (a + 1) % 3; a < 3)
    corner.place = on_the_edge({of_file[a], of_file[b]}, {corners[a], corners[b]}, at);
  return corner;
}

std::array<DrawnCorner, 3> corners_of_patch(const RoundTripScene& round_trip, const RoundTripPart& part,
                                            std::size_t i, std::uint32_t patch) {
  const auto& points = round_trip.patches.corners[patch];
  return {corner_of(round_trip, part, i, points[0]), corner_of(round_trip, part, i, points[1]),
          corner_of(round_trip, part, i, points[2])};
}

std::array<DrawnCorner, 3> own_corners(const RoundTripPart& part, std::size_t i) {
  const auto& of_file = part.corners[i];
  return {own_corner(of_file[0]), own_corner(of_file[1]), own_corner(of_file[2])};
}

SurfaceMaker::SurfaceMaker(const RoundTripPart& part, bool back, std::uint32_t page) : part_(part) {
  surface_.back = back;
  surface_.page = page;
  surface_.own.resize(part.vertices);
  std::iota(surface_.own.begin(), surface_.own.end(), 0u);
  surface_.light.resize(part.vertices, none);
  surface_.uv.resize(part.vertices, Vec2(0.0f));
}

void SurfaceMaker::add(const std::array<DrawnCorner, 3>& corners) {
  std::array<std::uint32_t, 3> triangle{};
  for (std::size_t i = 0; i < 3; ++i) triangle[i] = vertex(corners[i]);
  if (surface_.back != part_.mirrored) std::swap(triangle[1], triangle[2]);
  surface_.triangles.push_back(triangle);
}

RoundTripSurface SurfaceMaker::finish() {
  surface_.as_it_was = !surface_.back && surface_.added.empty() && part_.as_read &&
                       surface_.triangles.size() == part_.corners.size();
  // Arrays that are rewritten, or of which less than half is used, drop unused vertices.
  const auto used = used_of_own();
  if (surface_.back || !surface_.added.empty() || 2 * used.size() < surface_.own.size()) keep_only(used);
  return std::move(surface_);
}

std::vector<std::uint32_t> SurfaceMaker::used_of_own() const {
  std::vector<bool> is_used(surface_.light.size(), false);
  for (const auto& triangle : surface_.triangles)
    for (const auto v : triangle) is_used[v] = true;
  std::vector<std::uint32_t> used;
  for (const auto v : surface_.own)
    if (is_used[v]) used.push_back(v);
  return used;
}

// Removes all of the primitive's vertices but these; all of them are still present.
void SurfaceMaker::keep_only(const std::vector<std::uint32_t>& used) {
  const auto all = surface_.own.size();
  if (used.size() == all) return;
  std::vector<std::uint32_t> number(surface_.light.size());
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    number[used[i]] = i;
    surface_.light[i] = surface_.light[used[i]];
    surface_.uv[i] = surface_.uv[used[i]];
  }
  for (auto v = all; v < number.size(); ++v) number[v] = static_cast<std::uint32_t>(v - all + used.size());
  const auto cut = [&](auto& values) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(used.size()),
                 values.begin() + static_cast<std::ptrdiff_t>(all));
  };
  cut(surface_.light);
  cut(surface_.uv);
  for (auto& triangle : surface_.triangles)
    for (auto& v : triangle) v = number[v];
  surface_.own = used;
  surface_.has_all_own = false;
}

// A vertex of the file keeps the first light that it gets; a different light needs another vertex.
std::uint32_t SurfaceMaker::vertex(const DrawnCorner& corner) {
  const auto& place = corner.place;
  const bool is_own = corner.point == none;
  if (is_own) {
    auto& light = surface_.light[place.of[0]];
    if (light == none) {
      light = corner.light;
      surface_.uv[place.of[0]] = corner.uv;
    }
    if (light == corner.light) return place.of[0];
  }
  const auto key = std::tuple(place.of, corner.point, corner.light);
  const auto [found, is_new] = added_.try_emplace(key, static_cast<std::uint32_t>(surface_.light.size()));
  if (is_new) {
    surface_.added.push_back(place);
    surface_.light.push_back(corner.light);
    surface_.uv.push_back(corner.uv);
  }
  return found->second;
}

std::vector<RoundTripSurface> filled(std::vector<SurfaceMaker> makers) {
  std::vector<RoundTripSurface> surfaces;
  for (auto& maker : makers)
    if (auto surface = maker.finish(); !surface.triangles.empty()) surfaces.push_back(std::move(surface));
  return surfaces;
}

}  // namespace luxel
