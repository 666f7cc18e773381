// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/half_edge_collapse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "luxel/core/none.h"

namespace luxel {
namespace {

constexpr int max_passes = 60;       // far more than meshes need: 20 passes for 400,000 patches
constexpr double min_shape = 0.02;   // 1: equilateral; slimmer triangles are not made of better ones
constexpr float invisible = 0.3f;    // error, 1 for the largest allowed, below which the shape decides
constexpr double rounding = 2.4e-7;  // two units in the last place of a float
constexpr double flat_error = 1e-4;  // relative error of areas: vertices on edges are rounded to floats
constexpr double outside = -1e-3;    // smallest barycentric coordinate of a point within a triangle
constexpr auto impossible = std::numeric_limits<double>::infinity();

using Corners = std::array<CornerId, 3>;

}  // namespace

HalfEdgeCollapse::HalfEdgeCollapse(const PatchSet& patches, const SmoothLight& light,
                                   const DisplayedCorners& displayed, const std::vector<bool>& stays)
    : patches_(patches),
      light_(light),
      displayed_(displayed),
      stays_(stays),
      corners_(patches.size()),
      is_gone_(patches.size(), false),
      around_(patches.vertices.size()),
      removed_(patches.size()) {
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    for (std::uint32_t k = 0; k < 3; ++k) {
      corners_[p][k] = 3 * p + k;
      around_[patches.corners[p][k]].push_back(p);
    }
}

void HalfEdgeCollapse::run() {
  std::vector<std::uint8_t> is_open(around_.size(), 1);
  for (int pass = 0; pass < max_passes; ++pass) {
    std::vector<std::uint8_t> is_touched(around_.size(), 0), is_next(around_.size(), 0);
    bool any = false;
    // Refinement adds the finest vertices last.
    for (auto v = static_cast<std::uint32_t>(around_.size()); v-- > 0;) {
      if (!is_open[v]) continue;
      if (is_touched[v]) {
        is_next[v] = 1;
        continue;
      }
      if (!remove(v)) continue;
      any = true;
      for (const auto n : ring_) is_touched[n] = is_next[n] = 1;
    }
    if (!any) return;
    is_open = std::move(is_next);
  }
}

std::vector<std::uint32_t> HalfEdgeCollapse::replaced_by(std::size_t patch) const {
  std::vector<std::uint32_t> result;
  for (const auto corner : removed_[patch]) result.push_back(corner / 3);
  return result;
}

std::uint32_t HalfEdgeCollapse::corner_at(std::uint32_t patch, std::uint32_t v) const {
  for (std::uint32_t k = 0; k < 3; ++k)
    if (vertex(corners_[patch][k]) == v) return k;
  return none;
}

Corners HalfEdgeCollapse::corners_of(const NewTriangle& t) const {
  auto corners = corners_[t.patch];
  corners[t.k] = t.corner;
  return corners;
}

// The patches around a vertex; drops those that are gone from the list.
const std::vector<std::uint32_t>& HalfEdgeCollapse::star_of(std::uint32_t v) {
  auto& star = around_[v];
  std::erase_if(star, [&](std::uint32_t p) { return is_gone_[p]; });
  return star;
}

// Leaves its neighbours in ring_.
bool HalfEdgeCollapse::remove(std::uint32_t v) {
  const auto& star = star_of(v);
  if (star.empty() || std::any_of(star.begin(), star.end(), [&](auto p) { return stays_[p]; })) return false;
  ring_.clear();
  for (const auto p : star)
    for (const auto corner : corners_[p])
      if (vertex(corner) != v) ring_.push_back(vertex(corner));
  std::sort(ring_.begin(), ring_.end());
  ring_.erase(std::unique(ring_.begin(), ring_.end()), ring_.end());
  auto best = impossible;
  for (const auto u : ring_) {
    const auto cost = try_collapse(v, u, star, best);
    if (!(cost < best)) continue;
    best = cost;
    best_triangles_ = triangles_;
    best_covered_ = covered_;
  }
  if (best == impossible) return false;
  apply(v, star);
  return true;
}

// Fills triangles_ and covered_. Returns the cost: the error, and a penalty for slim triangles.
double HalfEdgeCollapse::try_collapse(std::uint32_t v, std::uint32_t u,
                                      const std::vector<std::uint32_t>& star, double best) {
  if (!make_triangles(v, u, star)) return impossible;
  double old_shape = 1.0, new_shape = 1.0;
  for (const auto p : star) old_shape = std::min(old_shape, shape(corners_[p]));
  for (const auto& t : triangles_) new_shape = std::min(new_shape, shape(corners_of(t)));
  if (new_shape < std::min(min_shape, old_shape)) return impossible;
  float largest = 0.0f;
  const auto cost = [&] { return static_cast<double>(std::max(largest, invisible)) / std::sqrt(new_shape); };
  covered_.clear();
  for (const auto p : star) {
    const auto k = corner_at(p, v);
    if (!cover(corners_[p][k], p, k, largest)) return impossible;
    for (const auto corner : removed_[p])
      if (!cover(corner, p, k, largest)) return impossible;
    if (!cover_middles(p, k, largest)) return impossible;
    if (cost() >= best) return impossible;
  }
  return cost();
}

// The patches that remain, with u in place of v. False where they do not cover each input triangle as before,
// or the light of u is not that of one sheet.
bool HalfEdgeCollapse::make_triangles(std::uint32_t v, std::uint32_t u,
                                      const std::vector<std::uint32_t>& star) {
  triangles_.clear();
  collapsing_.clear();
  areas_.clear();
  for (const auto p : star)
    if (const auto at_u = corner_at(p, u); at_u != none) {
      const auto k = corner_at(p, v);
      collapsing_.push_back({p, k, corners_[p][at_u], patches_.triangle[p], smooth(corners_[p][k])});
    }
  for (const auto p : star) {
    add_area({patches_.triangle[p], signed_area(p, corners_[p]), 0.0, area_rounding(corners_[p])});
    if (std::any_of(collapsing_.begin(), collapsing_.end(), [&](const auto& g) { return g.patch == p; }))
      continue;
    const auto k = corner_at(p, v);
    NewTriangle t{p, k, none, patches_.triangle[p], smooth(corners_[p][k])};
    for (const auto& g : collapsing_) {
      if (g.triangle != t.triangle || g.sheet != t.sheet) continue;
      if (t.corner != none && smooth(t.corner) != smooth(g.corner)) return false;
      if (t.corner == none) t.corner = g.corner;
    }
    if (t.corner == none) return false;
    const auto corners = corners_of(t);
    const auto area = signed_area(p, corners);
    if (!(area > 0.0)) return false;
    add_area({t.triangle, 0.0, area, area_rounding(corners)});
    triangles_.push_back(t);
  }
  return !triangles_.empty() && std::all_of(areas_.begin(), areas_.end(), [](const Areas& a) {
    return std::abs(a.before - a.after) <= flat_error * a.before + a.tolerance;
  });
}

void HalfEdgeCollapse::add_area(const Areas& more) {
  for (auto& a : areas_)
    if (a.triangle == more.triangle) {
      a.before += more.before;
      a.after += more.after;
      a.tolerance += more.tolerance;
      return;
    }
  areas_.push_back(more);
}

std::size_t HalfEdgeCollapse::covering(std::uint32_t patch, std::uint32_t k, const Vec3d& at,
                                       Vec3& weights) const {
  const auto triangle = patches_.triangle[patch];
  const auto sheet = smooth(corners_[patch][k]);
  auto inside = outside;
  std::size_t found = none;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto& t = triangles_[i];
    if (t.triangle != triangle || t.sheet != sheet) continue;
    const auto w = weights_in(t, at);
    const auto least = std::min({w.x, w.y, w.z});
    if (!(least > inside)) continue;
    inside = least;
    found = i;
    weights = Vec3(w);
  }
  return found;
}

