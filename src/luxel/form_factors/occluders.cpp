// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/occluders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "luxel/core/convex_hull.h"
#include "luxel/core/disjoint_sets.h"
#include "luxel/form_factors/polygon_form_factor.h"

namespace luxel {
namespace {

constexpr std::size_t max_corners = 16;  // clipping by more is no faster than by two polygons
constexpr float level = 1e-6f;           // of a cosine: normals of one face, as floats have them
constexpr double collinear = 0.25;       // of the slack: how near a corner is to the line of its neighbours

using Polygon = std::vector<Vec3d>;

double perimeter(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    sum += glm::length(polygon[(k + 1) % polygon.size()] - polygon[k]);
  return sum;
}

// The convex hull of points in a plane of this unit normal, counter-clockwise about it, without corners that
// lie within `tolerance`, m, of the line of their neighbours.
Polygon convex_hull(Polygon points, const Vec3d& normal, double tolerance) {
  const auto across = glm::normalize(
      glm::cross(normal, std::fabs(normal.x) < 0.6 ? Vec3d(1.0, 0.0, 0.0) : Vec3d(0.0, 1.0, 0.0)));
  const auto along = glm::cross(normal, across);
  std::sort(points.begin(), points.end(), [&](const Vec3d& a, const Vec3d& b) {
    return std::pair(glm::dot(across, a), glm::dot(along, a)) <
           std::pair(glm::dot(across, b), glm::dot(along, b));
  });
  return hull_of_sorted(points, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return glm::dot(normal, glm::cross(b - a, c - a)) > tolerance * glm::length(c - a);
  });
}

// Patches that are joined, and the polygon they fill.
struct Piece {
  Polygon corners;                    // convex; empty: part of another piece
  double area = 0.0;                  // m², the sum of its patches'
  std::vector<std::uint32_t> beside;  // patches across its edges, some of them its own
};

class Joiner {
 public:
  Joiner(const PatchSet& patches, double slack)
      : slack_(slack), sets_(patches.size()), pieces_(patches.size()) {
    for (std::uint32_t p = 0; p < patches.size(); ++p) {
      for (const auto& corner : patches.points(p)) pieces_[p].corners.emplace_back(corner);
      pieces_[p].area = glm::length(polygon_area_vector(pieces_[p].corners));
    }
    find_neighbours(patches);
    // Joins whole faces, or all parts of one triangle, at once; then piece by piece. Pieces that do not fit
    // at first may fit once both have grown: cells to strips, strips to walls.
    DisjointSets faces(patches.size()), triangles(patches.size());
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      for (const auto q : pieces_[p].beside) {
        if (is_level(patches.normal[p], patches.normal[q])) faces.join(p, q);
        if (patches.triangle[p] == patches.triangle[q]) triangles.join(p, q);
      }
    join_sets(faces);
    join_sets(triangles);
    for (bool has_joined = true; has_joined;) {
      has_joined = false;
      for (std::uint32_t p = 0; p < pieces_.size(); ++p)
        if (sets_.of(p) == p) has_joined = grow(p) || has_joined;
    }
  }

  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  struct Edge {
    std::array<std::uint32_t, 2> ends;  // the lower vertex first
    std::uint32_t patch = 0;
    Vec3 inward{};  // into the patch
  };

  // Patches are neighbours if they lie on either side of an edge that no third patch has.
  void find_neighbours(const PatchSet& patches) {
    std::vector<Edge> edges;
    for (std::uint32_t p = 0; p < patches.size(); ++p) {
      const auto points = patches.points(p);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(patches.corners[p][k], patches.corners[p][(k + 1) % 3]);
        edges.push_back({{low, high}, p, glm::cross(patches.normal[p], points[(k + 1) % 3] - points[k])});
      }
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
      while (end < edges.size() && edges[end].ends == edges[i].ends) ++end;
      if (end - i != 2 || !(glm::dot(edges[i].inward, edges[i + 1].inward) < 0.0f)) continue;
      pieces_[edges[i].patch].beside.push_back(edges[i + 1].patch);
      pieces_[edges[i + 1].patch].beside.push_back(edges[i].patch);
    }
  }

