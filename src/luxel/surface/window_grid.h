// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/surface/light_sheets.h"

namespace luxel {

// Overlapping windows over a sheet: one at each node of a regular grid. The weight of a receiver in a window
// falls from 1 at the node to 0 one spacing away along each axis (a tensor product of hat functions), so that
// on a flat sheet the weights of every receiver add up to 1: a partition of unity. A flat sheet has a grid of
// two dimensions, any other one of three.
class WindowGrid {
 public:
  static constexpr std::size_t max_corners = 8;

  // spacing: m. offset: of the grid along each axis, in spacings. Keeps a reference to the sheet. Cost: about
  // 0.2 us per receiver.
  WindowGrid(const LightSheet& sheet, float spacing, const Vec3& offset);

  std::size_t nodes() const { return node_place_.size(); }
  std::size_t cells() const { return cell_begin_.size() - 1; }
  std::size_t corners() const { return sheet_.is_flat() ? 4 : 8; }
  // Indices into the sheet's arrays.
  std::span<const std::uint32_t> in_cell(std::size_t cell) const {
    return std::span(order_).subspan(cell_begin_[cell], cell_begin_[cell + 1] - cell_begin_[cell]);
  }
  // The corners of a cell, and the cells around a node: those that hold receivers, else none.
  const std::array<std::uint32_t, max_corners>& nodes_of_cell(std::size_t cell) const {
    return nodes_of_cell_[cell];
  }
  const std::array<std::uint32_t, max_corners>& cells_of_node(std::size_t node) const {
    return cells_of_node_[node];
  }
  // Position of a receiver relative to a node, in spacings.
  Vec3 from_node(std::size_t node, std::uint32_t index) const { return scaled(index) - node_place_[node]; }
  // Returns the weight of a receiver at this offset from a node.
  static float weight(const Vec3& from_node) {
    const auto hat = [](float x) { return std::max(0.0f, 1.0f - std::abs(x)); };
    return hat(from_node.x) * hat(from_node.y) * hat(from_node.z);
  }

 private:
  Vec3 scaled(std::uint32_t index) const {
    return (sheet_.place[index] - sheet_.low) * per_spacing_ + offset_;
  }
  void sort_into_cells();
  void make_nodes();

  const LightSheet& sheet_;
  float per_spacing_;
  Vec3 offset_;
  std::vector<std::array<std::int32_t, 3>> cell_place_;  // [cell], sorted
  std::vector<std::uint32_t> order_, cell_begin_;
  std::vector<std::array<std::uint32_t, max_corners>> nodes_of_cell_, cells_of_node_;
  std::vector<Vec3> node_place_;
};

// The grids of all scales, from windows of about 9 patches, each scale twice as wide as the one before, to
// one that holds the whole sheet; each at another position. They keep references to the sheet.
std::vector<WindowGrid> make_window_grids(const LightSheet& sheet);

}  // namespace luxel