// Finds the new triangle that shows a corner which was in a patch whose corner k is removed; raises `largest`
// to the error there. False where the error is too large.
bool HalfEdgeCollapse::cover(CornerId corner, std::uint32_t patch, std::uint32_t k, float& largest) {
  Vec3 weights(0.0f);
  const auto by = covering(patch, k, place(corner), weights);
  if (by == none) return false;
  largest = std::max(largest, displayed_.error(corner, corners_of(triangles_[by]), weights));
  covered_.push_back({corner, by});
  return largest <= 1.0f;
}

// The same for the middles of the two edges of a patch that end at its corner k: where an edge turns, the
// light between vertices changes as well.
bool HalfEdgeCollapse::cover_middles(std::uint32_t patch, std::uint32_t k, float& largest) const {
  const auto removed = corners_[patch][k];
  for (std::uint32_t j = 1; j < 3; ++j) {
    const auto other = corners_[patch][(k + j) % 3];
    Vec3 weights(0.0f);
    const auto by = covering(patch, k, 0.5 * (place(removed) + place(other)), weights);
    if (by == none) return false;
    largest = std::max(largest, displayed_.middle_error(removed, other, corners_of(triangles_[by]), weights));
    if (largest > 1.0f) return false;
  }
  return true;
}

void HalfEdgeCollapse::apply(std::uint32_t v, const std::vector<std::uint32_t>& star) {
  for (const auto p : star) {
    removed_[p].clear();
    is_gone_[p] = std::none_of(best_triangles_.begin(), best_triangles_.end(),
                               [&](const auto& t) { return t.patch == p; });
  }
  for (const auto& t : best_triangles_) {
    corners_[t.patch][t.k] = t.corner;
    around_[vertex(t.corner)].push_back(t.patch);
  }
  for (const auto& c : best_covered_) removed_[best_triangles_[c.by].patch].push_back(c.corner);
  around_[v].clear();
}

