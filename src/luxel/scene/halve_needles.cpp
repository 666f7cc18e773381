// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/halve_needles.h"

#include <algorithm>
#include <array>
#include <deque>

#include "luxel/core/none.h"
#include "luxel/core/vector.h"

namespace luxel {
namespace {

using Edge = FragmentMesh::Edge;

glm::dvec2 place(const FragmentMesh& mesh, std::uint32_t point) {
  const auto& p = mesh.points()[point];
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}
double length(const FragmentMesh& mesh, Edge e) {
  return glm::distance(place(mesh, mesh.from(e)), place(mesh, mesh.to(e)));
}
double height(const FragmentMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const auto p = place(mesh, a), q = place(mesh, b), r = place(mesh, c);
  const auto longest = std::max({glm::distance(p, q), glm::distance(q, r), glm::distance(r, p)});
  return static_cast<double>(mesh.turn(a, b, c)) / longest;
}

Edge longest_edge(const FragmentMesh& mesh, std::uint32_t fragment) {
  Edge longest{fragment, 0};
  for (const std::uint32_t k : {1u, 2u})
    if (length(mesh, {fragment, k}) > length(mesh, longest)) longest.k = k;
  return longest;
}

// Returns whether the angles opposite an edge are more than 180 degrees together, by more than rounding.
bool is_to_flip(const FragmentMesh& mesh, Edge e, double min_height) {
  if (!mesh.can_flip(e)) return false;
  const auto a = mesh.from(e), b = mesh.to(e), c = mesh.apex(e), d = mesh.apex(mesh.other_side(e));
  const auto to = [&](std::uint32_t from, std::uint32_t end) { return place(mesh, end) - place(mesh, from); };
  const auto sine = static_cast<double>(mesh.turn(a, b, c)) * glm::dot(to(d, b), to(d, a)) +
                    glm::dot(to(c, a), to(c, b)) * static_cast<double>(mesh.turn(b, a, d));
  const auto rounding =
      1e-10 * glm::length(to(c, a)) * glm::length(to(c, b)) * glm::length(to(d, a)) * glm::length(to(d, b));
  return sine < -rounding && height(mesh, a, d, c) >= min_height && height(mesh, d, b, c) >= min_height;
}

// Makes the edges of these fragments Delaunay, and those that this puts in question.
void legalise(FragmentMesh& mesh, std::deque<std::uint32_t> suspects, double min_height) {
  // Each flip lowers the mesh lifted onto a paraboloid, so that they end; the limit is for rounding.
  constexpr std::size_t flips_per_fragment = 100;
  auto left = flips_per_fragment * (mesh.fragments().size() + suspects.size());
  while (!suspects.empty() && left > 0) {
    const auto fragment = suspects.front();
    suspects.pop_front();
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Edge e{fragment, k};
      if (!is_to_flip(mesh, e, min_height)) continue;
      suspects.push_back(fragment);
      suspects.push_back(mesh.other_side(e).fragment);
      mesh.flip(e);
      --left;
      break;
    }
  }
}

// Halves an edge, unless the grid has no point between its ends.
bool halve(FragmentMesh& mesh, Edge e, double min_height) {
  const auto a = mesh.points()[mesh.from(e)], b = mesh.points()[mesh.to(e)];
  const auto middle = mesh.add_point({(a.x + b.x) / 2, (a.y + b.y) / 2});
  if (!mesh.can_split(e, middle)) {
    mesh.take_back();
    return false;
  }
  std::deque<std::uint32_t> suspects{e.fragment};
  if (const auto other = mesh.other_side(e).fragment; other != none) suspects.push_back(other);
  const auto before = mesh.fragments().size();
  mesh.split_edge(e, middle);
  for (auto f = before; f < mesh.fragments().size(); ++f) suspects.push_back(static_cast<std::uint32_t>(f));
  legalise(mesh, std::move(suspects), min_height);
  return true;
}

// The last edge of the path of longest edges from a fragment; they become longer, so that it ends.
Edge end_of_path(const FragmentMesh& mesh, std::uint32_t fragment) {
  auto e = longest_edge(mesh, fragment);
  for (auto other = mesh.other_side(e); other.fragment != none; other = mesh.other_side(e)) {
    const auto longest = longest_edge(mesh, other.fragment);
    if (length(mesh, longest) <= length(mesh, e)) break;
    e = longest;
  }
  return e;
}

}  // namespace

void make_delaunay(FragmentMesh& mesh, double min_height) {
  std::deque<std::uint32_t> all;
  for (std::uint32_t f = 0; f < mesh.fragments().size(); ++f) all.push_back(f);
  legalise(mesh, std::move(all), min_height);
}

bool is_needle_inside(const FragmentMesh& mesh, std::uint32_t fragment, const NeedleLimits& limits) {
  constexpr double long_side = 0.25;  // of the longest
  const auto longest = length(mesh, longest_edge(mesh, fragment));
  const auto& v = mesh.fragments()[fragment].v;
  if (longest <= limits.longest || longest <= limits.slenderness * height(mesh, v[0], v[1], v[2]))
    return false;
  int inside = 0;
  for (std::uint32_t k = 0; k < 3; ++k)
    if (mesh.fragments()[fragment].across[k] != none && length(mesh, {fragment, k}) > long_side * longest)
      ++inside;
  return inside >= 2;
}

std::vector<FragmentMesh::Ends> halve_needles(FragmentMesh& mesh, const NeedleLimits& limits) {
  std::vector<FragmentMesh::Ends> halved;
  for (bool any = true; any;) {
    any = false;
    for (std::uint32_t f = 0; f < mesh.fragments().size(); ++f)
      while (halved.size() < limits.points && is_needle_inside(mesh, f, limits)) {
        const auto e = end_of_path(mesh, f);
        const FragmentMesh::Ends ends(mesh.from(e), mesh.to(e));
        if (!halve(mesh, e, limits.min_height)) break;
        halved.push_back(ends);
        any = true;
      }
  }
  return halved;
}

}  // namespace luxel
