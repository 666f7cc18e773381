// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sky_not_found.h"

#include <algorithm>
#include <numeric>

namespace luxel {
namespace {

double squared(double x) { return x * x; }

// body(receiver, element met) for the first rays of all receivers.
template <typename Body>
void for_first_rays(const HitStore& hits, const Workers& workers, Body body) {
  workers.for_chunks(hits.blocks(), 1, [&](std::size_t begin, std::size_t end, int) {
    for (auto block = begin; block < end; ++block)
      for (std::uint32_t r = 0; r < hits.replicates(); ++r) hits.for_each_first_hit(r, block, body);
  });
}

double sum_over(std::span<const float> numbers, std::uint32_t begin, std::uint32_t end) {
  return std::accumulate(numbers.begin() + begin, numbers.begin() + end, 0.0);
}

}  // namespace

SkyNotFound::SkyNotFound(const PatchSet& patches, const HitStore& hits, std::span<const std::uint32_t> units,
                         const Workers& workers)
    : patches_(patches), hits_(hits), units_(units.begin(), units.end()) {
  if (!patches.has_sky() || units.size() < 2) return;
  const auto receivers = hits.sides().size();
  std::vector<float> rays(receivers, 0.0f), found(receivers, 0.0f), nearby(receivers, 0.0f);
  for_first_rays(hits, workers, [&](std::uint32_t receiver, std::uint32_t element) {
    rays[receiver] += 1.0f;
    found[receiver] += element == hits.escaped() ? 1.0f : 0.0f;
  });
  hits.all_gather_receivers(rays, 1);
  hits.all_gather_receivers(found, 1);
  std::vector<float> found_by_unit(receivers);  // fraction of the rays of the receiver's unit
  for (std::size_t u = 0; u + 1 < units.size(); ++u) {
    const auto of_unit = sum_over(rays, units[u], units[u + 1]);
    const auto fraction = of_unit > 0.0 ? sum_over(found, units[u], units[u + 1]) / of_unit : 0.0;
    std::fill(found_by_unit.begin() + units[u], found_by_unit.begin() + units[u + 1],
              static_cast<float>(fraction));
  }
  for_first_rays(hits, workers, [&](std::uint32_t receiver, std::uint32_t element) {
    nearby[receiver] += element < receivers         ? found_by_unit[element]
                        : element == hits.escaped() ? 1.0f
                                                    : 0.0f;
  });
  hits.all_gather_receivers(nearby, 1);
  // No ray of the whole scene may have met the sky: half a ray of all of them.
  const auto least = 0.5 / (1.0 + std::accumulate(rays.begin(), rays.end(), 0.0));
  for (std::size_t u = 0; u + 1 < units.size(); ++u) {
    const auto of_unit = sum_over(rays, units[u], units[u + 1]);
    expected_.push_back(least + (of_unit > 0.0 ? sum_over(nearby, units[u], units[u + 1]) / of_unit : 0.0));
  }
}

std::vector<float> SkyNotFound::variance() const {
  const auto bands = patches_.band_count();
  std::vector<float> variance(hits_.sides().size() * bands, 0.0f);
  for (std::size_t u = 0; u < expected_.size(); ++u) {
    const auto of_unit = hits_.rays_per_receiver().subspan(units_[u], units_[u + 1] - units_[u]);
    const auto rays = hits_.replicates() * std::accumulate(of_unit.begin(), of_unit.end(), 0.0);
    if (rays == 0.0) continue;
    const auto q = expected_[u];
    const auto of_fraction = q / (rays * (1.0 + 2.0 * q * rays));
    for (auto s = units_[u]; s < units_[u + 1]; ++s)
      for (std::size_t b = 0; b < bands; ++b)
        variance[s * bands + b] = static_cast<float>(of_fraction * squared(patches_.sky_radiosity(b)));
  }
  return variance;
}

}  // namespace luxel
