// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/vertex_weld.h"

#include <algorithm>
#include <bit>

#include "luxel/core/none.h"

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
  if (2 * positions_.size() >= receivers_.size()) grow();
  const auto p = position + Vec3(0.0f);  // -0 becomes +0
  const auto mask = receivers_.size() - 1;
  auto receiver = hash(p) & mask;
  for (; receivers_[receiver] != none; receiver = (receiver + 1) & mask)
    if (positions_[receivers_[receiver]] == p) return receivers_[receiver];
  receivers_[receiver] = static_cast<std::uint32_t>(positions_.size());
  positions_.push_back(p);
  return receivers_[receiver];
}

void VertexWeld::grow() {
  constexpr std::size_t smallest = 1024;
  receivers_.assign(std::max(smallest, 4 * receivers_.size()), none);
  const auto mask = receivers_.size() - 1;
  for (std::uint32_t i = 0; i < positions_.size(); ++i) {
    auto receiver = hash(positions_[i]) & mask;
    while (receivers_[receiver] != none) receiver = (receiver + 1) & mask;
    receivers_[receiver] = i;
  }
}

}  // namespace luxel
