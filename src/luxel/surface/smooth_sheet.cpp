// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/smooth_sheet.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "luxel/core/none.h"
#include "luxel/core/warp.h"

namespace luxel {
namespace {

// Weight of the bias in the choice, and the fraction of the variance that is subtracted from it: about the
// bias that noise alone produces where it is above 0. Measured on the Cornell box and the reading room:
// weights of 2 to 8 and fractions of 0 to 0.5 are within 5 % of the best error.
constexpr double bias_weight = 4.0;
constexpr double noise_of_bias = 0.3;
// A window is skipped where the previous scale moved its receivers by less than this in the mean: structure
// that a small window cannot fit a large one cannot fit either.
constexpr float min_moved = 0.1f;
constexpr std::size_t min_judged = 6;  // members; with fewer the previous scale does not count
// Sides of a curved sheet count fully in a window where the cosine to the window's mean normal is above the
// second, and not at all below the first.
constexpr float facing_none = 0.4f;
constexpr float facing_full = 0.8f;
constexpr float min_mean_normal = 0.3f;  // below it a window holds sides of all directions: no fit

// The first scale whose bias is estimated locally. Changes of the finest two carry nearly all the noise of
// single receivers, which hides their bias: with one scale more the stated error of a Cornell box of 53,000
// patches is up to 1.8 times too large. See FineChange.
constexpr std::size_t first_seen_scale = 2;

// Data of one window that are reused when its receivers get their values.
struct Window {
  Vec3 normal{0.0f}, u{1.0f, 0.0f, 0.0f}, v{0.0f, 1.0f, 0.0f};
  std::size_t terms = 0;            // 0: no fit
  std::array<float, 2> fraction{};  // by which each half of the replicates moves
  bool is_judged = true;            // false: too few members to find structure in
};

// Windows of one scale.
class Scale {
 public:
  // number: from 0, the finest.
  Scale(const LightSheet& sheet, const WindowGrid& grid, WindowColumns columns, std::size_t number)
      : sheet_(sheet),
        grid_(grid),
        columns_(columns),
        degree_(number == 0 ? 1 : 2),
        max_terms_(degree_ == 1 ? 3 : WindowFit::max_terms),
        windows_(grid_.nodes()),
        coefficients_(grid_.nodes() * max_terms_ * columns.size()) {}

  // moved: [index], the fraction by which the previous scale moved each receiver; 1 where it was not judged.
  void fit(const std::vector<float>& values, const SmoothingWeights& weights, const std::vector<float>& moved,
           const LoopRunner& run) {
    run(grid_.nodes(), [&](std::size_t begin, std::size_t end) {
      std::vector<WindowMember> members;
      for (auto node = begin; node < end; ++node) {
        collect(node, members);
        if (is_noisy(members, weights.noise) && is_promising(members, moved))
          fit(node, members, values, weights.risk);
      }
    });
  }

  void find_moved(std::vector<float>& moved, const LoopRunner& run) const {
    run(grid_.cells(), [&](std::size_t begin, std::size_t end) {
      for (auto cell = begin; cell < end; ++cell)
        for (const auto index : grid_.in_cell(cell)) {
          moved[index] = 0.0f;
          for (std::size_t corner = 0; corner < grid_.corners(); ++corner) {
            const auto node = grid_.nodes_of_cell(cell)[corner];
            const auto& window = windows_[node];
            const auto fraction = window.is_judged ? 0.5f * (window.fraction[0] + window.fraction[1]) : 1.0f;
            if (fraction > 0.0f) moved[index] += member(node, index).weight * fraction;
          }
        }
    });
  }

  void move(const std::vector<float>& values, std::vector<float>& moved, const LoopRunner& run) const {
    run(grid_.cells(), [&](std::size_t begin, std::size_t end) {
      std::vector<float> difference(columns_.size());
      for (auto cell = begin; cell < end; ++cell)
        for (const auto index : grid_.in_cell(cell)) move(cell, index, values, moved, difference);
    });
  }

