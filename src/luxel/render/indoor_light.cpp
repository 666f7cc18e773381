// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/indoor_light.h"

#include <algorithm>

#include "luxel/patch/patch_tree.h"
#include "luxel/random/address.h"
#include "luxel/render/side_point.h"

namespace luxel {
namespace {

constexpr std::uint32_t neighbours = 64;  // positions that are judged together
constexpr std::size_t rays = 64;          // of such a group, of its fronts and of its backs
constexpr float least = 0.01f;            // what nothing shuts in counts all the same
constexpr std::uint32_t stream = 2;       // the first two are the candidates'

// Where groups of neighbours begin in the tree's order, and its end.
std::vector<std::size_t> group_begins(const PatchTree& tree) {
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < tree.order.size(); ++i)
    if (i == 0 || tree.position[i] / neighbours != tree.position[i - 1] / neighbours) begins.push_back(i);
  begins.push_back(tree.order.size());
  return begins;
}

// The share of what leaves these patches, from their fronts or backs, that meets something.
float shut_in(const PatchSet& patches, const Tracer& tracer, const std::uint32_t* patch, std::size_t count,
              bool back) {
  std::size_t met = 0;
  const auto key = stream_key(0, stream, 2 * patch[0] + (back ? 1 : 0));
  for (std::size_t i = 0; i < rays; ++i) {
    const auto side = 2 * std::size_t{patch[i * count / rays]} + (back ? 1 : 0);
    const auto u = uniform4(key, i);
    const auto direction = Frame(side_normal(patches, side)).to_world(cosine_hemisphere(u[2], u[3]));
    if (tracer.nearest({point_before(patches, side, u[0], u[1]), direction})) ++met;
  }
  return static_cast<float>(met) / static_cast<float>(rays);
}

}  // namespace

Solution indoor_light(const PatchSet& patches, const Solution& light, const Tracer& tracer,
                      const Workers& workers) {
  const auto bands = patches.band_count();
  if (light.irradiance_front.size() != patches.size() * bands) return light;
  const auto tree = make_patch_tree(patches, workers);
  const auto begins = group_begins(tree);
  Solution result;
  result.bands = light.bands;
  for (auto* array : {&result.irradiance_front, &result.irradiance_back})
    array->assign(patches.size() * bands, 0.0f);
  workers.for_chunks(begins.size() - 1, 16, [&](std::size_t begin, std::size_t end, int) {
    for (auto g = begin; g < end; ++g)
      for (const bool back : {false, true}) {
        const auto* patch = &tree.order[begins[g]];
        const auto count = begins[g + 1] - begins[g];
        const auto& from = back ? light.irradiance_back : light.irradiance_front;
        auto& to = back ? result.irradiance_back : result.irradiance_front;
        const bool is_lit = std::any_of(patch, patch + count, [&](std::uint32_t p) {
          return std::any_of(&from[p * bands], &from[p * bands] + bands, [](float x) { return x > 0.0f; });
        });
        if (!is_lit) continue;
        const auto share = shut_in(patches, tracer, patch, count, back);
        for (std::size_t i = 0; i < count; ++i)
          std::fill_n(&to[patch[i] * bands], bands, least + share * share);
      }
  });
  return result;
}

}  // namespace luxel
