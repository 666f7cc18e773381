// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/obstructed_exchange.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "luxel/form_factors/polygon_form_factor.h"
#include "luxel/form_factors/shaft.h"
#include "luxel/form_factors/visible_irradiance.h"
#include "luxel/lamps/polygon_irradiance.h"

namespace luxel {
namespace {

using Triangle = std::array<Vec3d, 3>;

constexpr int first_cuts = 2;   // subdivision levels before any estimate is accepted
constexpr double safety = 2.0;  // factor on the error: a shadow edge can lie between the sample points
constexpr double near_boundary = 0.02;  // relative distance from the boundary, where an occluder may stand
// fraction of a boundary point's visible part that is attributed to the cell
constexpr double boundary_fraction = 0.25;
// fraction of a cell, times its relative width, that an undetected occluder may hide
constexpr double unseen_fraction = 0.25;

// smallest ratio of a quarter's error to that of the whole that is accepted: a smaller one is chance
constexpr double best_progress = 1.0 / 16.0;

// Weights of Radon's seven points (1948): exact to the fifth degree.
struct Orbit {
  double at, weight;
};
constexpr double centre_weight = 0.225;
constexpr std::array<Orbit, 2> orbits = {
    {{0.10128650732345633, 0.12593918054482717}, {0.47014206410511505, 0.13239415278850616}}};

struct Cell {
  Triangle corners;
  double area = 0.0;
  double open = 0.0, seen = 0.0;  // integrals over the cell
  double error = 0.0;
  double unnoticed = 0.0;              // estimate of the contribution that the sample points miss
  std::vector<std::uint32_t> screens;  // that reach into its shaft
};

class Integral {
 public:
  Integral(std::span<const Vec3d> outer, std::span<const Vec3d> inner, std::span<const Triangle> screens,
           double slack)
      : inner_(inner), screens_(screens), slack_(slack), visible_(slack) {
    const auto front = polygon_area_vector(outer);
    whole_ = glm::length(front);
    normal_ = front / whole_;
  }

  Cell make_cell(const Triangle& corners, const Cell* parent) {
    Cell cell;
    cell.corners = corners;
    cell.area = 0.5 * glm::dot(normal_, glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    find_screens(cell, parent);
    evaluate(cell);
    return cell;
  }

  // Selects the integrand: the hidden or the visible part.
  void sum_hidden(bool hidden) { hidden_ = hidden; }
  double term(const Cell& cell) const {
    if (hidden_) return cell.open - cell.seen;
    return cell.screens.empty() ? polygon_exchange_area(cell.corners, inner_) : cell.seen;
  }

  std::array<Cell, 4> cut(const Cell& cell) {
    const auto& t = cell.corners;
    const std::array<Vec3d, 3> m = {0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0]), 0.5 * (t[0] + t[1])};
    std::array<Cell, 4> parts = {make_cell({t[0], m[2], m[1]}, &cell), make_cell({m[2], t[1], m[0]}, &cell),
                                 make_cell({m[1], m[0], t[2]}, &cell), make_cell(m, &cell)};
    double sum = 0.0;
    for (const auto& part : parts) sum += term(part);
    const auto change = std::fabs(sum - term(cell));
    for (auto& part : parts) {
      if (part.screens.empty()) continue;
      part.error = std::max(0.25 * change, best_progress * cell.error);
      part.error = std::max(part.error, part.unnoticed);
    }
    return parts;
  }

 private:
  void find_screens(Cell& cell, const Cell* parent) const {
    const Shaft shaft(cell.corners, inner_, slack_);
    const auto test = [&](std::uint32_t k) {
      if (!shaft.misses(screens_[k])) cell.screens.push_back(k);
    };
    if (parent)
      for (const auto k : parent->screens) test(k);
    else
      for (std::uint32_t k = 0; k < screens_.size(); ++k) test(k);
  }