  // Adds a field to the bias, smoothed by means over the windows.
  void add_smoothed(const std::vector<float>& added, std::vector<float>& bias, const LoopRunner& run) const {
    const auto bands = columns_.bands;
    std::vector<float> means(grid_.nodes() * bands, 0.0f);
    run(grid_.nodes(), [&](std::size_t begin, std::size_t end) {
      std::vector<WindowMember> members;
      for (auto node = begin; node < end; ++node) {
        if (windows_[node].terms == 0) continue;
        list(node, members);
        float area = 0.0f;
        for (const auto& m : members) {
          area += m.area;
          for (std::size_t b = 0; b < bands; ++b)
            means[node * bands + b] += m.area * added[m.index * bands + b];
        }
        for (std::size_t b = 0; b < bands; ++b) means[node * bands + b] *= area > 0.0f ? 1.0f / area : 0.0f;
      }
    });
    run(grid_.cells(), [&](std::size_t begin, std::size_t end) {
      std::vector<float> of_receiver(bands);
      for (auto cell = begin; cell < end; ++cell)
        for (const auto index : grid_.in_cell(cell)) {
          std::fill(of_receiver.begin(), of_receiver.end(), 0.0f);
          float rest = 1.0f;  // of the partition of unity: windows without a fit
          for_windows(cell, index, [&](std::size_t node, const WindowMember& m) {
            rest -= m.weight;
            for (std::size_t b = 0; b < bands; ++b) of_receiver[b] += m.weight * means[node * bands + b];
          });
          for (std::size_t b = 0; b < bands; ++b)
            bias[index * bands + b] += of_receiver[b] + rest * added[index * bands + b];
        }
    });
  }

 private:
  // A receiver as a member of a window whose axes are set; weight 0: not a member.
  WindowMember member(std::size_t node, std::uint32_t index) const {
    const auto at = grid_.from_node(node, index);
    auto weight = WindowGrid::weight(at);
    const auto& window = windows_[node];
    if (sheet_.is_flat()) return {index, weight, weight * sheet_.area[index], at.x, at.y};
    const auto cosine = glm::dot(sheet_.normal[index], window.normal);
    weight *= std::clamp((cosine - facing_none) / (facing_full - facing_none), 0.0f, 1.0f);
    return {index, weight, weight * sheet_.area[index], glm::dot(at, window.u), glm::dot(at, window.v)};
  }

  void list(std::size_t node, std::vector<WindowMember>& members) const {
    members.clear();
    for (std::size_t corner = 0; corner < grid_.corners(); ++corner) {
      const auto cell = grid_.cells_of_node(node)[corner];
      if (cell == none) continue;
      for (const auto index : grid_.in_cell(cell))
        if (const auto m = member(node, index); m.weight > 0.0f) members.push_back(m);
    }
  }

  // Computes the window's axes and its members.
  void collect(std::size_t node, std::vector<WindowMember>& members) {
    auto& window = windows_[node];
    if (!sheet_.is_flat()) {
      Vec3 normal(0.0f);
      float area = 0.0f;
      for (std::size_t corner = 0; corner < grid_.corners(); ++corner) {
        const auto cell = grid_.cells_of_node(node)[corner];
        if (cell == none) continue;
        for (const auto index : grid_.in_cell(cell)) {
          const auto weight = WindowGrid::weight(grid_.from_node(node, index)) * sheet_.area[index];
          normal += weight * sheet_.normal[index];
          area += weight;
        }
      }
      const auto length = glm::length(normal);
      members.clear();
      if (!(length > min_mean_normal * area)) return;
      const Frame frame(normal / length);
      window.normal = frame.n;
      window.u = frame.s;
      window.v = frame.t;
    }
    list(node, members);
  }

  static bool is_noisy(const std::vector<WindowMember>& members, std::span<const float> noise) {
    float sum = 0.0f;
    for (const auto& m : members) sum += m.area * noise[m.index];
    return sum > 0.0f;
  }

  static bool is_promising(const std::vector<WindowMember>& members, const std::vector<float>& moved) {
    float sum = 0.0f;
    float all = 0.0f;
    for (const auto& m : members) {
      sum += m.area * moved[m.index];
      all += m.area;
    }
    return sum > min_moved * all;
  }

