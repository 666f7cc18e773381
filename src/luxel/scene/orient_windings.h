// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "luxel/scene/components.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Triangles that must be flipped so that each connected component faces one way.
struct WindingPlan {
  std::vector<std::uint8_t> turn;     // [clean triangle]
  std::size_t turned = 0;             // triangles
  std::size_t components = 0;         // of which some were turned
  std::size_t closed = 0, lamps = 0;  // of those: made to face outwards; made to follow their lamps
  std::size_t not_orientable = 0;     // components left as they are: no winding makes them consistent
  std::size_t stubborn_lamps = 0;     // lamp triangles that face otherwise than the rest of their component
};

// A component that holds lamps follows them: its side is the one to which most of their area shines. Any
// other closed component faces outwards, by its signed volume. Any other component faces where most of its
// area faced before. Lamps are never flipped, because their side is where they emit; those that face against
// their component stay so and are counted. Where equal areas face both ways, the component's first triangle
// decides.
WindingPlan plan_windings(const Scene& scene, std::span<const Vec3> places,
                          std::span<const CleanTriangle> triangles, const Components& components);

struct OrientReport {
  WindingPlan plan;
  std::size_t all_components = 0;

  // Describes the changes as a sentence.
  std::string as_text() const;
};

// Flips the scene's triangles as planned; those that lie exactly on a flipped one are flipped with it, unless
// they are lamps. About 2 s per million triangles.
OrientReport orient_windings(Scene& scene);

}  // namespace luxel
