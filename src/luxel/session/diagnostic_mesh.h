// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "luxel/session/diagnose.h"

namespace luxel {

// The scene divided by diagnostics: a part without defects, and one per kind. Faces take the most severe kind
// that lists them; edges are drawn as thin rods, a six-hundredth of the scene's diagonal thick.
struct FaultPart {
  std::optional<DiagnosticKind> kind;                   // nothing: the part without defects
  std::vector<Vec3> positions;                          // m, counted from the scene's origin
  std::vector<std::array<std::uint32_t, 3>> triangles;  // into positions
};

// Diagnostics of edges do not affect the faces beside them. Linear cost.
std::vector<FaultPart> fault_parts(const Scene& scene, const CheckReport& report);

}  // namespace luxel
