// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/round_trip_surfaces.h"

#include "luxel/export/surface_maker.h"

namespace luxel {
namespace {

// Front and back.
std::vector<SurfaceMaker> two_sides(const RoundTripPart& part) { return {{part, false, 0}, {part, true, 0}}; }

}  // namespace

PatchesOfTriangles::PatchesOfTriangles(const PatchSet& patches, std::size_t triangles)
    : begin_(triangles + 1) {
  for (const auto t : patches.triangle) ++begin_[t + 1];
  for (std::size_t t = 0; t < triangles; ++t) begin_[t + 1] += begin_[t];
}

std::vector<RoundTripSurface> uncut_surfaces(const RoundTripScene& round_trip, const RoundTripPart& part) {
  auto sides = two_sides(part);
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    const auto t = part.triangles[i];
    auto corners = own_corners(part, i);
    for (std::size_t c = 0; c < 3; ++c) corners[c].light = round_trip.scene.triangles[t][c];
    sides[0].add(corners);
    bool lit = false;
    for (auto p = round_trip.of_triangles.begin(t); p < round_trip.of_triangles.end(t); ++p)
      lit = lit || round_trip.back_is_lit[p];
    if (lit) sides[1].add(corners);
  }
  return filled(std::move(sides));
}

std::vector<RoundTripSurface> cut_surfaces(const RoundTripScene& round_trip, const RoundTripPart& part,
                                           const SmoothLight& light) {
  auto sides = two_sides(part);
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    const auto t = part.triangles[i];
    for (auto p = round_trip.of_triangles.begin(t); p < round_trip.of_triangles.end(t); ++p) {
      auto corners = corners_of_patch(round_trip, part, i, p);
      for (std::size_t c = 0; c < 3; ++c) corners[c].light = light.corners[p][c];
      sides[0].add(corners);
      if (round_trip.back_is_lit[p]) sides[1].add(corners);
    }
  }
  return filled(std::move(sides));
}

}  // namespace luxel
