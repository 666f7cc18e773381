// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "luxel/session/diagnose.h"

namespace luxel {

// The scene cut up by what is the matter: what is well, and one part a kind of diagnostic. Faces take the
// gravest kind that names them; edges are drawn as thin rods, a six-hundredth of the scene's diagonal thick.
struct FaultPart {
  std::optional<DiagnosticKind> kind;                   // nothing: what is well
  std::vector<Vec3> positions;                          // m, counted from the scene's origin
  std::vector<std::array<std::uint32_t, 3>> triangles;  // into positions
};

// Kinds that name edges leave the faces beside them as they are. Linear.
std::vector<FaultPart> fault_parts(const Scene& scene, const CheckReport& report);

}  // namespace luxel
