// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/lamp_surfaces.h"

#include <unordered_map>

#include "luxel/core/disjoint_sets.h"

namespace luxel {
namespace {

bool emits(const PatchSet& patches, std::size_t patch) {
  for (std::size_t b = 0; b < patches.band_count(); ++b)
    if (patches.emittance(patch, b) > 0.0f) return true;
  return false;
}

}  // namespace

std::vector<LampSurface> find_lamp_surfaces(const PatchSet& patches) {
  DisjointSets sets(patches.size());
  std::vector<std::uint32_t> emitting;
  std::unordered_map<std::uint64_t, std::uint32_t> first_at;  // by vertex and material: a patch
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    if (!emits(patches, p)) continue;
    emitting.push_back(p);
    for (const auto vertex : patches.corners[p]) {
      const auto key = (std::uint64_t{vertex} << 32) | static_cast<std::uint32_t>(patches.material[p]);
      const auto [at, is_new] = first_at.try_emplace(key, p);
      if (!is_new) sets.join(at->second, p);
    }
  }
  std::vector<LampSurface> lamps;
  std::unordered_map<std::uint32_t, std::size_t> lamp_of;  // by the first patch
  for (const auto p : emitting) {
    const auto [at, is_new] = lamp_of.try_emplace(sets.of(p), lamps.size());
    if (is_new) lamps.push_back({patches.material_of(p).name, {}});
    lamps[at->second].patches.push_back(p);
  }
  return lamps;
}

}  // namespace luxel
