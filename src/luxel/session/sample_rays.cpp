// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/sample_rays.h"

#include <algorithm>
#include <array>
#include <optional>

#include "luxel/lamps/direct_light.h"
#include "luxel/lamps/lamps.h"
#include "luxel/patch/side.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solve/sampling.h"
#include "luxel/trace/gather_rays.h"

namespace luxel {
namespace {

constexpr std::uint32_t first_of_none = 32;  // samples per replicate, for a light without samples

// A side, and its index among the receivers.
struct Place {
  SideId side;
  std::uint32_t position = 0;           // in the patch tree's order
  std::optional<std::size_t> receiver;  // in the samples
};

std::optional<Place> place_of(const SessionLight& light, std::uint32_t patch, bool back) {
  const auto& mesh = light.mesh;
  if (!mesh.tracer || !mesh.tree || (back && !mesh.patches->material_of(patch).two_sided)) return {};
  Place place{.side = SideId(patch, back), .position = 0, .receiver = {}};
  const auto& order = mesh.tree->order;
  place.position =
      mesh.tree
          ->position[static_cast<std::size_t>(std::find(order.begin(), order.end(), patch) - order.begin())];
  if (!light.samples) return place;
  const auto& sides = light.samples->sides;
  const auto at = std::find(sides.begin(), sides.end(), place.side);
  if (at != sides.end()) place.receiver = static_cast<std::size_t>(at - sides.begin());
  return place;
}

// Rounds of gather rays that included the side: their level, and rays per replicate.
std::vector<std::array<std::uint32_t, 2>> rounds_of(const SessionLight& light, const Place& place) {
  if (!light.samples || light.samples->rounds.empty()) return {{0, first_of_none}};
  // The first round included all sides; later ones leave out sides that no light reaches.
  if (!place.receiver) return {{0, light.samples->rounds[0].per_replicate}};
  std::vector<std::array<std::uint32_t, 2>> rounds;
  for (const auto& round : light.samples->rounds)
    if (std::binary_search(round.receivers.begin(), round.receivers.end(),
                           static_cast<std::uint32_t>(*place.receiver)))
      rounds.push_back({round.level, round.per_replicate});
  return rounds;
}

}  // namespace

std::vector<GatherRay> gather_rays(const SessionLight& light, std::uint32_t patch, bool back,
                                   std::size_t most) {
  const auto place = place_of(light, patch, back);
  if (!place) return {};
  const auto& patches = *light.mesh.patches;
  const GatherSides alone{.side = {place->side},
                          .position = {place->position},
                          .receiver_of_side = {},
                          .fronts = back ? std::size_t{0} : std::size_t{1}};
  const std::array<std::uint32_t, 1> receivers = {0};
  const auto& how = light.sampled;
  std::vector<GatherRay> found;
  for (const auto& [level, per_replicate] : rounds_of(light, *place)) {
    GatherRays rays(patches, alone, receivers, {how.seed, how.low_discrepancy, how.stratified}, level,
                    per_replicate);
    for (std::uint32_t r = 0; r < how.replicates; ++r)
      for (std::uint32_t k = 0; k < per_replicate; ++k) {
        if (found.size() == most) return found;
        const std::array<GatherRays::Row, 1> row = {{{r, k, nullptr}}};
        rays.for_each_batch(row, [&](std::span<const Ray> ray, std::span<const std::uint16_t>) {
          found.push_back({ray[0].origin, ray[0].direction, light.mesh.tracer->nearest(ray[0]), r});
        });
      }
  }
  return found;
}

std::vector<DirectRay> direct_rays(const SessionLight& light, std::uint32_t patch, bool back,
                                   std::size_t most) {
  const auto place = place_of(light, patch, back);
  if (!place) return {};
  const auto& patches = *light.mesh.patches;
  const Lamps lamps(patches);
  const DirectLight direct(patches, *light.mesh.tracer, lamps, direct_options(light.sampled));
  std::uint32_t rounds = 1;
  auto more = first_of_none;
  if (light.samples && place->receiver) {
    rounds = light.samples->direct_doublings[*place->receiver];
    more = light.samples->direct_samples[*place->receiver] >> (rounds > 0 ? rounds - 1 : 0);
  }
  std::vector<DirectRay> found;
  for (std::uint32_t round = 0; round < rounds; ++round) {
    for (const auto& ray : direct.rays_of(place->side, place->position, round, more)) {
      if (found.size() == most) return found;
      found.push_back({ray.from, ray.to, ray.seen, ray.replicate});
    }
    if (round > 0) more *= 2;  // the second round has as many rays as the first
  }
  return found;
}

}  // namespace luxel
