// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/export/round_trip_surfaces.h"

namespace luxel {

// A corner of a drawn triangle: its place in its triangle of the file, and its light.
struct DrawnCorner {
  RoundTripVertex place;
  std::uint32_t point = none;  // a vertex of the patches; none: a corner of the triangle
  std::uint32_t light = none;
  Vec2 uv{0.0f};
};

// Place of a vertex of the patches on an edge of its triangle, from corner `edge` to the next.
struct EdgePlace {
  std::size_t edge = 0;
  double fraction = 0.0;  // of the way
};
// Nothing for corners, and for points inside.
std::optional<EdgePlace> place_on_edge(const RoundTripScene& round_trip, std::uint32_t triangle,
                                       std::uint32_t point);

// A corner of a patch, in the part's i-th triangle; the corners of a patch there; those of the triangle.
DrawnCorner corner_of(const RoundTripScene& round_trip, const RoundTripPart& part, std::size_t i,
                      std::uint32_t point);
std::array<DrawnCorner, 3> corners_of_patch(const RoundTripScene& round_trip, const RoundTripPart& part,
                                            std::size_t i, std::uint32_t patch);
std::array<DrawnCorner, 3> own_corners(const RoundTripPart& part, std::size_t i);

// Fills one surface; vertices that agree in all are one.
class SurfaceMaker {
 public:
  // Keeps a reference.
  SurfaceMaker(const RoundTripPart& part, bool back, std::uint32_t page);

  // As the scene winds them.
  void add(const std::array<DrawnCorner, 3>& corners);
  RoundTripSurface finish();

 private:
  std::vector<std::uint32_t> used_of_own() const;
  void keep_only(const std::vector<std::uint32_t>& used);
  std::uint32_t vertex(const DrawnCorner& corner);

  const RoundTripPart& part_;
  RoundTripSurface surface_;
  std::map<std::tuple<std::array<std::uint32_t, 3>, std::uint32_t, std::uint32_t>, std::uint32_t> added_;
};

// Returns the surfaces that have triangles.
std::vector<RoundTripSurface> filled(std::vector<SurfaceMaker> makers);

}  // namespace luxel
