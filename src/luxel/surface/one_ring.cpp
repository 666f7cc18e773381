// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/one_ring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "luxel/core/none.h"

namespace luxel {
namespace {

// The direction from the edge into the patch, at right angles to the edge: n x e for a patch to the left of
// the edge, as with a counter-clockwise winding.
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

void OneRing::fill(std::span<const std::uint32_t> corners, std::span<const HangingVertex> hanging) {
  members_.clear();
  for (const auto c : corners) members_.push_back({c / 3, c % 3});
  for (const auto& h : hanging) members_.push_back({h.patch, h.edge});
  corner_count_ = corners.size();
  sets_.reset(2 * members_.size());
  if (corners.empty()) return;
  vertex_ = patches_.corners[corners[0] / 3][corners[0] % 3];

  list_sectors();
  for (auto first = sectors_.begin(); first != sectors_.end();) {
    const auto last =
        std::find_if(first, sectors_.end(), [&](const Sector& w) { return w.edge != first->edge; });
    join_around_edge({first, last});
    first = last;
  }
  surface_.resize(2 * members_.size());
  for (std::uint32_t side = 0; side < surface_.size(); ++side) surface_[side] = sets_.of(side);
}

void OneRing::list_sectors() {
  sectors_.clear();
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    const auto& ends = patches_.corners[patch(i)];
    const auto k = members_[i].place;
    const auto ahead = ends[(k + 1) % 3];
    const auto behind = ends[is_hanging(i) ? k : (k + 2) % 3];
    sectors_.push_back({ahead, ahead, i, true, 0.0});
    sectors_.push_back({behind, behind, i, false, 0.0});
  }
  const auto sort = [this] {
    std::sort(sectors_.begin(), sectors_.end(), [](const Sector& a, const Sector& b) {
      return std::tuple(a.edge, a.member, a.outwards) < std::tuple(b.edge, b.member, b.outwards);
    });
  };
  sort();
  if (join_open_edges()) sort();
}

// Where one patch's edge extends beyond its neighbours' (a T-junction), both leave this vertex along one
// line.
bool OneRing::join_open_edges() {
  constexpr std::size_t most = 32;  // a vertex with more open edges is not searched
  open_.clear();
  for (std::uint32_t i = 0; i < sectors_.size(); ++i)
    if ((i == 0 || sectors_[i - 1].edge != sectors_[i].edge) &&
        (i + 1 == sectors_.size() || sectors_[i + 1].edge != sectors_[i].edge))
      open_.push_back(i);
  if (open_.size() > most) return false;
  bool joined = false;
  for (std::size_t i = 1; i < open_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      auto& sector = sectors_[open_[i]];
      if (sector.edge != sector.other || !on_one_line(sector, sectors_[open_[j]])) continue;
      sector.edge = sectors_[open_[j]].edge;
      joined = true;
    }
  return joined;
}

bool OneRing::on_one_line(const Sector& a, const Sector& b) const {
  const auto& vertex = patches_.vertices[vertex_];
  auto u = Vec3d(patches_.vertices[a.other]) - Vec3d(vertex);
  auto v = Vec3d(patches_.vertices[b.other]) - Vec3d(vertex);
  if (glm::dot(u, u) > glm::dot(v, v)) std::swap(u, v);
  const auto length = glm::length(u), longer = glm::length(v);
  return length > 0.0 && glm::dot(u, v) > 0.0 &&
         glm::length(glm::cross(u, v)) / longer <= line_tolerance(vertex, length);
}

// Patches stand around an edge like the pages of a book, and so does a surface that only touches the edge.
// Light is continuous between two sides only if they face the same gap between neighbouring pages.
void OneRing::join_around_edge(std::span<const Sector> sectors) {
  if (sectors.size() < 2) return;
  const auto along = Vec3d(patches_.vertices[sectors[0].other]) - Vec3d(patches_.vertices[vertex_]);
  const auto length = glm::length(along);
  if (!(length > 0.0)) return;
  const auto edge = along / length;

  const auto x = into_patch(patches_.normal[patch(sectors[0].member)], edge, sectors[0].outwards);
  const auto y = glm::cross(edge, x);
  const auto angle_of = [&](const Vec3d& d) { return diamond_angle(glm::dot(d, x), glm::dot(d, y)); };
  pages_.assign(sectors.begin(), sectors.end());
  for (auto& w : pages_) w.angle = angle_of(into_patch(patches_.normal[patch(w.member)], edge, w.outwards));
  const auto& contacts = patches_.contacts;
  const auto before = [](const Contact& c, const auto& edge_ends) { return c.edge < edge_ends; };
  for (std::size_t i = 0; i < sectors.size() && !contacts.empty(); ++i) {
    const auto other = sectors[i].other;
    if (i > 0 && other == sectors[i - 1].other) continue;
    const std::array<std::uint32_t, 2> key = {std::min(vertex_, other), std::max(vertex_, other)};
    for (auto c = std::lower_bound(contacts.begin(), contacts.end(), key, before);
         c != contacts.end() && c->edge == key; ++c)
      pages_.push_back({sectors[i].edge, other, none, false, angle_of(Vec3d(c->into))});
  }

  std::sort(pages_.begin(), pages_.end(), [](const Sector& a, const Sector& b) {
    return std::tuple(a.angle, a.member) < std::tuple(b.angle, b.member);
  });
  for (std::size_t i = 0; i < pages_.size(); ++i) join_facing(pages_[i], pages_[(i + 1) % pages_.size()]);
}

// Seen along a turn around the edge, a front faces forwards if its winding runs outwards: e x (n x e) = n.
void OneRing::join_facing(const Sector& from, const Sector& to) {
  if (from.member == none || to.member == none) return;
  const auto from_back = !from.outwards;
  const auto to_back = to.outwards;
  const auto n = Vec3d(patches_.normal[patch(from.member)]) * (from_back ? -1.0 : 1.0);
  const auto m = Vec3d(patches_.normal[patch(to.member)]) * (to_back ? -1.0 : 1.0);
  if (!(std::min(glm::dot(n, m), 1.0) > static_cast<double>(cos_crease_))) return;
  sets_.join(2 * from.member + (from_back ? 1 : 0), 2 * to.member + (to_back ? 1 : 0));
}

}  // namespace luxel
