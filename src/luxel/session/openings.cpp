// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/openings.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "luxel/core/bounds.h"
#include "luxel/core/none.h"

namespace luxel {
namespace {

// The lids of all loops, as geometry for rays. PatchSet::triangle is the loop.
PatchSet make_lids(const ScannedMesh& mesh) {
  PatchSet lids;
  for (std::uint32_t r = 0; r < mesh.loops.size(); ++r) {
    const auto& loop = mesh.loops[r];
    if (loop.edges.size() < 3) continue;  // closes nothing
    const auto centre = static_cast<std::uint32_t>(lids.vertices.size());
    lids.vertices.push_back(loop.centre);
    for (const auto e : loop.edges) {
      const auto first = static_cast<std::uint32_t>(lids.vertices.size());
      for (const auto& end : mesh.ends(e)) lids.vertices.push_back(end);
      lids.corners.push_back({centre, first, first + 1});
      lids.triangle.push_back(r);
    }
  }
  return lids;
}

struct Crossing {
  std::uint32_t loop = none;
  int direction = 0;
  Vec3 at{0.0f};
};

// Returns the last lid on the ray's way.
Crossing last_lid(const PatchSet& lids, const Tracer& tracer, const Ray& ray) {
  constexpr int most = 64;  // lids on one way; beyond that any of them is good enough
  Crossing crossing;
  auto rest = ray;
  for (int i = 0; i < most; ++i) {
    const auto hit = tracer.nearest(rest);
    if (!hit) break;
    const auto at = rest.origin + hit.distance * rest.direction;
    crossing = {lids.triangle[hit.patch], 0, at};
    // Advances by more than rounding, so that the same lid is not hit again.
    const auto size = glm::max(glm::abs(at), glm::abs(rest.origin));
    const auto step = 0x1p-18f * std::max({size.x, size.y, size.z, hit.distance});
    rest.origin = at + step * rest.direction;
  }
  return crossing;
}

// The exit of a ray from the box, starting inside: the direction is that of the box's side.
Crossing through_box(const Bounds& box, const Ray& ray) {
  Crossing crossing;
  auto nearest = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const auto d = ray.direction[axis];
    if (d == 0.0f) continue;
    const auto t = std::max(0.0f, ((d > 0.0f ? box.high[axis] : box.low[axis]) - ray.origin[axis]) / d);
    if (t >= nearest) continue;
    nearest = t;
    crossing.direction = 2 * axis + (d > 0.0f ? 1 : 0);
  }
  crossing.at = ray.origin + nearest * ray.direction;
  return crossing;
}

}  // namespace

std::vector<Opening> find_openings(const ScannedMesh& mesh, const std::vector<LostRay>& lost,
                                   const Context& context) {
  const auto lids = make_lids(mesh);
  std::optional<Tracer> tracer;
  if (lids.size() > 0) tracer.emplace(lids, context);

  std::vector<Crossing> crossings(lost.size());
  context.for_chunks(lost.size(), 256, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) {
      if (tracer) crossings[i] = last_lid(lids, *tracer, lost[i].ray);
      if (crossings[i].loop == none) crossings[i] = through_box(mesh.box, lost[i].ray);
    }
  });

  std::map<std::pair<std::uint32_t, int>, std::size_t> number;
  std::vector<Opening> openings;
  std::vector<Vec3d> sums;
  for (std::size_t i = 0; i < lost.size(); ++i) {
    const auto& c = crossings[i];
    const auto [place, is_new] = number.try_emplace({c.loop, c.direction}, openings.size());
    if (is_new) {
      openings.push_back({c.loop, c.direction});
      sums.emplace_back(0.0);
    }
    auto& opening = openings[place->second];
    opening.weight += lost[i].weight;
    ++opening.rays;
    sums[place->second] += lost[i].weight * Vec3d(c.at);
  }
  for (std::size_t i = 0; i < openings.size(); ++i)
    if (openings[i].weight > 0.0) openings[i].at = Vec3(sums[i] / openings[i].weight);
  std::stable_sort(openings.begin(), openings.end(),
                   [](const Opening& a, const Opening& b) { return a.weight > b.weight; });
  return openings;
}

}  // namespace luxel
