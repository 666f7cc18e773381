// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/spread_outliers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "luxel/core/none.h"

namespace luxel {
namespace {

constexpr std::size_t min_near = 8;  // lit receivers by which to judge
constexpr float reach = 4.0f;        // deciles above the median; of Gaussian noise 5 standard deviations
constexpr float above_own = 4.0f;    // over the median of a bright side's own replicates
constexpr float min_facing = 0.5f;   // cosine between the normals of giver and taker

// A value above its bound.
struct Outlier {
  std::uint32_t receiver = 0;
  std::size_t replicate = 0;
  float factor = 1.0f;  // that takes it to the bound
};

// The cells of one grid. is_judged: [receiver], for all grids.
class Cells {
 public:
  Cells(const LightSheet& sheet, const WindowGrid& grid, WindowColumns columns, std::vector<float>& values,
        std::vector<char>& is_judged)
      : sheet_(sheet),
        grid_(grid),
        columns_(columns),
        values_(values),
        is_judged_(is_judged),
        outliers_(grid.cells()) {}

  // Finds the outliers of a cell among its receivers that are not judged yet, where enough others are near.
  // Any number of threads may call, for different cells.
  void judge(std::size_t cell) {
    const auto inside = grid_.in_cell(cell);
    if (std::all_of(inside.begin(), inside.end(), [this](auto i) { return is_judged_[i] != 0; })) return;
    const auto near = receivers_near(cell);
    std::vector<float> all;
    for (const auto i : near) {
      bool is_lit = false;
      for (std::size_t r = 0; r < columns_.replicates; ++r) {
        all.push_back(sum_of(i, r));
        is_lit = is_lit || all.back() != 0.0f;
      }
      // Sides that no light reaches say nothing about the noise of others.
      if (!is_lit) all.resize(all.size() - columns_.replicates);
    }
    if (all.size() < min_near * columns_.replicates) return;
    const auto median = quantile(all, 0.5);
    const auto above = reach * (quantile(all, 0.9) - median);
    if (!(above > 0.0f)) return;
    std::vector<float> own(columns_.replicates);
    for (const auto i : inside) {
      if (is_judged_[i]) continue;
      is_judged_[i] = 1;
      for (std::size_t r = 0; r < own.size(); ++r) own[r] = sum_of(i, r);
      const auto largest = *std::max_element(own.begin(), own.end());
      if (!(largest > median + above)) continue;
      const auto own_median = quantile(own, 0.5);
      // Below zero only by noise: nothing is left of an outlier then.
      const auto bound =
          own_median > median + above ? above_own * own_median : std::max(0.0f, median + above);
      for (std::size_t r = 0; r < own.size(); ++r)
        if (const auto value = sum_of(i, r); value > bound) outliers_[cell].push_back({i, r, bound / value});
    }
  }

  // In the order of cells, for a receiver takes from several.
  void spread() {
    for (std::size_t cell = 0; cell < outliers_.size(); ++cell) {
      if (outliers_[cell].empty()) continue;
      const auto near = receivers_near(cell);
      for (const auto& outlier : outliers_[cell]) spread(outlier, near);
    }
  }

 private:
  float sum_of(std::uint32_t receiver, std::size_t replicate) const {
    const auto* value = value_of(receiver, replicate);
    float sum = 0.0f;
    for (std::size_t b = 0; b < columns_.bands; ++b) sum += value[b];
    return sum;
  }
  float* value_of(std::uint32_t receiver, std::size_t replicate) const {
    return values_.data() + receiver * columns_.size() + replicate * columns_.stride();
  }

  static float quantile(std::vector<float>& numbers, double fraction) {
    const auto at = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(numbers.size()));
    std::nth_element(numbers.begin(), numbers.begin() + at, numbers.end());
    return numbers[static_cast<std::size_t>(at)];
  }

  // Returns the receivers in the cell and in the cells that share a node with it.
  std::vector<std::uint32_t> receivers_near(std::size_t cell) const {
    std::vector<std::uint32_t> cells;
    for (std::size_t corner = 0; corner < grid_.corners(); ++corner)
      for (std::size_t k = 0; k < grid_.corners(); ++k)
        if (const auto other = grid_.cells_of_node(grid_.nodes_of_cell(cell)[corner])[k]; other != none)
          cells.push_back(other);
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    std::vector<std::uint32_t> receivers;
    for (const auto c : cells)
      receivers.insert(receivers.end(), grid_.in_cell(c).begin(), grid_.in_cell(c).end());
    return receivers;
  }

  bool takes_part(std::uint32_t a, std::uint32_t b) const {
    return a != b && (sheet_.is_flat() || glm::dot(sheet_.normal[a], sheet_.normal[b]) > min_facing);
  }

  void spread(const Outlier& outlier, const std::vector<std::uint32_t>& near) {
    float area = 0.0f;
    for (const auto i : near)
      if (takes_part(outlier.receiver, i)) area += sheet_.area[i];
    if (!(area > 0.0f)) return;
    auto* from = value_of(outlier.receiver, outlier.replicate);
    const auto given = (1.0f - outlier.factor) * sheet_.area[outlier.receiver] / area;
    for (const auto i : near) {
      if (!takes_part(outlier.receiver, i)) continue;
      auto* to = value_of(i, outlier.replicate);
      for (std::size_t b = 0; b < columns_.bands; ++b) to[b] += given * from[b];
    }
    for (std::size_t b = 0; b < columns_.bands; ++b) from[b] *= outlier.factor;
  }

  const LightSheet& sheet_;
  const WindowGrid& grid_;
  WindowColumns columns_;
  std::vector<float>& values_;
  std::vector<char>& is_judged_;
  std::vector<std::vector<Outlier>> outliers_;  // [cell]
};

}  // namespace

void spread_outliers(const LightSheet& sheet, std::span<const WindowGrid> grids, WindowColumns columns,
                     std::vector<float>& values, const LoopRunner& run) {
  std::vector<char> is_judged(sheet.size(), 0);
  for (const auto& grid : grids) {
    Cells cells(sheet, grid, columns, values, is_judged);
    run(grid.cells(), [&](std::size_t begin, std::size_t end) {
      for (auto cell = begin; cell < end; ++cell) cells.judge(cell);
    });
    cells.spread();
    if (std::find(is_judged.begin(), is_judged.end(), 0) == is_judged.end()) return;
  }
}

}  // namespace luxel
