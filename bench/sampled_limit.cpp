// SPDX-License-Identifier: Apache-2.0
// Speed of the sampled operator relative to Embree alone, and the gain of its ray order.
#include <numeric>

#include <fmt/format.h>

#include "luxel/patch/make_patches.h"
#include "luxel/solve/sampled_operator.h"

#include "bench/gather_rays.h"
#include "bench/same_rays.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

constexpr std::uint32_t replicates = 8;

}  // namespace

Json sampled_against_embree(const Settings& settings) {
  fmt::print(
      "\ngather: the sampled operator's rays traced and stored, against Embree alone on the very same rays "
      "in "
      "the same order (1 is the limit) and shuffled; one thread\n");
  fmt::print("{:>10} {:>8} {:>12} {:>10} {:>8} {:>17} {:>14} {:>12} {:>12}\n", "patches", "Mrays",
             "Embree ns", "traced ns", "ratio", "(low to high)", "order's gain", "ns to add up",
             "bytes moved");
  const Context one(1);
  Json rows = Json::array();
  struct Size {
    std::uint32_t triangles, rays_per_receiver;
  };
  for (const auto& size : {Size{10'000, 64}, Size{50'000, 16}, Size{1'000'000, 1}}) {
    const auto per_receiver = size.rays_per_receiver;
    const auto scale = settings.small ? 20 : 1;
    const auto patches = make_patches(cornell_box(size.triangles / scale), {.max_edge = no_max_edge});
    const Tracer tracer(patches, one);
    const auto sides = fronts_of(patches, one);
    std::vector<std::uint32_t> receivers(sides.size());
    std::iota(receivers.begin(), receivers.end(), 0u);
    const BareEmbree embree(patches);
    std::vector<float> irradiance(sides.size() * patches.band_count());
    HitStore hits(patches, sides, tracer, {.replicates = replicates});
    const GatherRound round{.replicates = replicates, .per_receiver = per_receiver};
    const auto rays = gather_rays(patches, sides, round, RayOrder::traced);
    const auto shuffled = gather_rays(patches, sides, round, RayOrder::shuffled);
    const auto count = static_cast<double>(rays.size());
    hits.double_rays(receivers, per_receiver, one);
    const SampledOperator transport(patches, hits, {}, one);
    const std::vector<float> radiosity(hits.elements() * patches.band_count(), 1.0f);
    const auto sweep_time = seconds([&] {
      for (const std::size_t half : {0, 1})
        transport.apply(half, patches.band_count(), radiosity, irradiance, one);
    });
    double traced_time = 0.0;
    double embree_time = 0.0;
    const auto ratio = paired(
        3, [&] { embree_time = seconds([&] { embree.trace(rays, one); }); },
        [&] {
          HitStore again(patches, sides, tracer, {.replicates = replicates});
          traced_time = seconds([&] { again.double_rays(receivers, per_receiver, one); });
        });
    const auto shuffled_time = seconds([&] { embree.trace(shuffled, one); });
    // A sweep reads the element at the other end of each ray, its density and its radiosity, from both ends.
    const auto bytes = 2 * (sizeof(std::uint32_t) + sizeof(float) * (1 + patches.band_count()));
    fmt::print(
        "{:>10} {:>8.2f} {:>12.0f} {:>10.0f} {:>8.2f} {:>8.2f} to {:.2f} {:>12.2f} x {:>12.2f} {:>12}\n",
        patches.size(), 1e-6 * count, 1e9 * embree_time / count, 1e9 * traced_time / count, ratio.median,
        ratio.low, ratio.high, shuffled_time / embree_time, 1e9 * sweep_time / count, bytes);
    rows.push_back({{"patches", patches.size()},
                    {"rays", rays.size()},
                    {"embree_ns_per_ray", 1e9 * embree_time / count},
                    {"traced_ns_per_ray", 1e9 * traced_time / count},
                    {"ratio", ratio.median},
                    {"ratio_low", ratio.low},
                    {"ratio_high", ratio.high},
                    {"order_gain", shuffled_time / embree_time},
                    {"sweep_ns_per_ray", 1e9 * sweep_time / count},
                    {"sweep_bytes_per_ray", bytes}});
  }
  return rows;
}

}  // namespace luxel::bench
