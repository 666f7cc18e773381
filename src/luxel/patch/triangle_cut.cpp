// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/triangle_cut.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "luxel/core/none.h"

namespace luxel {
namespace {

// An edge is flipped where the angles opposite it sum to more than half a turn by at least this, as a sine:
// flips then end in spite of rounding.
constexpr double better_by = 1e-9;

FragmentMesh::Ends sorted(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

TriangleCut::TriangleCut(const FlatTriangle& triangle, double tolerance)
    : triangle_(triangle), tolerance_(tolerance) {
  const auto n = static_cast<double>(FragmentMesh::grid);
  const auto first = triangle.corner[1] - triangle.corner[0];
  const auto length = glm::length(first);
  const auto second = triangle.corner[2] - triangle.corner[0];
  step_[0] = {length / n, 0.0};
  step_[1] = {glm::dot(second, first) / length / n, triangle.inside(0, triangle.corner[2]) / n};
}

std::uint32_t TriangleCut::add_on_edge(std::size_t k, double fraction) {
  constexpr auto n = FragmentMesh::grid;
  const auto steps = std::clamp<std::int64_t>(std::llround(fraction * static_cast<double>(n)), 1, n - 1);
  const FragmentMesh::Point place = k == 0   ? FragmentMesh::Point{steps, 0}
                                    : k == 1 ? FragmentMesh::Point{n - steps, steps}
                                             : FragmentMesh::Point{0, n - steps};
  const auto point = mesh_.add_point(place);
  const auto edge = mesh_.edge_between(last_on_edge_[k], static_cast<std::uint32_t>((k + 1) % 3));
  if (!mesh_.can_split(edge, point)) {  // it coincides with the previous point
    mesh_.take_back();
    return last_on_edge_[k];
  }
  const auto from = mesh_.from(edge), to = mesh_.to(edge), apex = mesh_.apex(edge);
  split_edge(edge, point);
  legalize({sorted(apex, from), sorted(apex, to)});
  return last_on_edge_[k] = point;
}

std::uint32_t TriangleCut::add_inside(const Vec3d& place) {
  constexpr auto n = FragmentMesh::grid;
  const auto steps = [](double fraction) { return std::llround(fraction * static_cast<double>(n)); };
  const auto fraction = [&](std::size_t edge, std::size_t corner) {
    return triangle_.inside(edge, place) / triangle_.inside(edge, triangle_.corner[corner]);
  };
  FragmentMesh::Point p;
  p.x = std::clamp<std::int64_t>(steps(fraction(2, 1)), 1, n - 2);
  p.y = std::clamp<std::int64_t>(steps(fraction(0, 2)), 1, n - 1 - p.x);
  const auto point = mesh_.add_point(p);
  const auto fragment = mesh_.fragment_with(point);
  const auto corners = mesh_.fragments()[fragment].v;
  for (const auto c : corners)
    if (distance(point, c) <= tolerance_) {
      mesh_.take_back();
      return c;
    }
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Edge e{fragment, k};
    const bool is_on_it = mesh_.turn(mesh_.from(e), mesh_.to(e), point) == 0;
    const bool is_near_line =
        is_line(e) && distance_to_segment(point, mesh_.from(e), mesh_.to(e)) <= tolerance_;
    if (!(is_on_it || is_near_line) || !mesh_.can_split(e, point)) continue;
    split_edge(e, point);
    std::vector<Ends> around;
    for (const auto s : mesh_.spokes(point)) around.push_back(sorted(mesh_.to(s), mesh_.apex(s)));
    legalize(std::move(around));
    return point;
  }
  mesh_.split_fragment(fragment, point);
  legalize({sorted(corners[0], corners[1]), sorted(corners[1], corners[2]), sorted(corners[2], corners[0])});
  return point;
}

void TriangleCut::add_line(std::uint32_t a, std::uint32_t b, std::uint32_t tag) {
  // Split at points and crossings: a stack of the remaining parts, the next one last. Each is shorter than
  // the part it comes from; if rounding causes a cycle anyway, the rest of the line is dropped.
  std::vector<Ends> parts{{a, b}};
  for (std::size_t steps = 0; !parts.empty() && steps < 100 + 4 * mesh_.points().size(); ++steps) {
    const auto [from, to] = parts.back();
    parts.pop_back();
    if (from == to) continue;
    const auto way = advance(from, to);
    if (way == to) {
      auto& tags = tags_[sorted(from, to)];
      if (std::find(tags.begin(), tags.end(), tag) == tags.end()) tags.push_back(tag);
    } else if (way != none) {
      parts.emplace_back(way, to);
      parts.emplace_back(from, way);
    }
  }
}

void TriangleCut::improve() {
  std::vector<Ends> all;
  for (const auto& fragment : mesh_.fragments())
    for (std::uint32_t k = 0; k < 3; ++k) all.push_back(sorted(fragment.v[k], fragment.v[(k + 1) % 3]));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  legalize(std::move(all));
}

Vec3d TriangleCut::place(std::uint32_t point) const {
  const auto& p = mesh_.points()[point];
  const auto n = static_cast<double>(FragmentMesh::grid);
  const auto& c = triangle_.corner;
  return c[0] + static_cast<double>(p.x) / n * (c[1] - c[0]) + static_cast<double>(p.y) / n * (c[2] - c[0]);
}

TriangleCut::PlanePoint TriangleCut::in_plane(std::uint32_t point) const {
  const auto& p = mesh_.points()[point];
  const auto x = static_cast<double>(p.x);
  const auto y = static_cast<double>(p.y);
  return {x * step_[0].x + y * step_[1].x, y * step_[1].y};
}

double TriangleCut::distance(std::uint32_t a, std::uint32_t b) const {
  const auto p = in_plane(a);
  const auto q = in_plane(b);
  return std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
}

double TriangleCut::distance_to_segment(std::uint32_t p, std::uint32_t a, std::uint32_t b) const {
  const auto s = in_plane(a);
  const auto e = in_plane(b);
  const auto x = in_plane(p);
  const auto dx = e.x - s.x, dy = e.y - s.y;
  const auto t = std::clamp(((x.x - s.x) * dx + (x.y - s.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const auto rx = x.x - s.x - t * dx, ry = x.y - s.y - t * dy;
  return std::sqrt(rx * rx + ry * ry);
}

bool TriangleCut::is_on_the_way(std::uint32_t c, std::uint32_t a, std::uint32_t b) const {
  if (c == a || c == b || distance_to_segment(c, a, b) > tolerance_) return false;
  const auto whole = distance(a, b);
  return distance(a, c) < whole && distance(c, b) < whole;
}

bool TriangleCut::is_line(Edge e) const { return tags_.count(sorted(mesh_.from(e), mesh_.to(e))) > 0; }

void TriangleCut::move_tags(Edge e, std::uint32_t point) {
  const auto found = tags_.find(sorted(mesh_.from(e), mesh_.to(e)));
  if (found == tags_.end()) return;
  const auto moved = std::move(found->second);
  tags_.erase(found);
  for (const auto end : {mesh_.from(e), mesh_.to(e)}) {
    auto& tags = tags_[sorted(end, point)];
    for (const auto tag : moved)
      if (std::find(tags.begin(), tags.end(), tag) == tags.end()) tags.push_back(tag);
  }
}

void TriangleCut::split_edge(Edge e, std::uint32_t point) {
  move_tags(e, point);
  mesh_.split_edge(e, point);
}

// Returns whether the angles opposite the edge sum to more than half a turn.
bool TriangleCut::would_better(Edge e) const {
  const auto a = in_plane(mesh_.from(e));
  const auto b = in_plane(mesh_.to(e));
  const auto angle = [&](const PlanePoint& apex) {
    const auto ux = a.x - apex.x, uy = a.y - apex.y, vx = b.x - apex.x, vy = b.y - apex.y;
    const auto scale = std::sqrt((ux * ux + uy * uy) * (vx * vx + vy * vy));
    return std::pair((ux * vx + uy * vy) / scale, std::fabs(ux * vy - uy * vx) / scale);  // cosine, sine
  };
  const auto [c, s] = angle(in_plane(mesh_.apex(e)));
  const auto [c2, s2] = angle(in_plane(mesh_.apex(mesh_.other_side(e))));
  return s * c2 + c * s2 < -better_by;
}

void TriangleCut::legalize(std::vector<Ends> open) {
  for (std::size_t steps = 100 + 20 * (open.size() + mesh_.fragments().size()); !open.empty() && steps > 0;
       --steps) {
    const auto [a, b] = open.back();
    open.pop_back();
    const auto e = mesh_.edge_between(a, b);
    if (e.fragment == none || is_line(e) || !mesh_.can_flip(e) || !would_better(e)) continue;
    const auto c = mesh_.apex(e);
    const auto d = mesh_.apex(mesh_.other_side(e));
    mesh_.flip(e);
    for (const auto end : {a, b})
      for (const auto apex : {c, d}) open.push_back(sorted(end, apex));
  }
}

std::uint32_t TriangleCut::advance(std::uint32_t a, std::uint32_t b) {
  const auto spokes = mesh_.spokes(a);
  for (const auto s : spokes)
    if (mesh_.to(s) == b || mesh_.apex(s) == b) return b;
  for (const auto s : spokes)
    for (const auto c : {mesh_.to(s), mesh_.apex(s)})
      if (is_on_the_way(c, a, b)) return c;
  const auto faces_it = [&](Edge s) {
    return mesh_.turn(a, mesh_.to(s), b) > 0 && mesh_.turn(a, b, mesh_.apex(s)) > 0;
  };
  const auto first = std::find_if(spokes.begin(), spokes.end(), faces_it);
  if (first == spokes.end()) return none;

  // From fragment to fragment: each crossed edge has a to its left and b to its right.
  std::vector<Ends> crossed;
  for (Edge e{first->fragment, (first->k + 1) % 3};;) {
    const auto beyond = mesh_.other_side(e);
    if (beyond.fragment == none) return none;
    const auto apex = mesh_.apex(beyond);
    if (is_line(e)) {
      // A line that passes within the tolerance of this one's end is bent to run through it.
      if (crossed.empty() && distance_to_segment(a, mesh_.from(e), mesh_.to(e)) <= tolerance_) {
        move_tags(e, a);
      } else if (apex == b && distance_to_segment(b, mesh_.from(e), mesh_.to(e)) <= tolerance_) {
        move_tags(e, b);
      } else {
        return cross(e, a, b);
      }
    }
    crossed.push_back(sorted(mesh_.from(e), mesh_.to(e)));
    if (apex == b) break;
    if (is_on_the_way(apex, a, b)) return apex;
    const auto side = mesh_.turn(a, b, apex);
    if (side == 0) return none;
    e = {beyond.fragment, (beyond.k + (side > 0 ? 1 : 2)) % 3};
  }
  return clear_way(a, b, std::move(crossed)) ? b : none;
}

std::uint32_t TriangleCut::cross(Edge e, std::uint32_t a, std::uint32_t b) {
  const auto p = mesh_.from(e);
  const auto q = mesh_.to(e);
  const auto before = static_cast<double>(mesh_.turn(p, q, a));
  const auto fraction = before / (before - static_cast<double>(mesh_.turn(p, q, b)));
  const auto start = mesh_.points()[a];
  const auto end = mesh_.points()[b];
  const auto between = [fraction](std::int64_t s, std::int64_t t) {
    return s + std::llround(fraction * static_cast<double>(t - s));
  };
  const auto x = mesh_.add_point({between(start.x, end.x), between(start.y, end.y)});
  const auto to_p = distance(x, p);
  const auto to_q = distance(x, q);
  if (std::min(to_p, to_q) > tolerance_ && mesh_.can_split(e, x)) {
    split_edge(e, x);
    return x;
  }
  mesh_.take_back();
  const auto nearest = to_p <= to_q ? p : q;
  const auto whole = distance(a, b);
  return distance(a, nearest) < whole && distance(nearest, b) < whole ? nearest : none;
}

bool TriangleCut::clear_way(std::uint32_t a, std::uint32_t b, std::vector<Ends> crossed) {
  std::deque<Ends> open(crossed.begin(), crossed.end());
  const auto crosses = [&](std::uint32_t c, std::uint32_t d) {
    if (c == a || c == b || d == a || d == b) return false;
    return (mesh_.turn(a, b, c) > 0) != (mesh_.turn(a, b, d) > 0);
  };
  for (std::size_t steps = 100 + 4 * open.size() * open.size(); !open.empty() && steps > 0; --steps) {
    const auto ends = open.front();
    open.pop_front();
    const auto e = mesh_.edge_between(ends.first, ends.second);
    if (!mesh_.can_flip(e)) {
      open.push_back(ends);
      continue;
    }
    const auto c = mesh_.apex(e);
    const auto d = mesh_.apex(mesh_.other_side(e));
    mesh_.flip(e);
    if (crosses(c, d)) open.push_back(sorted(c, d));
  }
  return open.empty();
}

}  // namespace luxel
