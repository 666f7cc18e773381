// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/fragment_mesh.h"

#include <algorithm>

#include "luxel/core/none.h"

namespace luxel {

FragmentMesh::FragmentMesh()
    : points_{{0, 0}, {grid, 0}, {0, grid}},
      fragment_at_{0, 0, 0},
      fragments_{{{0, 1, 2}, {none, none, none}}} {}

FragmentMesh::FragmentMesh(std::vector<Point> points, std::vector<Fragment> fragments)
    : points_(std::move(points)), fragment_at_(points_.size(), none), fragments_(std::move(fragments)) {
  for (std::uint32_t f = 0; f < next_number(); ++f)
    for (const auto point : fragments_[f].v) fragment_at_[point] = f;
}

FragmentMesh::Edge FragmentMesh::other_side(Edge e) const {
  const auto other = fragments_[e.fragment].across[e.k];
  if (other == none) return {};
  const auto& v = fragments_[other].v;
  const auto start = to(e);
  return {other, start == v[0] ? 0u : (start == v[1] ? 1u : 2u)};
}

std::int64_t FragmentMesh::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  const auto& p = points_[a];
  const auto& q = points_[b];
  const auto& r = points_[c];
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

std::uint32_t FragmentMesh::add_point(const Point& p) {
  points_.push_back(p);
  fragment_at_.push_back(none);
  return static_cast<std::uint32_t>(points_.size() - 1);
}

std::uint32_t FragmentMesh::fragment_with(std::uint32_t point) const {
  const auto holds = [&](std::uint32_t fragment, std::uint32_t k) {
    const auto& v = fragments_[fragment].v;
    return turn(v[k], v[(k + 1) % 3], point) >= 0;
  };
  // Walks towards the point, starting from the latest triangle. In a mesh that is not Delaunay the walk may
  // cycle; then every fragment is tested.
  auto fragment = next_number() - 1;
  for (std::size_t steps = 0; steps < fragments_.size(); ++steps) {
    const auto k = !holds(fragment, 0) ? 0u : (!holds(fragment, 1) ? 1u : (!holds(fragment, 2) ? 2u : 3u));
    if (k == 3) return fragment;
    if (fragments_[fragment].across[k] == none) break;
    fragment = fragments_[fragment].across[k];
  }
  for (fragment = 0; fragment + 1 < next_number(); ++fragment)
    if (holds(fragment, 0) && holds(fragment, 1) && holds(fragment, 2)) break;
  return fragment;
}

std::vector<FragmentMesh::Edge> FragmentMesh::spokes(std::uint32_t point) const {
  const auto edge_of = [&](std::uint32_t fragment) {
    const auto& v = fragments_[fragment].v;
    return Edge{fragment, v[0] == point ? 0u : (v[1] == point ? 1u : 2u)};
  };
  std::vector<Edge> result;
  const auto start = fragment_at_[point];
  auto fragment = start;
  do {  // leftwards
    const auto e = edge_of(fragment);
    result.push_back(e);
    fragment = fragments_[fragment].across[(e.k + 2) % 3];
  } while (fragment != none && fragment != start);
  if (fragment == start) return result;
  // The point is on the boundary: the fragments to the right are still missing.
  for (fragment = fragments_[start].across[result[0].k]; fragment != none;) {
    const auto e = edge_of(fragment);
    result.push_back(e);
    fragment = fragments_[fragment].across[e.k];
  }
  return result;
}

FragmentMesh::Edge FragmentMesh::edge_between(std::uint32_t a, std::uint32_t b) const {
  for (const auto e : spokes(a)) {
    if (to(e) == b) return e;
    if (apex(e) == b) return {e.fragment, (e.k + 2) % 3};
  }
  return {};
}

void FragmentMesh::set(std::uint32_t fragment, std::array<std::uint32_t, 3> v,
                       std::array<std::uint32_t, 3> across) {
  if (fragment == next_number()) fragments_.emplace_back();
  fragments_[fragment] = {v, across};
  for (const auto point : v) fragment_at_[point] = fragment;
}

void FragmentMesh::redirect(std::uint32_t fragment, std::uint32_t old_neighbour, std::uint32_t neighbour) {
  if (fragment == none) return;
  auto& across = fragments_[fragment].across;
  *std::find(across.begin(), across.end(), old_neighbour) = neighbour;
}

void FragmentMesh::split_fragment(std::uint32_t fragment, std::uint32_t p) {
  const auto [v, across] = fragments_[fragment];
  const auto second = next_number();
  const auto third = second + 1;
  set(fragment, {v[0], v[1], p}, {across[0], second, third});
  set(second, {v[1], v[2], p}, {across[1], third, fragment});
  set(third, {v[2], v[0], p}, {across[2], fragment, second});
  redirect(across[1], fragment, second);
  redirect(across[2], fragment, third);
}

bool FragmentMesh::can_split(Edge e, std::uint32_t p) const {
  const auto fits = [&](Edge side) {
    return turn(from(side), p, apex(side)) > 0 && turn(p, to(side), apex(side)) > 0;
  };
  const auto other = other_side(e);
  return fits(e) && (other.fragment == none || fits(other));
}

void FragmentMesh::split_edge(Edge e, std::uint32_t p) {
  const auto other = other_side(e);
  const auto a = from(e), b = to(e), c = apex(e);
  const auto old = fragments_[e.fragment].across;
  const auto t = e.fragment;
  const auto t2 = next_number();
  const auto u = other.fragment;
  const auto u2 = u == none ? none : t2 + 1;
  set(t, {a, p, c}, {u, t2, old[(e.k + 2) % 3]});
  set(t2, {p, b, c}, {u2, old[(e.k + 1) % 3], t});
  redirect(old[(e.k + 1) % 3], t, t2);
  if (u == none) return;
  const auto d = apex({u, other.k});
  const auto old_u = fragments_[u].across;
  set(u, {p, a, d}, {t, old_u[(other.k + 1) % 3], u2});
  set(u2, {b, p, d}, {t2, u, old_u[(other.k + 2) % 3]});
  redirect(old_u[(other.k + 2) % 3], u, u2);
}

bool FragmentMesh::can_flip(Edge e) const {
  const auto other = other_side(e);
  return other.fragment != none && turn(from(e), apex(other), apex(e)) > 0 &&
         turn(apex(other), to(e), apex(e)) > 0;
}

void FragmentMesh::flip(Edge e) {
  const auto other = other_side(e);
  const auto t = e.fragment, u = other.fragment;
  const auto a = from(e), b = to(e), c = apex(e), d = apex(other);
  const auto old_t = fragments_[t].across;
  const auto old_u = fragments_[u].across;
  const auto a_d = old_u[(other.k + 1) % 3], d_b = old_u[(other.k + 2) % 3];
  const auto b_c = old_t[(e.k + 1) % 3], c_a = old_t[(e.k + 2) % 3];
  set(t, {a, d, c}, {a_d, u, c_a});
  set(u, {d, b, c}, {d_b, b_c, t});
  redirect(a_d, u, t);
  redirect(b_c, t, u);
}

}  // namespace luxel
