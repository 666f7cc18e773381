// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Patches after a cut.
struct Cut {
  const PatchSet& parts;
  const Tracer& tracer;                   // of the parts
  std::span<const std::uint32_t> parent;  // [part]: the whole that it is, or is a part of
};

// The light of parts before any ray of theirs: each has that of its whole.
Solution inherited_light(const Solution& wholes, const Cut& cut);

// Rays of each side for its light to be as accurate as is allowed, [side of parts]; 0 where the patch was not
// cut. weight: [side of wholes], what a squared error of irradiance, (W/m²)², adds to the squared error of
// the whole, of which each side has the fraction `allowed`. light: before these rays, from which the noise of
// one ray is guessed as the light itself; so numbers do not follow the noise that they bring.
std::vector<std::uint32_t> rays_of_parts(const Cut& cut, const Solution& light,
                                         std::span<const double> weight, double allowed);

// Replaces each of the lights, on sides that have rays, by what rays of its own find: direct light, by as
// many shadow rays, and the light that the surfaces they meet send on according to that light as it was. One
// bounce of a known light, so the cost is that of these rays alone. Standard errors stay those of the wholes.
// rays: [side], of each light, 0 or powers of two, at least 4. Returns the number of rays of all; nothing,
// and the lights stay, if the monitor stops the work. Processes divide the rays; the same bits on any number
// of threads and processes.
std::optional<std::uint64_t> gather_on_parts(const Cut& cut, std::span<const std::uint32_t> rays,
                                             const SampledOptions& options, std::span<Solution* const> lights,
                                             const Context& context);

}  // namespace luxel
