// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/session/scanned_mesh.h"

namespace luxel {

// What is the matter with the triangles themselves: no area, one upon another, slivers. Appends one
// diagnostic a kind that there is; `places` of each are told.
void find_bad_triangles(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics);

// What is the matter with how they hang together: T-junctions, open edges, more than two triangles on one
// edge, windings. Says which --weld would close open edges, by trying.
void find_bad_edges(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics);

// What is the matter with materials and units: reflectances that were lowered, an extent that no room has.
void find_bad_numbers(const ScannedMesh& mesh, std::size_t places, std::vector<Diagnostic>& diagnostics);

}  // namespace luxel
