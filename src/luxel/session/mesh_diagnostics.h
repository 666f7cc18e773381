// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/session/scanned_mesh.h"

namespace luxel {

// Finds defective triangles: without area, duplicate, overlapping in one plane, slivers. Appends one
// diagnostic per kind found, with at most `places` positions each.
void find_bad_triangles(const ScannedMesh& mesh, const Context& context, std::size_t places,
                        std::vector<Diagnostic>& diagnostics);

// Finds defects of the connections: T-junctions, open edges, more than two triangles on one edge, windings.
// Tests which --weld would close open edges.
void find_bad_edges(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics);

// Finds defects of materials and units: reflectances that were lowered, an extent that no room has.
void find_bad_numbers(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics);

}  // namespace luxel
