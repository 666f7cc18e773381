// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/none.h"

namespace luxel {

/// One of the two sides of a patch, an unknown of the radiosity system. The front is the side that the
/// patch's normal points to. Arrays over all sides hold front and back of patch 0, then of patch 1, and so
/// on.
class SideId {
 public:
  constexpr SideId() = default;  ///< no side
  constexpr SideId(std::size_t patch, bool is_back)
      : index_(static_cast<std::uint32_t>(2 * patch + (is_back ? 1 : 0))) {
    assert(patch < none / 2);
  }
  /// The side at a place of an array over all sides.
  static constexpr SideId at(std::size_t index) {
    SideId side;
    side.index_ = static_cast<std::uint32_t>(index);
    return side;
  }

  constexpr std::uint32_t patch() const { return index_ / 2; }
  constexpr bool is_back() const { return index_ % 2 == 1; }
  constexpr std::uint32_t index() const { return index_; }  ///< in arrays over all sides
  constexpr SideId opposite() const { return at(index_ ^ 1u); }
  constexpr explicit operator bool() const { return index_ != none; }

  constexpr auto operator<=>(const SideId&) const = default;

 private:
  std::uint32_t index_ = none;
};

constexpr std::size_t side_count(std::size_t patches) { return 2 * patches; }

/// Returns the sides as indices, for files.
inline std::vector<std::uint32_t> indices_of(std::span<const SideId> sides) {
  std::vector<std::uint32_t> indices;
  indices.reserve(sides.size());
  for (const auto side : sides) indices.push_back(side.index());
  return indices;
}
inline std::vector<SideId> sides_at(std::span<const std::uint32_t> indices) {
  std::vector<SideId> sides;
  sides.reserve(indices.size());
  for (const auto index : indices) sides.push_back(SideId::at(index));
  return sides;
}

/// A value for each patch (or vertex) and band, of the fronts and of the backs: [patch][band] each.
template <typename Real>
struct FrontAndBack {
  std::vector<Real> front, back;

  std::vector<Real>& of(bool is_back) { return is_back ? back : front; }
  const std::vector<Real>& of(bool is_back) const { return is_back ? back : front; }
  std::vector<Real>& of(SideId side) { return of(side.is_back()); }
  const std::vector<Real>& of(SideId side) const { return of(side.is_back()); }

  bool operator==(const FrontAndBack&) const = default;
};
using SideValues = FrontAndBack<float>;

}  // namespace luxel
