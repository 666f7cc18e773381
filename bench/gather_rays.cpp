// SPDX-License-Identifier: Apache-2.0
#include "bench/gather_rays.h"

#include <algorithm>
#include <numeric>

#include "luxel/math/bounds.h"
#include "luxel/random/address.h"
#include "luxel/transport/patch_emitter.h"

namespace luxel::bench {
namespace {

constexpr std::size_t side = 8;  // of the square of strata
constexpr std::size_t strata = side * side;
constexpr std::size_t group = 256;  // patches

// The 21 low bits of x, two zeros after each.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffffu;
  x = (x | x << 16) & 0x001f0000ff0000ffu;
  x = (x | x << 8) & 0x100f00f00f00f00fu;
  x = (x | x << 4) & 0x10c30c30c30c30c3u;
  return (x | x << 2) & 0x1249249249249249u;
}

// Patches along the Morton curve through their middles.
std::vector<std::uint32_t> morton_order(const PatchSet& patches) {
  Bounds box;
  for (const auto& p : patches.vertices) box.add(p);
  const auto size = box.size();
  const auto longest = std::max({size.x, size.y, size.z});
  std::vector<std::uint64_t> code(patches.size());
  for (std::size_t i = 0; i < code.size(); ++i) {
    const auto [a, b, c] = patches.points(i);
    const auto at = ((a + b + c) / 3.0f - box.low) / longest * 2'097'151.0f;
    code[i] = spread(static_cast<std::uint64_t>(at.x)) | spread(static_cast<std::uint64_t>(at.y)) << 1 |
              spread(static_cast<std::uint64_t>(at.z)) << 2;
  }
  std::vector<std::uint32_t> order(patches.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return code[a] < code[b]; });
  return order;
}

Ray ray_of(const PatchSet& patches, std::uint32_t patch, std::size_t stratum) {
  const auto front = side_of(patch, false);
  auto u = uniform4(stream_key(1, 0, static_cast<std::uint32_t>(front)), stratum);
  u[2] = (static_cast<float>(stratum % side) + u[2]) / side;
  u[3] = (static_cast<float>(stratum / side) + u[3]) / side;
  return PatchEmitter(patches, front).ray(u);
}

void shuffle(std::vector<Ray>& rays) {
  for (std::size_t i = rays.size(); i > 1; --i) std::swap(rays[i - 1], rays[mix64(i) % i]);
}

}  // namespace

std::vector<Ray> gather_rays(const PatchSet& patches, RayOrder order, std::size_t most) {
  const auto along = morton_order(patches);
  const auto groups = (along.size() + group - 1) / group;
  const auto every = (groups * group * strata + most - 1) / most;
  std::vector<Ray> rays;
  for (std::size_t g = 0; g < groups; g += every) {
    const auto begin = g * group;
    const auto end = std::min(along.size(), begin + group);
    if (order == RayOrder::by_patch)
      for (auto i = begin; i < end; ++i)
        for (std::size_t s = 0; s < strata; ++s) rays.push_back(ray_of(patches, along[i], s));
    else
      for (std::size_t s = 0; s < strata; ++s)
        for (auto i = begin; i < end; ++i) rays.push_back(ray_of(patches, along[i], s));
  }
  if (order == RayOrder::shuffled) shuffle(rays);
  return rays;
}

}  // namespace luxel::bench