  void fit(std::size_t node, const std::vector<WindowMember>& members, const std::vector<float>& values,
           std::span<const float> risk_weight) {
    auto& window = windows_[node];
    window.is_judged = members.size() >= min_judged;
    if (members.size() < 2) return;
    window.terms = std::min(max_terms_, WindowFit::terms_for(members.size(), degree_));
    auto* coefficients = coefficients_of(node);
    WindowFit::fit(members, window.terms, values.data(), columns_, coefficients);
    const auto risk =
        window_risk(members, window.terms, values.data(), columns_, coefficients, risk_weight.data());
    for (std::size_t half = 0; half < 2; ++half) {
      const auto& chosen_by = risk[1 - half];
      const auto whole = chosen_by.variance +
                         bias_weight * std::max(0.0, chosen_by.bias - noise_of_bias * chosen_by.variance);
      window.fraction[half] =
          whole > 0.0 ? static_cast<float>(std::clamp(-chosen_by.covariance / whole, 0.0, 1.0)) : 0.0f;
    }
    if (window.fraction[0] == 0.0f && window.fraction[1] == 0.0f) window.terms = 0;
  }

  // Calls body(node, member) for the windows with a fit that contain a receiver of a cell.
  template <typename Body>
  void for_windows(std::size_t cell, std::uint32_t index, Body body) const {
    for (std::size_t corner = 0; corner < grid_.corners(); ++corner) {
      const auto node = grid_.nodes_of_cell(cell)[corner];
      if (windows_[node].terms == 0) continue;
      if (const auto m = member(node, index); m.weight > 0.0f) body(node, m);
    }
  }

  void move(std::size_t cell, std::uint32_t index, const std::vector<float>& values,
            std::vector<float>& moved, std::vector<float>& difference) const {
    const auto n = columns_.size();
    const auto half = columns_.replicates / 2 * columns_.stride();
    const auto* value = values.data() + index * n;
    auto* to = moved.data() + index * n;
    std::copy_n(value, n, to);
    for_windows(cell, index, [&](std::size_t node, const WindowMember& m) {
      const auto& window = windows_[node];
      WindowFit::subtract(WindowFit::powers(m), window.terms, coefficients_of(node), value, columns_,
                          difference.data());
      const auto low = m.weight * window.fraction[0];
      const auto high = m.weight * window.fraction[1];
      for (std::size_t c = 0; c < half; ++c) to[c] += low * difference[c];
      for (auto c = half; c < n; ++c) to[c] += high * difference[c];
    });
  }

  const float* coefficients_of(std::size_t node) const {
    return coefficients_.data() + node * max_terms_ * columns_.size();
  }
  float* coefficients_of(std::size_t node) {
    return coefficients_.data() + node * max_terms_ * columns_.size();
  }

