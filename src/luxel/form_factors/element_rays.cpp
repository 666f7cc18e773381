// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/element_rays.h"

#include <algorithm>
#include <array>
#include <utility>

#include "luxel/core/none.h"
#include "luxel/form_factors/view_factors.h"
#include "luxel/patch/patch_tree.h"

namespace luxel {
namespace {

GatherSides sides_with_rays(const PatchSet& patches, const ViewElements& elements,
                            const std::vector<std::uint8_t>& rows, const Context& context) {
  const auto all = all_gather_sides(patches, make_patch_tree(patches, context));
  std::vector<std::uint8_t> keep(all.size());
  for (std::size_t s = 0; s < all.size(); ++s) {
    const auto element = elements.of_side[all.side[s].index()];
    keep[s] = element != none && (rows.empty() || rows[element]);
  }
  return restored_gather_sides(all, keep);
}

}  // namespace

ElementRays::ElementRays(const PatchSet& patches, const Tracer& tracer, const ViewElements& elements,
                         const ElementRayOptions& options, const Context& context)
    : patches_(patches),
      tracer_(tracer),
      elements_(elements),
      sides_(sides_with_rays(patches, elements, options.rows, context)),
      seed_(options.seed),
      replicates_(options.replicates) {}

std::vector<std::size_t> ElementRays::runs(std::span<const std::uint32_t> receivers,
                                           std::uint32_t positions) const {
  const auto block_of = [&](std::uint32_t receiver) {
    return std::pair(receiver >= sides_.fronts, sides_.position[receiver] / positions);
  };
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < receivers.size(); ++i)
    if (i == 0 || block_of(receivers[i]) != block_of(receivers[i - 1])) begins.push_back(i);
  begins.push_back(receivers.size());
  return begins;
}

std::uint32_t ElementRays::number_of(const Hit& hit) const {
  const auto sinks = static_cast<std::uint32_t>(elements_.size());
  if (!hit) return sinks + ViewFactors::environment;
  const auto element = elements_.of_side[hit.side().index()];
  return element != none ? element : sinks + ViewFactors::backs;
}

void ElementRays::trace(std::span<const std::uint32_t> receivers, std::uint32_t replicate,
                        std::uint32_t level, std::uint32_t per_receiver, std::span<std::uint32_t> met) const {
  GatherRays rays(patches_, sides_, receivers, {.seed = seed_}, level, per_receiver);
  std::array<GatherRays::Row, GatherRays::max_rows> rows;
  for (std::uint32_t sample = 0; sample < per_receiver;) {
    const auto count = std::min<std::size_t>(per_receiver - sample, rows.size());
    for (std::size_t i = 0; i < count; ++i, ++sample) rows[i] = {replicate, sample, met.data() + sample};
    rays.trace(tracer_, std::span(rows.data(), count),
               [this](const Hit& hit, const Ray&) { return number_of(hit); });
  }
}

}  // namespace luxel
