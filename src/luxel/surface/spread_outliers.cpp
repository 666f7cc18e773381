// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/spread_outliers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

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

// The values of a sheet, and their sums over bands.
class Values {
 public:
  Values(std::span<float> values, WindowColumns columns, const LoopRunner& run)
      : values_(values), columns_(columns), sums_(values.size() / columns.size() * columns.replicates) {
    run(sums_.size() / columns.replicates, [&](std::size_t begin, std::size_t end) {
      for (auto i = begin; i < end; ++i)
        for (std::size_t r = 0; r < columns_.replicates; ++r) sum(i, r);
    });
  }

  std::size_t replicates() const { return columns_.replicates; }
  // [replicate], over bands.
  std::span<const float> sums_of(std::size_t receiver) const {
    return std::span(sums_).subspan(receiver * columns_.replicates, columns_.replicates);
  }
  // [band].
  std::span<const float> of(std::size_t receiver, std::size_t replicate) const {
    return values_.subspan(at(receiver, replicate), columns_.bands);
  }
  void add(std::size_t receiver, std::size_t replicate, float factor, std::span<const float> added) {
    for (std::size_t b = 0; b < columns_.bands; ++b)
      values_[at(receiver, replicate) + b] += factor * added[b];
    sum(receiver, replicate);
  }
  void scale(std::size_t receiver, std::size_t replicate, float factor) {
    for (std::size_t b = 0; b < columns_.bands; ++b) values_[at(receiver, replicate) + b] *= factor;
    sum(receiver, replicate);
  }

 private:
  std::size_t at(std::size_t receiver, std::size_t replicate) const {
    return receiver * columns_.size() + replicate * columns_.stride();
  }
  void sum(std::size_t receiver, std::size_t replicate) {
    float sum = 0.0f;
    for (const auto value : of(receiver, replicate)) sum += value;
    sums_[receiver * columns_.replicates + replicate] = sum;
  }

  std::span<float> values_;
  WindowColumns columns_;
  std::vector<float> sums_;
};

// The cells of one grid. is_judged: [receiver], for all grids.
class Cells {
 public:
  Cells(const LightSheet& sheet, const WindowGrid& grid, Values& values, std::vector<char>& is_judged)
      : sheet_(sheet), grid_(grid), values_(values), is_judged_(is_judged), outliers_(grid.cells()) {}

  // Finds the outliers of a cell among its receivers that are not judged yet, where enough others are near.
  // Any number of threads may call, for different cells.
  void judge(std::size_t cell) {
    const auto inside = grid_.in_cell(cell);
    if (std::all_of(inside.begin(), inside.end(), [this](auto i) { return is_judged_[i] != 0; })) return;
    const auto near = receivers_near(cell);
    std::vector<float> all;
    all.reserve(near.size() * values_.replicates());
    for (const auto i : near) {
      const auto sums = values_.sums_of(i);
      // Sides that no light reaches say nothing about the noise of others.
      if (std::any_of(sums.begin(), sums.end(), [](float sum) { return sum != 0.0f; }))
        all.insert(all.end(), sums.begin(), sums.end());
    }
    if (all.size() < min_near * values_.replicates()) return;
    const auto middle = place_of(all, 0.5), high = place_of(all, 0.9);
    std::nth_element(all.begin(), middle, all.end());
    const auto median = *middle;
    std::nth_element(middle, high, all.end());
    const auto above = reach * (*high - median);
    if (!(above > 0.0f)) return;
    std::vector<float> own(values_.replicates());
    for (const auto i : inside) {
      if (is_judged_[i]) continue;
      is_judged_[i] = 1;
      const auto sums = values_.sums_of(i);
      if (!(*std::max_element(sums.begin(), sums.end()) > median + above)) continue;
      std::copy(sums.begin(), sums.end(), own.begin());
      const auto own_middle = place_of(own, 0.5);
      std::nth_element(own.begin(), own_middle, own.end());
      const auto own_median = *own_middle;
      // Below zero only by noise: nothing is left of an outlier then.
      const auto bound =
          own_median > median + above ? above_own * own_median : std::max(0.0f, median + above);
      for (std::size_t r = 0; r < sums.size(); ++r)
        if (sums[r] > bound) outliers_[cell].push_back({i, r, bound / sums[r]});
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
  // Returns where the quantile would stand if the numbers were sorted.
  static std::vector<float>::iterator place_of(std::vector<float>& numbers, double fraction) {
    return numbers.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(numbers.size()));
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
    const auto given = (1.0f - outlier.factor) * sheet_.area[outlier.receiver] / area;
    for (const auto i : near)
      if (takes_part(outlier.receiver, i))
        values_.add(i, outlier.replicate, given, values_.of(outlier.receiver, outlier.replicate));
    values_.scale(outlier.receiver, outlier.replicate, outlier.factor);
  }

  const LightSheet& sheet_;
  const WindowGrid& grid_;
  Values& values_;
  std::vector<char>& is_judged_;
  std::vector<std::vector<Outlier>> outliers_;  // [cell]
};

}  // namespace

void spread_outliers(const LightSheet& sheet, std::span<const WindowGrid> grids, WindowColumns columns,
                     std::vector<float>& values, const LoopRunner& run) {
  if (grids.empty()) return;
  std::vector<char> is_judged(sheet.size(), 0);
  Values of_sheet(values, columns, run);
  for (const auto& grid : grids) {
    Cells cells(sheet, grid, of_sheet, is_judged);
    run(grid.cells(), [&](std::size_t begin, std::size_t end) {
      for (auto cell = begin; cell < end; ++cell) cells.judge(cell);
    });
    cells.spread();
    if (std::find(is_judged.begin(), is_judged.end(), 0) == is_judged.end()) return;
  }
}

}  // namespace luxel
