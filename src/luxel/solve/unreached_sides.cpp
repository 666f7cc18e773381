// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/unreached_sides.h"

#include <algorithm>

namespace luxel {
namespace {

constexpr std::uint32_t neighbours = 64;  // positions that are lit together
constexpr std::size_t grain = 4096;       // receivers per chunk

// A picture that is made of patches must not be speckled where few rays find the light.
void light_neighbours(std::span<const std::uint32_t> begins, std::vector<std::uint8_t>& lit) {
  for (std::size_t g = 0; g + 1 < begins.size(); ++g) {
    const auto first = lit.begin() + begins[g];
    const auto end = lit.begin() + begins[g + 1];
    if (std::find(first, end, std::uint8_t{1}) != end) std::fill(first, end, std::uint8_t{1});
  }
}

}  // namespace

std::vector<std::uint8_t> lit_receivers(const PatchSet& patches, const HitStore& hits,
                                        const Solution& first_picture,
                                        std::span<const std::vector<float>> direct, const Workers& workers) {
  const auto& sides = hits.sides();
  const auto bands = patches.band_count();
  std::vector<std::uint8_t> lit(hits.elements(), 0);
  const auto any = [bands](const std::vector<float>& values, std::size_t index) {
    return std::any_of(&values[index * bands], &values[index * bands] + bands,
                       [](float x) { return x > 0.0f; });
  };
  workers.for_chunks(sides.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto s = begin; s < end; ++s) {
      const auto patch = sides.side[s] / 2;
      const bool back = sides.side[s] % 2 == 1;
      const auto& H = back ? first_picture.irradiance_back : first_picture.irradiance_front;
      const bool is_lit = any(H, patch) || (!back && patches.material_of(patch).is_lamp()) ||
                          std::any_of(direct.begin(), direct.end(), [&](const auto& d) { return any(d, s); });
      lit[s] = is_lit ? 1 : 0;
    }
  });
  lit[hits.escaped()] = patches.has_sky() ? 1 : 0;
  if (hits.has_portals()) lit[hits.through_portal()] = lit[hits.escaped()];
  const auto groups = neighbour_begins(sides, neighbours);
  // Light goes on from receiver to receiver. Each pass reads the one before, so threads do not matter.
  for (bool changed = true; changed;) {
    light_neighbours(groups, lit);
    auto next = lit;
    workers.for_chunks(hits.blocks(), 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto block = begin; block < end; ++block)
        for (std::uint32_t r = 0; r < direct.size(); ++r)
          hits.for_each_hit(r, block, [&](std::uint32_t receiver, std::uint32_t element) {
            if (lit[element]) next[receiver] = 1;
          });
    });
    hits.partition().all_gather(
        std::span(next), 1, sides.size(), [](std::size_t s) { return s; },
        [&](std::size_t s) { return sides.position[s]; });
    changed = next != lit;
    lit = std::move(next);
  }
  lit.resize(sides.size());
  return lit;
}

}  // namespace luxel
