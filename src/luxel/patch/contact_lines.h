// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/none.h"
#include "luxel/core/vector.h"
#include "luxel/scene/clean_triangles.h"

namespace luxel {

// Points nearer than this to each other are treated as coincident: in units of coordinate_rounding(), two
// units in the last place.
inline constexpr double slack_roundings = 4.0;

// A straight fragment along which another triangle touches a triangle or passes through it.
struct ContactLine {
  std::uint32_t on = 0;         // the triangle that it lies on: an index into those given
  std::uint32_t other = 0;      // the one that touches it
  std::array<Vec3d, 2> ends{};  // in the plane of `on`, m
  std::array<std::uint32_t, 2> vertices{none, none};  // of the other one, where an end is at its corner
  std::array<Vec3d, 2> into{};  // unit, at right angles to the line: where the other one goes. The second is
                                // zero where it ends here
};

// Finds all lines along which triangles touch or pass through each other, sorted by (on, other):
// - the line in which a triangle passes through another one;
// - an edge of a triangle that lies on another one, or no farther from it than `gap`;
// - where a triangle lies flat on another one, the edges at which its own surface ends: the boundary of a
//   carpet. The direction `into` is then along the normal of `on`, to both sides where the two coincide.
//
// Leaves out lines that separate no light: a line on an edge of `on` that both share, or at which the surface
// of `on` ends or bends by more than about 85 degrees; and lines shorter than rounding.
//
// Throws InputError where there are more than `most`. gap: m; at most a hundredth of the shortest edge of
// both, at least two units in the last place of their coordinates. corners index into positions; triangles
// have area. The same bits for any number of threads. Cost: n log n, and about 0.3 us per pair of near
// triangles: two seconds of processor time for a million triangles of a mesh.
std::vector<ContactLine> find_contact_lines(const std::vector<CleanTriangle>& triangles,
                                            const std::vector<Vec3>& positions, double gap, std::size_t most,
                                            const Context& context);

// Throws the InputError of a scene whose surfaces touch or pierce one another in more places than the budget
// of PatchOptions::max_contacts.
[[noreturn]] void refuse_contacts(std::size_t most);

}  // namespace luxel