  void evaluate(Cell& cell) {
    near_.clear();
    for (const auto k : cell.screens) near_.push_back(screens_[k]);
    const auto unit = cell.area / std::numbers::pi;
    const auto add = [&](const Vec3d& x, double weight) {
      const auto [open, seen] = look(x);
      cell.open += weight * unit * open;
      cell.seen += weight * unit * seen;
    };
    const auto& t = cell.corners;
    const auto point = [&](std::size_t k, double at) {
      return (1.0 - 2.0 * at) * t[k] + at * (t[(k + 1) % 3] + t[(k + 2) % 3]);
    };
    add((t[0] + t[1] + t[2]) / 3.0, centre_weight);
    for (const auto& [at, weight] : orbits)
      for (std::size_t k = 0; k < 3; ++k) add(point(k, at), weight);

    // All sample points are lit or all are dark: points on the boundary test whether the whole cell is.
    if (cell.screens.empty() || (cell.seen > 0.0 && cell.seen < cell.open)) return;
    const auto ask = [&](const Vec3d& x) {
      const auto [open, seen] = look(x);
      cell.unnoticed =
          std::max(cell.unnoticed, boundary_fraction * unit * (cell.seen > 0.0 ? open - seen : seen));
    };
    for (std::size_t k = 0; k < 3; ++k) {
      ask(point(k, near_boundary));
      ask(point(k, 0.5 - near_boundary));
    }
    if (cell.seen > 0.0)
      cell.unnoticed = std::max(cell.unnoticed, unseen_fraction * cell.open * std::sqrt(cell.area / whole_));
  }

  struct Look {
    double open, seen;
  };
  Look look(const Vec3d& x) {
    const auto open = std::max(0.0, unit_irradiance(inner_, x, normal_));
    const auto seen = near_.empty() ? open : visible_.at(x, normal_, inner_, near_);
    // Fragments add up to the whole except for rounding: such a difference is neither shadow nor light.
    if (open - seen <= 1e-13) return {open, open};
    return {open, seen <= 1e-13 ? 0.0 : seen};
  }

  std::span<const Vec3d> inner_;
  std::span<const Triangle> screens_;
  double slack_, whole_ = 0.0;
  bool hidden_ = true;
  Vec3d normal_;
  VisibleIrradiance visible_;
  std::vector<Triangle> near_;
};

bool less_wrong(const Cell& a, const Cell& b) { return a.error < b.error; }

}  // namespace

Estimate obstructed_exchange(std::span<const Vec3d> a, std::span<const Vec3d> b,
                             std::span<const Triangle> screens, double open,
                             const ObstructedOptions& options) {
  const bool swap = glm::length(polygon_area_vector(b)) < glm::length(polygon_area_vector(a));
  const auto outer = swap ? b : a;
  Integral integral(outer, swap ? a : b, screens, options.slack);

  std::vector<Cell> cells;  // a heap, the cell of the largest error on top
  for (std::size_t k = 1; k + 1 < outer.size(); ++k)
    cells.push_back(integral.make_cell({outer[0], outer[k], outer[k + 1]}, nullptr));
  for (int level = 0; level < first_cuts; ++level) {
    std::vector<Cell> finer;
    for (const auto& cell : cells)
      for (auto& part : integral.cut(cell)) finer.push_back(std::move(part));
    cells.swap(finer);
  }

  auto open_cells = 0.0, seen_cells = 0.0;
  for (const auto& cell : cells) {
    open_cells += cell.open;
    seen_cells += cell.seen;
  }
  const bool hidden = seen_cells > 0.5 * open_cells;
  integral.sum_hidden(hidden);

  std::make_heap(cells.begin(), cells.end(), less_wrong);
  auto error = 0.0;
  for (const auto& cell : cells) error += cell.error;
  while (safety * error > options.tolerance && cells.size() < options.most) {
    std::pop_heap(cells.begin(), cells.end(), less_wrong);
    const auto worst = std::move(cells.back());
    cells.pop_back();
    error -= worst.error;
    for (auto& part : integral.cut(worst)) {
      error += part.error;
      cells.push_back(std::move(part));
      std::push_heap(cells.begin(), cells.end(), less_wrong);
    }
  }

  Estimate result;
  auto sum = 0.0;
  for (const auto& cell : cells) {
    sum += integral.term(cell);
    result.error += safety * cell.error;
  }
  result.value = std::clamp(hidden ? open - sum : sum, 0.0, open);
  return result;
}

}  // namespace luxel
