// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/vertex_fan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace luxel {
namespace {

// The direction from the edge into the patch, at right angles to the edge: n x e for a patch to whose left
// the edge runs, as a counter-clockwise winding has it.
Vec3d into_patch(const Vec3& normal, const Vec3d& edge, bool outwards) {
  const auto d = glm::cross(Vec3d(normal), edge);
  return outwards ? d : -d;
}

// Grows with the angle of (x, y) from 0 to 4 over a full turn: the "diamond angle", which orders like atan2
// but needs no trigonometry, whose last bits differ between hosts.
double diamond_angle(double x, double y) {
  const auto sum = std::abs(x) + std::abs(y);
  if (!(sum > 0.0)) return 0.0;
  if (y >= 0.0) return x >= 0.0 ? y / sum : 1.0 - x / sum;
  return x < 0.0 ? 2.0 - y / sum : 3.0 + x / sum;
}

}  // namespace

void VertexFan::fill(std::span<const std::uint32_t> corners) {
  corners_.assign(corners.begin(), corners.end());
  surface_.resize(2 * corners_.size());
  std::iota(surface_.begin(), surface_.end(), 0u);

  list_wings();
  for (auto first = wings_.begin(); first != wings_.end();) {
    const auto last =
        std::find_if(first, wings_.end(), [&](const Wing& w) { return w.other != first->other; });
    join_around_edge({first, last});
    first = last;
  }
  for (auto& side : surface_) side = root(side);
}

void VertexFan::list_wings() {
  wings_.clear();
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    const auto& ends = patches_.corners[patch(i)];
    const auto k = corners_[i] % 3;
    wings_.push_back({ends[(k + 1) % 3], i, true, 0.0});
    wings_.push_back({ends[(k + 2) % 3], i, false, 0.0});
  }
  std::sort(wings_.begin(), wings_.end(), [](const Wing& a, const Wing& b) {
    return std::tuple(a.other, a.corner, a.outwards) < std::tuple(b.other, b.corner, b.outwards);
  });
}

// Around an edge the patches stand like the pages of a book. Two sides see each other's light run on smoothly
// only if they face the same gap between neighbouring pages.
void VertexFan::join_around_edge(std::span<Wing> wings) {
  if (wings.size() < 2) return;
  const auto vertex = patches_.corners[patch(wings[0].corner)][corners_[wings[0].corner] % 3];
  const auto along = Vec3d(patches_.vertices[wings[0].other]) - Vec3d(patches_.vertices[vertex]);
  const auto length = glm::length(along);
  if (!(length > 0.0)) return;
  const auto edge = along / length;

  const auto x = into_patch(patches_.normal[patch(wings[0].corner)], edge, wings[0].outwards);
  const auto y = glm::cross(edge, x);
  for (auto& w : wings) {
    const auto d = into_patch(patches_.normal[patch(w.corner)], edge, w.outwards);
    w.angle = diamond_angle(glm::dot(d, x), glm::dot(d, y));
  }
  std::sort(wings.begin(), wings.end(), [](const Wing& a, const Wing& b) {
    return std::tuple(a.angle, a.corner) < std::tuple(b.angle, b.corner);
  });
  for (std::size_t i = 0; i < wings.size(); ++i) join_facing(wings[i], wings[(i + 1) % wings.size()]);
}

// Turning around the edge, a front looks forwards if its winding runs outwards: e x (n x e) = n.
void VertexFan::join_facing(const Wing& from, const Wing& to) {
  const auto from_back = !from.outwards;
  const auto to_back = to.outwards;
  const auto n = Vec3d(patches_.normal[patch(from.corner)]) * (from_back ? -1.0 : 1.0);
  const auto m = Vec3d(patches_.normal[patch(to.corner)]) * (to_back ? -1.0 : 1.0);
  if (!(std::min(glm::dot(n, m), 1.0) > static_cast<double>(cos_crease_))) return;
  const auto a = root(2 * from.corner + (from_back ? 1 : 0));
  const auto b = root(2 * to.corner + (to_back ? 1 : 0));
  surface_[std::max(a, b)] = std::min(a, b);
}

std::uint32_t VertexFan::root(std::uint32_t side) {
  while (surface_[side] != side) side = surface_[side] = surface_[surface_[side]];
  return side;
}

}  // namespace luxel
