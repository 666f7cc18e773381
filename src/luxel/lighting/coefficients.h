// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/photometry/sky_patches.h"
#include "luxel/render/probe_place.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Path of light from a patch of the sky to a point: direct; from a surface that is seen through a window, or
// from the ground; from a surface of the room. The daylight factor is the sum of three such components.
enum class DaylightPath : std::size_t { sky, external, internal };
inline constexpr std::size_t daylight_paths = 3;

// Daylight coefficients (Tregenza and Waters 1983): the illuminance at a point is the sum over patches of the
// sky of coefficient times luminance. In independent replicates, whose spread is the error of anything that
// is computed from them.
struct DaylightCoefficients {
  SkyPatches sky;
  std::size_t points = 0;
  std::uint32_t replicates = 0;
  // [path][(point * replicates + replicate) * sky patches + sky patch], sr: lx per cd/m².
  std::array<std::vector<float>, daylight_paths> of;
  bool knows_openings = false;      // whether windows were found: else external light counts as internal
  std::vector<ProbePoint> origins;  // [point]: where its rays start, off the surface that it lies on
  std::uint64_t rays = 0;

  std::span<const float> row(DaylightPath path, std::size_t point, std::uint32_t replicate) const {
    return std::span(of[static_cast<std::size_t>(path)])
        .subspan((point * replicates + replicate) * sky.size(), sky.size());
  }
};

// A finished run of solve_sampled() under a sky of patches, without lamps. Portals part outside from inside,
// and guide the rays of surfaces and points.
struct DaylightRun {
  const PatchSet& patches;
  const SampleState& state;
  const SampledOptions& options;
  // The patches differ from those of the run in their panes, through which its rays are traced again.
  bool traces_again = false;
};

struct CoefficientOptions {
  std::uint32_t rays = 4096;  // cosine rays per point, and as many towards windows
  std::uint64_t seed = 1;
};

// From the rays of a finished run: its hits are the transport between surfaces, and rays that escaped are
// sorted by the patch of the sky that they met; those through portals are traced again for it (PortalSky).
// The points have rays of their own. Each patch of the sky is one right-hand side of
//
//     H = T + F (rho H),    T: the light straight from the patch,
//
// solved for blocks of patches at a time. Reflectances are luminous ones: those of a surface under the white
// of the sky, so that coloured light between coloured surfaces is approximate.
//
// Throws MismatchError where the state is not of these patches. Empty after the monitor's stop. The same bits
// on any number of threads. Cost: some twenty look-ups per ray of the run and patch of the sky.
DaylightCoefficients find_coefficients(const DaylightRun& run, const Tracer& tracer,
                                       std::span<const ProbePoint> points, const CoefficientOptions& options,
                                       const Context& context);

}  // namespace luxel
