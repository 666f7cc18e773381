// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampled_energy.h"

#include "luxel/classical/stochastic_jacobi.h"

namespace luxel {

EnergyAccount energy_of(const PatchSet& patches, const SampledOperator& transport,
                        const std::vector<float>& irradiance, const Workers& workers) {
  const auto& hits = transport.hits();
  const auto& sides = hits.sides();
  const auto bands = patches.band_count();
  const auto materials = patches.materials.size();
  // What a ray of the receiver carries in one replicate, W, [receiver][band].
  std::vector<double> carried(sides.size() * bands);
  std::vector<double> area_per_ray(sides.size());  // m²
  // Per block: absorbed, escaped, and at each material's back, [band]; and the area that sees the sky, m².
  const auto width = (2 + materials) * bands + 1;
  std::vector<double> sums(hits.blocks() * width, 0.0);
  const auto begins = hits.block_begins();
  workers.for_chunks(hits.blocks(), 1, [&](std::size_t first, std::size_t last, int) {
    for (auto block = first; block < last; ++block) {
      auto* sum = &sums[block * width];
      for (std::size_t s = begins[block]; s < begins[block + 1]; ++s) {
        const auto patch = sides.side[s] / 2;
        const double area = patches.area[patch];
        area_per_ray[s] = area / hits.rays_per_receiver()[s];
        for (std::size_t b = 0; b < bands; ++b) {
          const double rho = patches.reflectance(patch, b);
          const double H = irradiance[s * bands + b];
          const double own = sides.side[s] % 2 == 0 ? static_cast<double>(patches.emittance(patch, b)) : 0.0;
          carried[s * bands + b] = area_per_ray[s] * (own + rho * H);
          sum[b] += area * (1.0 - rho) * H;
        }
      }
      for (std::uint32_t r = 0; r < hits.replicates(); ++r) {
        const auto half = transport.half_of(r);
        const auto weight = 0.5 / (transport.half_begin(half + 1) - transport.half_begin(half));
        hits.for_each_hit(r, block, [&](std::uint32_t receiver, std::uint32_t element) {
          if (element < sides.size() || element == hits.dark()) return;
          const auto counts = weight * transport.row_factor(r, receiver);
          const auto sink = hits.is_escape(element) ? 1 : 2 + element - hits.absorbed(0);
          for (std::size_t b = 0; b < bands; ++b)
            sum[sink * bands + b] += counts * carried[receiver * bands + b];
          if (hits.is_escape(element)) sum[width - 1] += counts * area_per_ray[receiver];
        });
      }
    }
  });

  hits.partition().all_gather(
      std::span(sums), width, hits.blocks(), [](std::size_t block) { return block; },
      [&](std::size_t block) { return sides.position[begins[block]]; });

  EnergyAccount energy(emitted_power(patches), materials);
  auto& balance = energy.balance;
  for (std::size_t block = 0; block < hits.blocks(); ++block)
    for (std::size_t b = 0; b < bands; ++b) {
      const auto* sum = &sums[block * width];
      balance.from_sky[b] += sum[width - 1] * patches.sky_radiosity(b);
      balance.absorbed[b] += sum[b];
      balance.escaped[b] += sum[bands + b];
      for (std::size_t m = 0; m < materials; ++m) {
        balance.lost_at_backs[b] += sum[(2 + m) * bands + b];
        energy.back_loss[m] += sum[(2 + m) * bands + b];
      }
    }
  return energy;
}

}  // namespace luxel