  const LightSheet& sheet_;
  const WindowGrid& grid_;
  WindowColumns columns_;
  int degree_;
  std::size_t max_terms_;
  std::vector<Window> windows_;
  std::vector<float> coefficients_;  // [node][term][column]
};

// Sums over two changes a and b of one receiver in one band.
struct ChangeSums {
  float a = 0.0f, b = 0.0f, ab = 0.0f, bb = 0.0f;
};

// Sums over the replicates [from, to) of the changes from `first` to `before` (a) and from there to `now`
// (b).
ChangeSums change_sums(const float* now, const float* before, const float* first, std::size_t stride,
                       std::size_t from, std::size_t to) {
  ChangeSums sums;
  for (auto r = from; r < to; ++r) {
    const auto a = before[r * stride] - first[r * stride];
    const auto b = now[r * stride] - before[r * stride];
    sums.a += a;
    sums.b += b;
    sums.ab += a * b;
    sums.bb += b * b;
  }
  return sums;
}

// Values after the last scale, before it, and before the previous one.
struct LastScales {
  const std::vector<float>&now, &before, &first;
};

// The contribution of the last scale to the squared bias: the square of its change, plus twice the product
// with the change of the previous scale. Products are of different replicates, in which noise cancels: of the
// same half where all are independent, as these were moved by fractions that their own noise did not choose;
// otherwise of different halves. added: [index * bands + band].
void write_added_bias(const LastScales& scales, WindowColumns columns, bool are_independent,
                      std::vector<float>& added, const LoopRunner& run) {
  const auto& now = scales.now;
  const auto& before = scales.before;
  const auto& first = scales.first;
  const auto n = columns.size();
  const auto half = columns.replicates / 2;
  run(now.size() / n, [&](std::size_t begin, std::size_t end) {
    for (auto i = begin; i < end; ++i)
      for (std::size_t b = 0; b < columns.bands; ++b) {
        const auto at = i * n + b;
        const auto sums = [&](std::size_t from, std::size_t to) {
          return change_sums(&now[at], &before[at], &first[at], columns.stride(), from, to);
        };
        const auto low = sums(0, half);
        const auto high = sums(half, columns.replicates);
        auto& to = added[i * columns.bands + b];
        if (are_independent) {
          const auto pairs = [](const ChangeSums& s, std::size_t count) {
            const auto m = static_cast<float>(count);
            return (s.b * s.b - s.bb + 2.0f * (s.a * s.b - s.ab)) / (m * (m - 1.0f));
          };
          to = 0.5f * (pairs(low, half) + pairs(high, columns.replicates - half));
        } else {
          to = (low.b * high.b + low.b * high.a + low.a * high.b) /
               static_cast<float>(half * (columns.replicates - half));
        }
      }
  });
}

// The total change by the finest scales.
void write_fine_change(const std::vector<float>& now, const std::vector<float>& first, WindowColumns columns,
                       FineChange& change, const LoopRunner& run) {
  const auto n = columns.size();
  const auto half = columns.replicates / 2;
  run(now.size() / n, [&](std::size_t begin, std::size_t end) {
    for (auto i = begin; i < end; ++i)
      for (std::size_t b = 0; b < columns.bands; ++b) {
        float product = 0.0f;
        float variance = 0.0f;
        for (const auto& [from, to] :
             {std::pair(std::size_t{0}, half), std::pair(half, columns.replicates)}) {
          const auto at = i * n + b;
          const auto s = change_sums(&now[at], &first[at], &first[at], columns.stride(), from, to);
          const auto m = static_cast<float>(to - from);
          product += 0.5f * (s.b * s.b - s.bb) / (m * (m - 1.0f));
          variance += 0.5f * (s.bb - s.b * s.b / m) / (m * (m - 1.0f));
        }
        change.product[i * columns.bands + b] = product;
        change.variance[i * columns.bands + b] = variance;
      }
  });
}

}  // namespace

void smooth_sheet(const LightSheet& sheet, std::span<const WindowGrid> grids, WindowColumns columns,
                  const SmoothingWeights& weights, const SheetLight& light, const LoopRunner& run) {
  auto& values = light.values;
  auto& squared_bias = light.squared_bias;
  auto* const fine = light.fine;
  assert(columns.replicates >= 4);
  assert(values.size() == sheet.size() * columns.size());
  assert(squared_bias.size() == sheet.size() * columns.bands);
  std::fill(squared_bias.begin(), squared_bias.end(), 0.0f);
  if (fine) {
    fine->product.assign(squared_bias.size(), 0.0f);
    fine->variance.assign(squared_bias.size(), 0.0f);
  }
  if (sheet.size() < min_smoothed_sheet) return;
  auto before = values;
  std::vector<float> moved(values.size());
  std::vector<float> added(squared_bias.size());
  std::vector<float> moved_by(sheet.size(), 1.0f);
  for (std::size_t number = 0; number < grids.size(); ++number) {
    const bool is_last = number + 1 == grids.size();
    Scale scale(sheet, grids[number], columns, number);
    scale.fit(values, weights, moved_by, run);
    scale.move(values, moved, run);
    if (!is_last) scale.find_moved(moved_by, run);
    if (number < first_seen_scale) {
      if (fine && (is_last || number + 1 == first_seen_scale))
        write_fine_change(moved, number > 0 ? before : values, columns, *fine, run);
    } else {
      write_added_bias({moved, values, number > first_seen_scale ? before : values}, columns, fine != nullptr,
                       added, run);
      scale.add_smoothed(added, squared_bias, run);
    }
    before.swap(values);
    values.swap(moved);
  }
}

}  // namespace luxel
