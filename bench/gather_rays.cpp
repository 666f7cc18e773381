// SPDX-License-Identifier: Apache-2.0
#include "bench/gather_rays.h"

#include <algorithm>
#include <numeric>

#include "luxel/core/address.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solve/hit_store.h"
#include "luxel/trace/gather_rays.h"

namespace luxel::bench {
namespace {

// Appends the rays of receivers that are traced together.
void append_rays(const PatchSet& patches, const GatherSides& sides, const GatherRound& round,
                 std::span<const std::uint32_t> receivers, std::vector<Ray>& rays) {
  GatherRays block(patches, sides, receivers, {}, 0, round.per_receiver);
  std::vector<GatherRays::Row> rows;
  const auto count = round.replicates * round.per_receiver;
  for (std::uint32_t row = 0; row < count; ++row) {
    rows.push_back({row / round.per_receiver, row % round.per_receiver});
    if (rows.size() < GatherRays::max_rows && row + 1 < count) continue;
    block.for_each_batch(rows,
                         [&](std::span<const Ray> r, auto) { rays.insert(rays.end(), r.begin(), r.end()); });
    rows.clear();
  }
}

}  // namespace

GatherSides fronts_of(const PatchSet& patches, const Context& context) {
  const auto all = all_gather_sides(patches, make_patch_tree(patches, context));
  std::vector<std::uint8_t> kept(all.size(), 0);
  std::fill_n(kept.begin(), all.fronts, 1);
  return restored_gather_sides(all, kept);
}

std::vector<Ray> gather_rays(const PatchSet& patches, const GatherSides& sides, const GatherRound& round,
                             RayOrder order) {
  const Tracer none(PatchSet{}, Context(1));  // nothing is traced here
  const auto groups =
      HitStore(patches, sides, none, {.replicates = round.replicates}).traced_together(round.per_receiver);
  std::vector<std::uint32_t> receivers(sides.size());
  std::iota(receivers.begin(), receivers.end(), 0u);
  const auto all = receivers.size() * round.replicates * round.per_receiver;
  const auto every = std::max<std::size_t>(1, (all + round.most - 1) / round.most);
  std::vector<Ray> rays;
  for (std::size_t g = 0; g + 1 < groups.size(); g += every) {
    const auto group = std::span(receivers).subspan(groups[g], groups[g + 1] - groups[g]);
    if (order == RayOrder::by_patch)
      for (std::size_t i = 0; i < group.size(); ++i)
        append_rays(patches, sides, round, group.subspan(i, 1), rays);
    else
      append_rays(patches, sides, round, group, rays);
  }
  if (order == RayOrder::shuffled)
    for (std::size_t i = rays.size(); i > 1; --i) std::swap(rays[i - 1], rays[mix64(i) % i]);
  return rays;
}

}  // namespace luxel::bench
