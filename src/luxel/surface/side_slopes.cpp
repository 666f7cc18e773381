// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/side_slopes.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "luxel/core/triangle.h"
#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr std::size_t sides_per_chunk = 4096;
// The hub of a large fan would make every patch of it a neighbour of every other. Such nodes are skipped:
// adjacent patches share the node at the boundary.
constexpr std::size_t max_at_node = 64;
// Approximate ratio of the smallest to the largest eigenvalue, for neighbours that are not collinear.
constexpr double min_spread = 1e-5;

Vec3d centroid(const PatchSet& patches, std::size_t patch) {
  const auto p = patches.points(patch);
  return (Vec3d(p[0]) + Vec3d(p[1]) + Vec3d(p[2])) / 3.0;
}

// Range of differences from the current side, which is included as 0.
struct Range {
  double low = 0.0, high = 0.0;

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

class Fit {
 public:
  Fit(const PatchSet& patches, const SideLight& light, const SideNodes& nodes,
      std::span<const Vec3d> centroids)
      : patches_(patches), light_(light), nodes_(nodes), centroids_(centroids) {}

  // rise: [band][corner], initially zero.
  void fill(SideId side, float* rise) {
    if (!(light_.weight(side) > 0.0) || !list_sides(side)) return;
    lay_out(side);
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const auto& n : neighbours_) {
      xx += n.weight * n.x * n.x;
      xy += n.weight * n.x * n.y;
      yy += n.weight * n.y * n.y;
    }
    const auto determinant = xx * yy - xy * xy;
    if (!(determinant > min_spread * (xx + yy) * (xx + yy))) return;

    const auto points = patches_.points(side.patch());
    for (std::size_t b = 0; b < light_.bands(); ++b) {
      const auto own = static_cast<double>(light_.at(side)[b]);
      double x = 0.0, y = 0.0, all = 0.0, explained = 0.0;
      Range met;  // over the neighbours' values
      for (const auto& n : neighbours_) {
        const auto more = static_cast<double>(light_.at(n.side)[b]) - own;
        x += n.weight * n.x * more;
        y += n.weight * n.y * more;
        all += n.weight * more * more;
        met.add(more);
      }
      const auto slope_x = (yy * x - xy * y) / determinant, slope_y = (xx * y - xy * x) / determinant;
      Range reached;  // over the plane at the neighbours' centroids
      for (const auto& n : neighbours_) {
        const auto more = slope_x * n.x + slope_y * n.y;
        explained += n.weight * more * more;
        reached.add(more);
      }
      const auto trust = all > 0.0 ? trust_in(explained / all) : 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto way = Vec3d(points[k]) - centroids_[side.patch()];
        const auto more = slope_x * glm::dot(way, x_) + slope_y * glm::dot(way, y_);
        rise[3 * b + k] =
            static_cast<float>(std::clamp(more, met.low + trust * std::min(0.0, more - reached.low),
                                          met.high + trust * std::max(0.0, more - reached.high)));
      }
    }
  }

 private:
  // Another side in the plane of the current one, relative to its centroid.
  struct Neighbour {
    SideId side;
    double x, y;    // m
    double weight;  // 1/m²
  };

  // Fills sides_ with the lit sides that share a node with this one, each once. Returns false where all are
  // dark.
  bool list_sides(SideId side) {
    const auto is_bright = [&](SideId s) {
      return std::any_of(light_.at(s), light_.at(s) + light_.bands(), [](float h) { return h != 0.0f; });
    };
    bool bright = is_bright(side);
    sides_.clear();
    const auto add_node = [&](std::uint32_t node) {
      const auto members = nodes_.at(node);
      if (members.size() > max_at_node) return;
      for (const auto& m : members) {
        if (m.side == side || !(light_.weight(m.side) > 0.0)) continue;
        if (std::find(sides_.begin(), sides_.end(), m.side) != sides_.end()) continue;
        bright = bright || is_bright(m.side);
        sides_.push_back(m.side);
      }
    };
    for (const auto node : nodes_.of_side[side.index()]) add_node(node);
    if (!nodes_.visits.empty())
      for (const auto& visit : nodes_.visited_by(side)) add_node(visit.node);
    return bright;
  }

  // Fraction by which the plane may exceed the values of all neighbours, given the fraction of their squared
  // differences that it explains: 1 where it explains all, 0 where it leaves a quarter or more. A slope has
  // two parameters, so with few neighbours much is explained by chance.
  double trust_in(double explained) const {
    constexpr double min_explained = 0.75;
    const auto count = static_cast<double>(neighbours_.size());
    if (!(count > 2.0)) return 0.0;
    return std::max(0.0, 1.0 - (1.0 - explained) * count / (count - 2.0) / (1.0 - min_explained));
  }

  void lay_out(SideId side) {
    constexpr double steepest =
        0.01;  // of the squared distance, along the plane: folded neighbours carry no information
    const auto points = patches_.points(side.patch());
    x_ = glm::normalize(Vec3d(points[1]) - Vec3d(points[0]));
    y_ = glm::normalize(glm::cross(area_vector2(points[0], points[1], points[2]), x_));
    neighbours_.clear();
    for (const auto other : sides_) {
      const auto way = centroids_[other.patch()] - centroids_[side.patch()];
      const auto x = glm::dot(way, x_), y = glm::dot(way, y_);
      const auto whole = glm::dot(way, way), flat = x * x + y * y;
      if (!(flat > steepest * whole)) continue;
      const auto unrolled = std::sqrt(whole / flat);
      neighbours_.push_back({other, unrolled * x, unrolled * y, part_across_crease(side, other) / whole});
    }
  }

  // The narrow bevels around a flat face turn away from it, and light steps there: for the face they count by
  // their size. On a ball, whose faces are alike, this changes nothing.
  double part_across_crease(SideId side, SideId other) const {
    constexpr double same_plane = 0.9998;  // cosine, 1 degree
    const auto turn = glm::dot(patches_.normal_of(side), patches_.normal_of(other));
    if (static_cast<double>(turn) > same_plane) return 1.0;
    return std::min(1.0, static_cast<double>(patches_.area[other.patch()] / patches_.area[side.patch()]));
  }

  const PatchSet& patches_;
  const SideLight& light_;
  const SideNodes& nodes_;
  std::span<const Vec3d> centroids_;
  Vec3d x_{0.0}, y_{0.0};  // unit, in the plane of the current side
  std::vector<SideId> sides_;
  std::vector<Neighbour> neighbours_;
};

}  // namespace

SideSlopes::SideSlopes(const PatchSet& patches, const SideLight& light, const SideNodes& nodes,
                       const Context& context)
    : bands_(light.bands()), rise_(6 * patches.size() * bands_, 0.0f) {
  std::vector<Vec3d> centroids(patches.size());
  context.for_chunks(patches.size(), sides_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto p = begin; p < end; ++p) centroids[p] = centroid(patches, p);
  });
  context.for_chunks(side_count(patches.size()), sides_per_chunk,
                     [&](std::size_t begin, std::size_t end, int) {
                       Fit fit(patches, light, nodes, centroids);
                       for (auto i = begin; i < end; ++i)
                         fit.fill(SideId::at(i), rise_.data() + 3 * i * bands_);
                     });
}

}  // namespace luxel
