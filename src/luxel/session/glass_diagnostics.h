// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/session/scanned_mesh.h"

namespace luxel {

// Finds defects of panes of glass: materials that are called glass and are opaque; sheets within a
// millimetre of each other, which absorb twice; and, where there is a sky or a sun, panes that let all light
// pass.
void find_bad_glass(const ScannedMesh& mesh, const Context& context, std::size_t places,
                    std::vector<Diagnostic>& diagnostics);

}  // namespace luxel
