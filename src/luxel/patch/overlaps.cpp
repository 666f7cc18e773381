// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/overlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "luxel/core/bounds.h"
#include "luxel/core/disjoint_sets.h"
#include "luxel/core/triangle.h"
#include "luxel/patch/flat_triangle.h"
#include "luxel/patch/triangle_pairs.h"

namespace luxel {
namespace {

constexpr double same_plane_roundings = 16.0;  // of the coordinates: rays cannot tell such planes apart
constexpr double shrink = 0.1;  // a patch is tested at its centre, and so far from its corners to the centre

std::array<Vec3, 3> corners_of(const CleanTriangle& t, const std::vector<Vec3>& positions) {
  return {positions[t.corners[0]], positions[t.corners[1]], positions[t.corners[2]]};
}

double same_plane_slack(const std::array<Vec3, 3>& corners) {
  return same_plane_roundings * coordinate_rounding(corners);
}

// For triangles in one plane: an edge of `a` has all of `b` beyond it.
bool is_beside(const FlatTriangle& a, const FlatTriangle& b, double slack) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::all_of(b.corner.begin(), b.corner.end(),
                    [&](const Vec3d& p) { return a.inside(k, p) <= slack; }))
      return true;
  return false;
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// Tests pairs of triangles, most of which are neighbours in a mesh.
class OverlapTest {
 public:
  OverlapTest(const std::vector<CleanTriangle>& triangles, const std::vector<Vec3>& positions,
              const Context& context)
      : triangles_(triangles), positions_(positions), planes_(triangles.size()) {
    constexpr std::size_t grain = 8192;
    context.for_chunks(triangles.size(), grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        const auto p = corners_of(triangles[i], positions);
        planes_[i] = {glm::normalize(area_vector2(p[0], p[1], p[2])), same_plane_slack(p)};
      }
    });
  }

  std::vector<Bounds> boxes() const {
    std::vector<Bounds> result(triangles_.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      for (const auto& p : corners_of(triangles_[i], positions_)) {
        result[i].add(p - static_cast<float>(planes_[i].slack));
        result[i].add(p + static_cast<float>(planes_[i].slack));
      }
    return result;
  }

  bool overlap(std::uint32_t i, std::uint32_t j) const {
    const auto slack = std::max(planes_[i].slack, planes_[j].slack);
    if (!lies_in_plane(i, j, slack) || !lies_in_plane(j, i, slack)) return false;
    const auto p = corners_of(triangles_[i], positions_), q = corners_of(triangles_[j], positions_);
    const FlatTriangle a(p, planes_[i].normal), b(q, planes_[j].normal);
    return !is_beside(a, b, slack) && !is_beside(b, a, slack);
  }

 private:
  struct Plane {
    Vec3d normal{0.0};  // unit
    double slack = 0.0;
  };

  bool lies_in_plane(std::uint32_t i, std::uint32_t of, double slack) const {
    const Vec3d origin(positions_[triangles_[of].corners[0]]);
    const auto& c = triangles_[i].corners;
    return std::all_of(c.begin(), c.end(), [&](std::uint32_t v) {
      return std::fabs(glm::dot(planes_[of].normal, Vec3d(positions_[v]) - origin)) <= slack;
    });
  }

  const std::vector<CleanTriangle>& triangles_;
  const std::vector<Vec3>& positions_;
  std::vector<Plane> planes_;
};

std::vector<Pair> overlapping_pairs(const std::vector<CleanTriangle>& triangles,
                                    const std::vector<Vec3>& positions, const Context& context) {
  const OverlapTest test(triangles, positions, context);
  const OverlappingPairs pairs(test.boxes(), context);
  std::vector<std::vector<Pair>> of_part(pairs.parts());
  context.for_chunks(pairs.parts(), 1, [&](std::size_t part, std::size_t, int) {
    pairs.for_pairs(part, [&](std::uint32_t i, std::uint32_t j) {
      if (test.overlap(i, j)) of_part[part].push_back({i, j});
    });
  });
  std::vector<Pair> result;
  for (const auto& some : of_part) result.insert(result.end(), some.begin(), some.end());
  std::sort(result.begin(), result.end());
  return result;
}

// Decides which one of two triangles covers the other.
class Precedence {
 public:
  Precedence(std::span<const Pair> pairs, const std::vector<CleanTriangle>& triangles,
             const std::vector<MaterialId>& material, std::span<const BandMaterial> materials,
             const std::vector<Vec3>& positions)
      : triangles_(triangles),
        material_(material),
        materials_(materials),
        positions_(positions),
        chains_(triangles.size()) {
    std::vector<std::uint32_t> members;
    for (const auto& [i, j] : pairs) {
      chains_.join(i, j);
      members.insert(members.end(), {i, j});
    }
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    for (const auto i : members) area_of_surface_[surface(i)] += area_of_triangle(i);
  }

  bool comes_first(std::uint32_t i, std::uint32_t j) { return rank(i) < rank(j); }

 private:
  using Surface = std::pair<std::uint32_t, MaterialId>;  // of one chain
  Surface surface(std::uint32_t i) { return {chains_.of(i), material_[i]}; }
  double area_of_triangle(std::uint32_t i) const {
    const auto corners = corners_of(triangles_[i], positions_);
    return triangle_area(corners[0], corners[1], corners[2]);
  }
  std::tuple<bool, double, MaterialId, double, std::uint32_t> rank(std::uint32_t i) {
    const bool is_lamp = materials_[static_cast<std::size_t>(material_[i])].is_lamp();
    return {!is_lamp, area_of_surface_[surface(i)], material_[i], area_of_triangle(i), i};
  }

