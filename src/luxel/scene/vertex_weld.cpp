// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/vertex_weld.h"

#include <algorithm>
#include <bit>

namespace luxel {
namespace {

std::uint64_t hash(const Vec3& p) {
  std::uint64_t h = std::bit_cast<std::uint32_t>(p.x);
  h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u + std::bit_cast<std::uint32_t>(p.y);
  h = (h ^ (h >> 32)) * 0x94d049bb133111ebu + std::bit_cast<std::uint32_t>(p.z);
  h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u;
  return h ^ (h >> 32);
}

}  // namespace

std::uint32_t VertexWeld::index_of(const Vec3& position) {
  if (2 * positions_.size() >= slots_.size()) grow();
  const auto p = position + Vec3(0.0f);  // -0 becomes +0
  const auto mask = slots_.size() - 1;
  auto slot = hash(p) & mask;
  for (; slots_[slot] != empty; slot = (slot + 1) & mask)
    if (positions_[slots_[slot]] == p) return slots_[slot];
  slots_[slot] = static_cast<std::uint32_t>(positions_.size());
  positions_.push_back(p);
  return slots_[slot];
}

void VertexWeld::grow() {
  constexpr std::size_t smallest = 1024;
  slots_.assign(std::max(smallest, 4 * slots_.size()), empty);
  const auto mask = slots_.size() - 1;
  for (std::uint32_t i = 0; i < positions_.size(); ++i) {
    auto slot = hash(positions_[i]) & mask;
    while (slots_[slot] != empty) slot = (slot + 1) & mask;
    slots_[slot] = i;
  }
}

}  // namespace luxel
