// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/surface_measure.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/student.h"
#include "luxel/core/student_quantile.h"

namespace luxel {
namespace {

constexpr double risk_of_intervals = 0.05;
constexpr double unlit_fraction = 1e-4;  // of the mean; patches with less lie under or behind something

MeasuredNumber ratio(const MeasuredNumber& a, const MeasuredNumber& b) {
  if (!(b.value > 0.0)) return {};
  return {a.value / b.value, b.high > 0.0 ? a.low / b.high : 0.0,
          b.low > 0.0 ? std::min(1.0, a.high / b.low) : 1.0};
}

}  // namespace

SurfaceMeter::SurfaceMeter(const PatchSet& patches, const Solution& solution,
                           std::vector<std::vector<float>> replicates)
    : patches_(patches),
      solution_(solution),
      lux_(lux_of_bands(patches)),
      replicates_(std::move(replicates)) {
  const auto values = patches.size() * patches.band_count();
  if (solution.bands != patches.bands || solution.irradiance.front.size() != values ||
      solution.irradiance.back.size() != values)
    throw MismatchError(
        fmt::format("the solution's light is not of these {} patches: solve this scene", patches.size()));
}

SolutionErrors SurfaceMeter::errors_of_means() const {
  if (replicates_.size() >= 2) return SolutionErrors::replicates;
  return has_errors_of_patches() ? SolutionErrors::patches : SolutionErrors::not_stated;
}

double SurfaceMeter::illuminance(std::uint32_t patch, bool back) const {
  double sum = 0.0;
  for (std::size_t b = 0; b < lux_.size(); ++b)
    sum += lux_[b] * static_cast<double>(solution_.irradiance.of(back)[patch * lux_.size() + b]);
  return sum;
}

// All bands have the same rays, so their errors are taken to have the same sign.
double SurfaceMeter::error(std::uint32_t patch, bool back) const {
  if (!has_errors_of_patches()) return 0.0;
  double sum = 0.0;
  for (std::size_t b = 0; b < lux_.size(); ++b)
    sum += lux_[b] * static_cast<double>(solution_.standard_error.of(back)[patch * lux_.size() + b]);
  const auto freedom = solution_.error_degrees_of_freedom;
  return freedom > 0.0 ? sum / student_widening(freedom) : sum;
}

MeasuredNumber SurfaceMeter::mean(std::span<const std::uint32_t> selected, bool back, double risk) const {
  double whole = 0.0, sum = 0.0, bound = 0.0;
  for (const auto p : selected) {
    whole += area(p);
    sum += area(p) * illuminance(p, back);
    bound += area(p) * error(p, back);
  }
  auto freedom = solution_.error_degrees_of_freedom;
  auto spread = bound / whole;
  if (replicates_.size() >= 2) {
    std::vector<double> means;
    for (const auto& of_side : replicates_) {
      double of_replicate = 0.0;
      for (const auto p : selected)
        of_replicate += area(p) * static_cast<double>(of_side[SideId(p, back).index()]);
      means.push_back(of_replicate / whole);
    }
    freedom = static_cast<double>(replicates_.size() - 1);
    spread = error_of_replicates(means) / student_widening(freedom);
  }
  const auto reach = student_quantile(0.5 * risk, freedom) * spread;
  return {sum / whole, std::max(0.0, sum / whole - reach), sum / whole + reach};
}

MeasuredNumber SurfaceMeter::extreme(std::span<const std::uint32_t> selected, bool back, double risk,
                                     double sign, std::uint32_t* where) const {
  const auto freedom = solution_.error_degrees_of_freedom;
  const auto one = student_quantile(0.5 * risk, freedom);
  const auto all = student_quantile(0.5 * risk / static_cast<double>(selected.size()), freedom);
  // As if for the minimum; the maximum is the minimum of the negative.
  auto value = std::numeric_limits<double>::infinity(), outer = value, inner = value;
  for (const auto p : selected) {
    const auto e = sign * illuminance(p, back), s = error(p, back);
    if (e < value && where != nullptr) *where = p;
    value = std::min(value, e);
    outer = std::min(outer, e - one * s);
    inner = std::min(inner, e + all * s);
  }
  const auto low = sign > 0.0 ? outer : -inner, high = sign > 0.0 ? inner : -outer;
  return {sign * value, std::max(0.0, low), high};
}

std::vector<std::uint32_t> SurfaceMeter::lit(std::span<const std::uint32_t> selected, bool back) const {
  double whole = 0.0, sum = 0.0;
  for (const auto p : selected) {
    whole += area(p);
    sum += area(p) * illuminance(p, back);
  }
  std::vector<std::uint32_t> found;
  std::copy_if(selected.begin(), selected.end(), std::back_inserter(found),
               [&](auto p) { return illuminance(p, back) > unlit_fraction * sum / whole; });
  return found.empty() ? std::vector<std::uint32_t>(selected.begin(), selected.end()) : found;
}

SurfaceMeasure SurfaceMeter::measure(std::span<const std::uint32_t> among, SurfaceSide side) const {
  assert(!among.empty());
  SurfaceMeasure m;
  double front = 0.0, back = 0.0;  // lm
  for (const auto p : among) {
    m.unlit += area(p);
    front += area(p) * illuminance(p, false);
    back += area(p) * illuminance(p, true);
  }
  m.back = side == SurfaceSide::back || (side == SurfaceSide::automatic && back > front);
  const auto selected = lit(among, m.back);
  m.patches = selected.size();
  for (const auto p : selected) m.area += area(p);
  m.unlit = selected.size() == among.size() ? 0.0 : m.unlit - m.area;
  const auto all = [&](double risk) {
    m.mean = mean(selected, m.back, risk);
    m.min = extreme(selected, m.back, risk, 1.0, &m.darkest);
    m.max = extreme(selected, m.back, risk, -1.0, &m.brightest);
  };
  all(0.5 * risk_of_intervals);
  m.min_over_mean = ratio(m.min, m.mean);
  m.min_over_max = ratio(m.min, m.max);
  all(risk_of_intervals);
  return m;
}

}  // namespace luxel
