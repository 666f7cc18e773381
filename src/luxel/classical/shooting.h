// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/classical/deposits.h"
#include "luxel/classical/fixed_point.h"
#include "luxel/core/context.h"
#include "luxel/core/progress.h"
#include "luxel/lamps/side_power.h"
#include "luxel/lamps/sky_box.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The result of one shot, in units of `scale`. Band by band, shot is the sum of arrived, escaped and
// absorbed, exactly. Rays of the sky count only where they met a side that takes part.
struct Arrival {
  FixedPoint scale;
  std::vector<SideId> side;            // that were met, rising
  std::vector<std::int64_t> arrived;   // [entry of side][band]
  std::vector<std::int64_t> shot;      // [band]
  std::vector<std::int64_t> from_sky;  // [band]: the part of `shot` that the sky sent
  std::vector<std::int64_t> escaped;   // [band]: met nothing
  std::vector<std::int64_t> absorbed;  // [material][band]: met the back of a one-sided material
  std::uint64_t rays = 0;
  double fraction = 1.0;  // of the rays asked for; below 1 only when the monitor stopped the shot. Divide by
                          // it for the whole.
};

struct ShootingOptions {
  std::uint64_t rays = 1'000'000;
  std::uint64_t seed = 1;
  std::uint32_t step = 0;         // different steps use different random numbers
  std::uint64_t batch = 1 << 20;  // rays between two polls of the monitor
};

// The transport operator as one Monte Carlo estimate: power that leaves each side -> power that arrives at
// each side. Rays in proportion to power, so that every ray carries the same quantum (the sum over bands),
// stratified over sides by one random offset; each starts at a uniform point in a cosine direction and gives
// its power, all bands at once, to the nearest side it meets. Unbiased. Variance of a side's arrival: quantum
// times arrival (a Poisson count), at most.
//
// The result does not depend on the number of threads or processes, which share the rays; the monitor of the
// first process counts. Cost: one nearest hit per ray, and bands counters added to; little for a side that
// nothing leaves and nothing meets. Memory: 8 bytes per side and band, and a private copy a thread where that
// pays (Deposits). Method: listing 2 of the founding course paper; Neumann 1995; Bekaert 1999, chapter 6.
class Shooter {
 public:
  // Keeps references. The context must outlive this.
  Shooter(const PatchSet& patches, const Tracer& tracer, const Context& context);

  Arrival shoot(const SidePower& leaving, const ShootingOptions& options, const Monitor& monitor = {});

 private:
  const PatchSet& patches_;
  const Tracer& tracer_;
  const Context& context_;
  Deposits arrived_;   // at sides
  Deposits absorbed_;  // by materials
  Deposits whole_;     // escaped, shot, and from the sky
  std::optional<SkyBox> sky_;
  std::vector<float> sky_ratio_;  // [sky patch][band]: radiance over its mean; empty where the sky is even
};

// One shot.
Arrival shoot(const PatchSet& patches, const Tracer& tracer, const SidePower& leaving,
              const ShootingOptions& options, const Context& context = {});

}  // namespace luxel