// Twice the area, above 0 where it is wound like the patch.
double HalfEdgeCollapse::signed_area(std::uint32_t patch, const Corners& c) const {
  const auto a = place(c[0]);
  return glm::dot(glm::cross(place(c[1]) - a, place(c[2]) - a), Vec3d(patches_.normal[patch]));
}

// 1 for an equilateral triangle, 0 for a line.
double HalfEdgeCollapse::shape(const Corners& c) const {
  const auto a = place(c[0]), b = place(c[1]), d = place(c[2]);
  const auto sides = glm::dot(b - a, b - a) + glm::dot(d - b, d - b) + glm::dot(a - d, a - d);
  return sides > 0.0 ? 2.0 * std::sqrt(3.0) * glm::length(glm::cross(b - a, d - a)) / sides : 0.0;
}

// Effect of the rounding of coordinates on a doubled area.
double HalfEdgeCollapse::area_rounding(const Corners& corners) const {
  double largest = 0.0, longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = place(corners[k]), b = place(corners[(k + 1) % 3]);
    largest = std::max({largest, std::abs(a.x), std::abs(a.y), std::abs(a.z)});
    longest = std::max(longest, glm::length(b - a));
  }
  return rounding * largest * longest;
}

// Barycentric coordinates, below 0 outside.
Vec3d HalfEdgeCollapse::weights_in(const NewTriangle& t, const Vec3d& at) const {
  const auto corners = corners_of(t);
  const auto normal = Vec3d(patches_.normal[t.patch]);
  const auto part = [&](std::size_t k) {
    const auto b = place(corners[(k + 1) % 3]), c = place(corners[(k + 2) % 3]);
    return glm::dot(glm::cross(b - at, c - at), normal);
  };
  const Vec3d parts{part(0), part(1), part(2)};
  return parts / (parts.x + parts.y + parts.z);
}

}  // namespace luxel
