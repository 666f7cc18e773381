// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/obstructed_exchange.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "luxel/form_factors/polygon_form_factor.h"
#include "luxel/form_factors/shaft.h"
#include "luxel/lamps/polygon_irradiance.h"

namespace luxel {
namespace {

using Triangle = std::array<Vec3d, 3>;

constexpr int first_cuts = 1;   // subdivision levels before any estimate is accepted
constexpr double safety = 2.0;  // factor on the error: a shadow edge can lie between the sample points
constexpr double near_boundary = 0.02;  // relative distance from the boundary, where an occluder may stand
// fraction of a boundary point's visible part that is attributed to the cell; less where the sample points
// have noticed the occluder
constexpr double boundary_fraction = 0.25, noticed_boundary_fraction = 0.075;
// fraction of a cell, times its relative width, that an undetected occluder may hide
constexpr double unseen_fraction = 0.25;
// fraction of a cell that the sample points see hidden, or lit, below which they may miss an edge of the
// shadow
constexpr double clear_fraction = 0.02;
// Fraction of the difference of two rules that is attributed to a cell of the first cuts, whose own change
// may be small by chance. These constants were fitted to 1,500 pairs of a room with blocks: at 1e-4 and 1e-5,
// 0 and 0.3 % of the errors exceed what is stated.
constexpr double roughness_fraction = 0.5;

// smallest ratio of a quarter's error to that of the whole that is accepted: a smaller one is chance
constexpr double best_progress = 1.0 / 16.0;

// Weights of Radon's seven points (1948): exact to the fifth degree. difference: weights of two rules of the
// second degree, on the centre and one orbit each, less one another.
struct Orbit {
  double at, weight, difference;
};
constexpr double centre_weight = 0.225, centre_difference = 0.96825;
constexpr std::array<Orbit, 2> orbits = {{{0.10128650732345633, 0.12593918054482717, 0.17195},
                                          {0.47014206410511505, 0.13239415278850616, -0.49470}}};

// Integrals over a cell: of the whole inner polygon as its points would see it, and of the visible part.
struct Light {
  double open = 0.0, seen = 0.0;

  void add(double weight, const Light& other) {
    open += weight * other.open;
    seen += weight * other.seen;
  }
  double hidden() const { return open - seen; }
};

struct Cell {
  Triangle corners;
  double area = 0.0;
  int level = 0;            // how often it was cut
  Light light, difference;  // by the rule; between two rougher ones
  double error = 0.0;
  double unnoticed = 0.0;              // estimate of the contribution that the sample points miss
  std::vector<std::uint32_t> screens;  // that reach into its shaft
  bool is_dark = false;                // one of them hides all of the inner polygon
};

class Integral {
 public:
  Integral(std::span<const Vec3d> outer, std::span<const Vec3d> inner,
           std::span<const OccludingPolygon> screens, double slack)
      : inner_(inner), screens_(screens), slack_(slack), visible_(slack) {
    const auto front = polygon_area_vector(outer);
    whole_ = glm::length(front);
    normal_ = front / whole_;
  }

  Cell make_cell(const Triangle& corners, const Cell* parent) {
    Cell cell;
    cell.corners = corners;
    if (parent) cell.level = parent->level + 1;
    cell.area = 0.5 * glm::dot(normal_, glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    find_screens(cell, parent);
    cell.is_dark = (parent && parent->is_dark) ||
                   std::any_of(cell.screens.begin(), cell.screens.end(), [&](std::uint32_t k) {
                     return hides_all(screens_[k], cell.corners, inner_, slack_);
                   });
    evaluate(cell);
    return cell;
  }

  // Selects the integrand: the hidden or the visible part.
  void sum_hidden(bool hidden) { hidden_ = hidden; }
  double term(const Cell& cell) const {
    if (hidden_) return cell.light.hidden();
    return cell.screens.empty() ? polygon_exchange_area(cell.corners, inner_) : cell.light.seen;
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
      const auto difference = hidden_ ? part.difference.hidden() : part.difference.seen;
      part.error = std::max({0.25 * change, best_progress * cell.error, part.unnoticed});
      if (part.level == first_cuts)
        part.error = std::max(part.error, roughness_fraction * std::fabs(difference));
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
    const auto add = [&](const Vec3d& x, double weight, double difference) {
      const auto light = look(x, cell.is_dark);
      cell.light.add(weight * unit, light);
      cell.difference.add(difference * unit, light);
    };
    const auto& t = cell.corners;
    const auto point = [&](std::size_t k, double at) {
      return (1.0 - 2.0 * at) * t[k] + at * (t[(k + 1) % 3] + t[(k + 2) % 3]);
    };
    add((t[0] + t[1] + t[2]) / 3.0, centre_weight, centre_difference);
    for (const auto& [at, weight, difference] : orbits)
      for (std::size_t k = 0; k < 3; ++k) add(point(k, at), weight, difference);

    // The sample points are nearly fully lit, or nearly fully dark, but the whole cell may not be: points on
    // the boundary test it.
    const auto [open, seen] = cell.light;
    const auto clear = cell.level == first_cuts ? clear_fraction * open : 0.0;
    const bool is_lit = open - seen <= clear, is_dim = seen <= clear;
    if (cell.screens.empty() || cell.is_dark || !(is_lit || is_dim)) return;
    const auto fraction = seen > 0.0 && seen < open ? noticed_boundary_fraction : boundary_fraction;
    const auto test = [&](const Vec3d& x) {
      const auto light = look(x, false);
      cell.unnoticed = std::max(cell.unnoticed, fraction * unit * (is_lit ? light.hidden() : light.seen));
    };
    for (std::size_t k = 0; k < 3; ++k) {
      test(point(k, near_boundary));
      test(point(k, 0.5 - near_boundary));
    }
    if (seen == open)
      cell.unnoticed = std::max(cell.unnoticed, unseen_fraction * open * std::sqrt(cell.area / whole_));
  }

  Light look(const Vec3d& x, bool is_dark) {
    const auto open = std::max(0.0, unit_irradiance(inner_, x, normal_));
    if (is_dark) return {open, 0.0};
    const auto seen = near_.empty() ? open : visible_.at(x, normal_, inner_, near_);
    // Fragments add up to the whole except for rounding: such a difference is neither shadow nor light.
    if (open - seen <= 1e-13) return {open, open};
    return {open, seen <= 1e-13 ? 0.0 : seen};
  }

  std::span<const Vec3d> inner_;
  std::span<const OccludingPolygon> screens_;
  double slack_, whole_ = 0.0;
  bool hidden_ = true;
  Vec3d normal_;
  VisibleIrradiance visible_;
  std::vector<OccludingPolygon> near_;
};

bool less_wrong(const Cell& a, const Cell& b) { return a.error < b.error; }

}  // namespace

Estimate obstructed_exchange(std::span<const Vec3d> a, std::span<const Vec3d> b,
                             std::span<const OccludingPolygon> screens, double open,
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

  Light light;
  for (const auto& cell : cells) light.add(1.0, cell.light);
  const bool hidden = light.seen > 0.5 * light.open;
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