  static bool is_level(const Vec3& a, const Vec3& b) { return std::fabs(glm::dot(a, b)) > 1.0f - level; }

  // Joins those patches of each set that are still pieces of their own, where they fill one polygon.
  void join_sets(DisjointSets& sets) {
    std::vector<std::vector<std::uint32_t>> members(pieces_.size());
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
      if (sets_.of(p) == p) members[sets.of(p)].push_back(p);
    for (const auto& set : members) {
      if (set.size() < 2) continue;
      Piece whole;
      for (const auto p : set) add(pieces_[p], whole);
      whole.corners = joint(std::move(whole.corners), pieces_[set[0]].corners, whole.area);
      if (whole.corners.empty()) continue;
      for (const auto p : set) {
        sets_.join(set[0], p);
        pieces_[p] = {};
      }
      pieces_[set[0]] = std::move(whole);
    }
  }

  static void add(const Piece& part, Piece& whole) {
    whole.corners.insert(whole.corners.end(), part.corners.begin(), part.corners.end());
    whole.area += part.area;
    whole.beside.insert(whole.beside.end(), part.beside.begin(), part.beside.end());
  }

  // Joins a piece with all neighbours that it can be joined with. Returns whether there was any.
  bool grow(std::uint32_t piece) {
    bool has_grown = false;
    auto own = std::exchange(pieces_[piece], {});
    for (std::size_t i = 0; i < own.beside.size(); ++i) {
      const auto number = sets_.of(own.beside[i]);
      if (number == sets_.of(piece)) continue;
      auto& other = pieces_[number];
      auto points = own.corners;
      points.insert(points.end(), other.corners.begin(), other.corners.end());
      const auto& larger = own.area < other.area ? other : own;
      auto corners = joint(std::move(points), larger.corners, own.area + other.area);
      if (corners.empty()) continue;
      add(other, own);
      own.corners = std::move(corners);
      other = {};
      sets_.join(piece, number);
      has_grown = true;
    }
    const auto name = sets_.of(piece);
    std::erase_if(own.beside, [&](std::uint32_t p) { return sets_.of(p) == name; });
    pieces_[name] = std::move(own);
    return has_grown;
  }

  // Returns the polygon that these points span, in the plane of one part of it; empty where they lie off the
  // plane, or where parts of this area, m², leave a notch.
  Polygon joint(Polygon points, const Polygon& part, double area) const {
    const auto front = polygon_area_vector(part);
    const auto size = glm::length(front);
    if (!(size > 0.0)) return {};
    const auto normal = front / size;
    const auto off_plane = [&](const Vec3d& p) { return std::fabs(glm::dot(normal, p - part[0])) > slack_; };
    if (std::any_of(points.begin(), points.end(), off_plane)) return {};
    auto hull = convex_hull(std::move(points), normal, collinear * slack_);
    if (hull.size() < 3 || hull.size() > max_corners) return {};
    const auto notch = std::fabs(glm::length(polygon_area_vector(hull)) - area);
    return notch <= slack_ * perimeter(hull) ? hull : Polygon{};
  }

  double slack_;
  DisjointSets sets_;  // of patches; the piece of a set has the number of its lowest patch
  std::vector<Piece> pieces_;
};

}  // namespace

Occluders::Occluders(const PatchSet& patches, double slack) : begin_{0} {
  for (const Joiner joiner(patches, slack); const auto& piece : joiner.pieces()) {
    if (piece.corners.empty()) continue;
    corners_.insert(corners_.end(), piece.corners.begin(), piece.corners.end());
    begin_.push_back(static_cast<std::uint32_t>(corners_.size()));
  }
}

}  // namespace luxel
