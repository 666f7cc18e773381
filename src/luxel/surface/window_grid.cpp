// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/window_grid.h"

#include <algorithm>

#include "luxel/core/none.h"

namespace luxel {
namespace {

using CellPlace = std::array<std::int32_t, 3>;

constexpr int bits_per_axis = 21;

// The order of cells and nodes; places are counted from 0 and are below two million.
std::uint64_t key_of(const CellPlace& place) {
  std::uint64_t key = 0;
  for (const auto c : place) key = (key << bits_per_axis) | static_cast<std::uint64_t>(c);
  return key;
}

struct Corner {
  std::uint64_t key = 0;
  std::uint32_t cell = 0;
  std::uint32_t corner = 0;
  friend bool operator<(const Corner& a, const Corner& b) {
    return a.key != b.key ? a.key < b.key : a.cell < b.cell;
  }
};

}  // namespace

WindowGrid::WindowGrid(const LightSheet& sheet, float spacing, const Vec3& offset)
    : sheet_(sheet), per_spacing_(1.0f / spacing), offset_(offset) {
  if (sheet.is_flat()) offset_.z = 0.0f;
  sort_into_cells();
  make_nodes();
}

void WindowGrid::sort_into_cells() {
  const auto count = sheet_.size();
  struct Item {
    std::uint64_t key;
    std::uint32_t index;
  };
  std::vector<Item> items(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto at = scaled(i);
    items[i] = {key_of({static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(at.y),
                        static_cast<std::int32_t>(at.z)}),
                i};
  }
  std::sort(items.begin(), items.end(),
            [](const Item& a, const Item& b) { return a.key != b.key ? a.key < b.key : a.index < b.index; });
  order_.resize(count);
  constexpr auto mask = (std::uint64_t{1} << bits_per_axis) - 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    order_[i] = items[i].index;
    const auto key = items[i].key;
    if (i > 0 && key == items[i - 1].key) continue;
    cell_begin_.push_back(i);
    cell_place_.push_back({static_cast<std::int32_t>(key >> (2 * bits_per_axis)),
                           static_cast<std::int32_t>((key >> bits_per_axis) & mask),
                           static_cast<std::int32_t>(key & mask)});
  }
  cell_begin_.push_back(static_cast<std::uint32_t>(count));
}

void WindowGrid::make_nodes() {
  std::vector<Corner> all;
  all.reserve(cells() * corners());
  for (std::uint32_t cell = 0; cell < cells(); ++cell)
    for (std::uint32_t corner = 0; corner < corners(); ++corner) {
      auto place = cell_place_[cell];
      for (std::uint32_t axis = 0; axis < 3; ++axis)
        place[axis] += static_cast<std::int32_t>((corner >> axis) & 1u);
      all.push_back({key_of(place), cell, corner});
    }
  std::sort(all.begin(), all.end());
  std::array<std::uint32_t, max_corners> empty;
  empty.fill(none);
  nodes_of_cell_.assign(cells(), empty);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [key, cell, corner] = all[i];
    if (i == 0 || key != all[i - 1].key) {
      const auto& place = cell_place_[cell];
      node_place_.emplace_back(static_cast<float>(place[0]) + static_cast<float>(corner & 1u),
                               static_cast<float>(place[1]) + static_cast<float>((corner >> 1) & 1u),
                               static_cast<float>(place[2]) + static_cast<float>((corner >> 2) & 1u));
      cells_of_node_.push_back(empty);
    }
    const auto node = static_cast<std::uint32_t>(node_place_.size() - 1);
    cells_of_node_[node][corner] = cell;
    nodes_of_cell_[cell][corner] = node;
  }
}

}  // namespace luxel