  const std::vector<CleanTriangle>& triangles_;
  const std::vector<MaterialId>& material_;
  std::span<const BandMaterial> materials_;
  const std::vector<Vec3>& positions_;
  DisjointSets chains_;
  std::map<Surface, double> area_of_surface_;  // m²
};

// Returns whether nothing of what lies under a cover is seen or lit.
bool can_cover(const BandMaterial& cover, const BandMaterial& covered, bool same_way) {
  if (cover.textures.cutout || cover.is_diffuser()) return false;
  if (cover.is_lamp() && covered.is_lamp()) return false;
  return cover.two_sided || (same_way && !covered.two_sided);
}

std::array<Vec3d, 4> test_points(const std::array<Vec3, 3>& corners) {
  const auto centre = (Vec3d(corners[0]) + Vec3d(corners[1]) + Vec3d(corners[2])) / 3.0;
  const auto near = [&](std::size_t k) { return (1.0 - shrink) * Vec3d(corners[k]) + shrink * centre; };
  return {centre, near(0), near(1), near(2)};
}

// Contacts without a patch at their edge go. They are sorted by edge.
void drop_loose_contacts(PatchSet& patches) {
  auto& contacts = patches.contacts;
  std::vector<std::uint8_t> is_held(contacts.size(), 0);
  const auto at = [&](const std::array<std::uint32_t, 2>& edge) {
    return std::lower_bound(
        contacts.begin(), contacts.end(), edge,
        [](const Contact& c, const std::array<std::uint32_t, 2>& e) { return c.edge < e; });
  };
  for (const auto& c : patches.corners)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(c[k], c[(k + 1) % 3]);
      const std::array edge{low, high};
      for (auto held = at(edge); held != contacts.end() && held->edge == edge; ++held)
        is_held[static_cast<std::size_t>(held - contacts.begin())] = 1;
    }
  std::size_t i = 0;
  std::erase_if(contacts, [&](const Contact&) { return is_held[i++] == 0; });
}

bool holds(const FlatTriangle& t, const Vec3d& p, double slack) {
  return t.inside(0, p) >= -slack && t.inside(1, p) >= -slack && t.inside(2, p) >= -slack;
}

}  // namespace

std::vector<Overlap> find_overlaps(const std::vector<CleanTriangle>& triangles,
                                   const std::vector<MaterialId>& material,
                                   std::span<const BandMaterial> materials,
                                   const std::vector<Vec3>& positions, const Context& context) {
  const auto pairs = overlapping_pairs(triangles, positions, context);
  Precedence precedence(pairs, triangles, material, materials, positions);
  const auto normal = [&](std::uint32_t i) {
    const auto c = corners_of(triangles[i], positions);
    return area_vector2(c[0], c[1], c[2]);
  };
  const auto material_of = [&](std::uint32_t i) -> const BandMaterial& {
    return materials[static_cast<std::size_t>(material[i])];
  };
  std::vector<Overlap> result;
  for (const auto& [i, j] : pairs) {
    const auto [cover, covered] = precedence.comes_first(i, j) ? Pair(i, j) : Pair(j, i);
    if (can_cover(material_of(cover), material_of(covered), glm::dot(normal(i), normal(j)) > 0.0))
      result.push_back({covered, cover});
  }
  std::sort(result.begin(), result.end(), [](const Overlap& a, const Overlap& b) {
    return std::pair(a.covered, a.cover) < std::pair(b.covered, b.cover);
  });
  return result;
}

std::size_t remove_covered(PatchSet& patches, const std::vector<Overlap>& overlaps,
                           const std::vector<CleanTriangle>& triangles, const std::vector<Vec3>& positions) {
  if (overlaps.empty()) return 0;
  std::size_t kept = 0;
  auto first = overlaps.begin();
  for (std::size_t p = 0; p < patches.size(); ++p) {
    // Both are in the order of the input triangles.
    while (first != overlaps.end() && triangles[first->covered].triangle < patches.triangle[p]) ++first;
    const auto& c = patches.corners[p];
    const auto points = test_points({positions[c[0]], positions[c[1]], positions[c[2]]});
    const auto is_covered = [&](const Vec3d& point) {
      for (auto o = first; o != overlaps.end() && triangles[o->covered].triangle == patches.triangle[p];
           ++o) {
        const auto cover = corners_of(triangles[o->cover], positions);
        if (holds(FlatTriangle(cover), point, same_plane_slack(cover))) return true;
      }
      return false;
    };
    if (std::all_of(points.begin(), points.end(), is_covered)) continue;
    patches.corners[kept] = c;
    patches.normal[kept] = patches.normal[p];
    patches.area[kept] = patches.area[p];
    patches.material[kept] = patches.material[p];
    patches.triangle[kept] = patches.triangle[p];
    ++kept;
  }
  const auto removed = patches.size() - kept;
  patches.corners.resize(kept);
  patches.normal.resize(kept);
  patches.area.resize(kept);
  patches.material.resize(kept);
  patches.triangle.resize(kept);
  if (removed > 0) drop_loose_contacts(patches);
  return removed;
}

}  // namespace luxel
