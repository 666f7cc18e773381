// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/vertex_weld.h"

#include <bit>

namespace luxel {

std::uint32_t VertexWeld::index_of(const Vec3& position) {
  const auto p = position + Vec3(0.0f);  // -0 becomes +0
  const auto [entry, is_new] = index_.try_emplace(p, static_cast<std::uint32_t>(positions_.size()));
  if (is_new) positions_.push_back(p);
  return entry->second;
}

std::size_t VertexWeld::Hash::operator()(const Vec3& p) const {
  std::uint64_t h = std::bit_cast<std::uint32_t>(p.x);
  h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u + std::bit_cast<std::uint32_t>(p.y);
  h = (h ^ (h >> 32)) * 0x94d049bb133111ebu + std::bit_cast<std::uint32_t>(p.z);
  h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u;
  return h ^ (h >> 32);
}

}  // namespace luxel
