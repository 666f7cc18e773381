// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/portal_sky.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr std::size_t grain = 64;  // receivers per chunk
// Minimum number of samples per replicate of each receiver; a run takes fewer where the closed form of a
// window's light needs no correction by samples.
constexpr std::uint32_t min_samples = 16;

}  // namespace

PortalSky::PortalSky(const Sampling& sampling, const Context& context)
    : replicates_(sampling.hits().replicates()), seen_(sampling.hits().sides().size()) {
  const auto& sides = sampling.hits().sides();
  const auto& direct = sampling.direct();
  if (std::max<std::size_t>(replicates_, sampling.hits().sky_patches()) >
      std::numeric_limits<std::uint16_t>::max())
    throw InputError("daylight coefficients are computed for at most 65,535 patches of the sky");
  context.for_chunks(seen_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto s = begin; s < end; ++s) {
      auto& seen = seen_[s];
      auto all = direct.samples_per_receiver()[s];
      auto rounds = direct.doublings_per_receiver()[s];
      for (; rounds > 0 && all < min_samples; ++rounds) all *= 2;
      for (std::uint32_t round = 0; round < rounds; ++round) {
        // Each round has as many samples as all before it; the first two have the same number.
        const auto samples = all >> std::min(rounds - round, rounds - 1);
        for (const auto& sample :
             sampling.direct_light().sky_samples(sides.side[s], sides.position[s], round, samples))
          seen.push_back({static_cast<std::uint16_t>(sample.sky_patch),
                          static_cast<std::uint16_t>(sample.replicate),
                          static_cast<float>(sample.irradiance / all)});
      }
      std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
        return std::tie(a.sky_patch, a.replicate) < std::tie(b.sky_patch, b.replicate);
      });
      std::size_t kept = 0;
      for (const auto& sample : seen) {
        const bool is_same = kept > 0 && seen[kept - 1].sky_patch == sample.sky_patch &&
                             seen[kept - 1].replicate == sample.replicate;
        if (is_same)
          seen[kept - 1].irradiance += sample.irradiance;
        else
          seen[kept++] = sample;
      }
      seen.resize(kept);
      seen.shrink_to_fit();
    }
  });
}

std::vector<std::vector<float>> PortalSky::irradiance(std::size_t first, std::span<const float> radiance,
                                                      const Context& context) const {
  const auto columns = radiance.size();
  std::vector<std::vector<float>> light(replicates_, std::vector<float>(seen_.size() * columns, 0.0f));
  context.for_chunks(seen_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto s = begin; s < end; ++s) {
      auto at = std::partition_point(seen_[s].begin(), seen_[s].end(),
                                     [&](const Seen& seen) { return seen.sky_patch < first; });
      for (; at != seen_[s].end() && at->sky_patch < first + columns; ++at)
        light[at->replicate][s * columns + at->sky_patch - first] =
            at->irradiance * radiance[at->sky_patch - first];
    }
  });
  return light;
}

}  // namespace luxel
