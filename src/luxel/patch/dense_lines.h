// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/scene/clean_triangles.h"

namespace luxel {

// If cuts along contact lines are expected to add more patches than `max_added`: leaves out the lines on the
// triangles where these are densest, so that the others add about a quarter of it; edges of shadows stay.
// Leaves of a tree that pass through each other stay whole then, and a house between the trees is cut.
// Returns the number of triangles that lost lines.
//
// A triangle of area A with n lines of total length L, cut into patches of edge length e, is expected to come
// apart into 2 (n + L / e + c) patches more, c = min(L² / (pi A), n (n - 1) / 2): random segments in a plane
// cross so often. Density is L / A. Triangles of equal density are kept or left together.
//
// lines: sorted by triangle. max_edge: m; 0 for no limit. Cost: n log n of the triangles with lines.
std::size_t leave_out_dense_lines(std::vector<ContactLine>& lines,
                                  const std::vector<CleanTriangle>& triangles,
                                  const std::vector<Vec3>& positions, double max_edge, double max_added);

}  // namespace luxel
