// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/piece_mesh.h"

#include <algorithm>

namespace luxel {

PieceMesh::PieceMesh()
    : points_{{0, 0}, {grid, 0}, {0, grid}}, piece_at_{0, 0, 0}, pieces_{{{0, 1, 2}, {none, none, none}}} {}

PieceMesh::Edge PieceMesh::other_side(Edge e) const {
  const auto other = pieces_[e.piece].across[e.k];
  if (other == none) return {};
  const auto& v = pieces_[other].v;
  const auto start = to(e);
  return {other, start == v[0] ? 0u : (start == v[1] ? 1u : 2u)};
}

std::int64_t PieceMesh::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  const auto& p = points_[a];
  const auto& q = points_[b];
  const auto& r = points_[c];
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

std::uint32_t PieceMesh::add_point(const Point& p) {
  points_.push_back(p);
  piece_at_.push_back(none);
  return static_cast<std::uint32_t>(points_.size() - 1);
}

std::uint32_t PieceMesh::piece_with(std::uint32_t point) const {
  const auto holds = [&](std::uint32_t piece, std::uint32_t k) {
    const auto& v = pieces_[piece].v;
    return turn(v[k], v[(k + 1) % 3], point) >= 0;
  };
  // A walk towards the point, from where the last one was put. In a mesh that is not Delaunay it may go round
  // in circles; then every piece is asked.
  auto piece = next_number() - 1;
  for (std::size_t steps = 0; steps < pieces_.size(); ++steps) {
    const auto k = !holds(piece, 0) ? 0u : (!holds(piece, 1) ? 1u : (!holds(piece, 2) ? 2u : 3u));
    if (k == 3) return piece;
    if (pieces_[piece].across[k] == none) break;
    piece = pieces_[piece].across[k];
  }
  for (piece = 0; piece + 1 < next_number(); ++piece)
    if (holds(piece, 0) && holds(piece, 1) && holds(piece, 2)) break;
  return piece;
}

std::vector<PieceMesh::Edge> PieceMesh::spokes(std::uint32_t point) const {
  const auto edge_of = [&](std::uint32_t piece) {
    const auto& v = pieces_[piece].v;
    return Edge{piece, v[0] == point ? 0u : (v[1] == point ? 1u : 2u)};
  };
  std::vector<Edge> result;
  const auto start = piece_at_[point];
  auto piece = start;
  do {  // to the left
    const auto e = edge_of(piece);
    result.push_back(e);
    piece = pieces_[piece].across[(e.k + 2) % 3];
  } while (piece != none && piece != start);
  if (piece == start) return result;
  // The point is on the rim: what is to the right is still missing.
  for (piece = pieces_[start].across[result[0].k]; piece != none;) {
    const auto e = edge_of(piece);
    result.push_back(e);
    piece = pieces_[piece].across[e.k];
  }
  return result;
}

PieceMesh::Edge PieceMesh::edge_between(std::uint32_t a, std::uint32_t b) const {
  for (const auto e : spokes(a)) {
    if (to(e) == b) return e;
    if (apex(e) == b) return {e.piece, (e.k + 2) % 3};
  }
  return {};
}

void PieceMesh::set(std::uint32_t piece, std::array<std::uint32_t, 3> v,
                    std::array<std::uint32_t, 3> across) {
  if (piece == next_number()) pieces_.emplace_back();
  pieces_[piece] = {v, across};
  for (const auto point : v) piece_at_[point] = piece;
}

void PieceMesh::redirect(std::uint32_t piece, std::uint32_t old_neighbour, std::uint32_t neighbour) {
  if (piece == none) return;
  auto& across = pieces_[piece].across;
  *std::find(across.begin(), across.end(), old_neighbour) = neighbour;
}

void PieceMesh::split_piece(std::uint32_t piece, std::uint32_t p) {
  const auto [v, across] = pieces_[piece];
  const auto second = next_number();
  const auto third = second + 1;
  set(piece, {v[0], v[1], p}, {across[0], second, third});
  set(second, {v[1], v[2], p}, {across[1], third, piece});
  set(third, {v[2], v[0], p}, {across[2], piece, second});
  redirect(across[1], piece, second);
  redirect(across[2], piece, third);
}

bool PieceMesh::can_split(Edge e, std::uint32_t p) const {
  const auto fits = [&](Edge side) {
    return turn(from(side), p, apex(side)) > 0 && turn(p, to(side), apex(side)) > 0;
  };
  const auto other = other_side(e);
  return fits(e) && (other.piece == none || fits(other));
}

void PieceMesh::split_edge(Edge e, std::uint32_t p) {
  const auto other = other_side(e);
  const auto a = from(e), b = to(e), c = apex(e);
  const auto old = pieces_[e.piece].across;
  const auto t = e.piece;
  const auto t2 = next_number();
  const auto u = other.piece;
  const auto u2 = u == none ? none : t2 + 1;
  set(t, {a, p, c}, {u, t2, old[(e.k + 2) % 3]});
  set(t2, {p, b, c}, {u2, old[(e.k + 1) % 3], t});
  redirect(old[(e.k + 1) % 3], t, t2);
  if (u == none) return;
  const auto d = apex({u, other.k});
  const auto old_u = pieces_[u].across;
  set(u, {p, a, d}, {t, old_u[(other.k + 1) % 3], u2});
  set(u2, {b, p, d}, {t2, u, old_u[(other.k + 2) % 3]});
  redirect(old_u[(other.k + 2) % 3], u, u2);
}

bool PieceMesh::can_flip(Edge e) const {
  const auto other = other_side(e);
  return other.piece != none && turn(from(e), apex(other), apex(e)) > 0 &&
         turn(apex(other), to(e), apex(e)) > 0;
}

void PieceMesh::flip(Edge e) {
  const auto other = other_side(e);
  const auto t = e.piece, u = other.piece;
  const auto a = from(e), b = to(e), c = apex(e), d = apex(other);
  const auto old_t = pieces_[t].across;
  const auto old_u = pieces_[u].across;
  const auto a_d = old_u[(other.k + 1) % 3], d_b = old_u[(other.k + 2) % 3];
  const auto b_c = old_t[(e.k + 1) % 3], c_a = old_t[(e.k + 2) % 3];
  set(t, {a, d, c}, {a_d, u, c_a});
  set(u, {d, b, c}, {d_b, b_c, t});
  redirect(a_d, u, t);
  redirect(b_c, t, u);
}

}  // namespace luxel
