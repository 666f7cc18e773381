// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/session/openings.h"

namespace luxel {

// Estimate, by a few thousand paths, of where light goes. Fractions are relative to the light at their start.
struct LightWalks {
  enum class From { lamps, inside, nowhere };
  From from = From::nowhere;
  std::size_t paths = 0;
  std::uint64_t rays = 0;
  double escaped = 0.0;        // left the scene, at once or after reflections
  double escaped_error = 0.0;  // its standard error
  double escaped_at_once = 0.0;
  double lost_at_backs = 0.0;     // met the back of a one-sided material
  double back_hits = 0.0;         // fraction of all hits that were on backs, of any material
  std::vector<LostRay> lost;      // weights add up to `escaped`
  std::vector<double> back_loss;  // [material]; adds up to lost_at_backs
  float near = 0.0f;              // m, three hundredths of the scene's diagonal
  std::vector<std::size_t>
      got_away;  // [material]: paths from it that went farther than `near` from their start
  std::vector<std::uint8_t> is_met;  // [side], see SideId: light of a lamp fell on it
  std::vector<std::size_t> set_out;  // [material]: paths from it
};

// With lamps: paths start at them by power, continue from surface to surface by cosine, and carry luminance,
// reduced by the reflectances. Without: straight rays from points inside, that is, places in the scene's box
// from which most directions meet a surface; no rays where there is no such place. The same answer on any
// number of threads. paths: about 10 µs each.
LightWalks walk_light(const PatchSet& patches, const Tracer& tracer, std::size_t paths, std::uint64_t seed,
                      const Context& context);

}  // namespace luxel
