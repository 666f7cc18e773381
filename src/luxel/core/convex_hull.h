// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace luxel {

// The corners of the convex hull of points in a plane, in order of the turn that is_corner accepts (monotone
// chain; Andrew 1979). points: sorted along a direction of the plane, and where equal, along the other; at
// least one. is_corner(a, b, c): whether b stands out from the line from a to c. Linear.
template <typename Point, typename IsCorner>
std::vector<Point> hull_of_sorted(const std::vector<Point>& points, const IsCorner& is_corner) {
  std::vector<Point> hull;
  const auto add_chain = [&](auto first, auto last) {
    const auto before = hull.size();
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= before + 2 && !is_corner(hull[hull.size() - 2], hull.back(), *p)) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // begins the other chain
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace luxel
