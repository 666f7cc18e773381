// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/year.h"

#include <algorithm>
#include <cmath>

#include "luxel/lighting/hour_products.h"

namespace luxel {
namespace {

constexpr std::size_t hours_per_chunk = 16;

// Coefficients in the mean over the replicates but one.
struct Columns {
  PackedColumns all, reflected;
};

Columns columns_of(const DaylightCoefficients& c, std::uint32_t left_out) {
  const auto width = c.sky.size();
  const auto fraction = 1.0f / static_cast<float>(c.replicates - (left_out < c.replicates ? 1 : 0));
  Columns columns{{width, c.points}, {width, c.points}};
  for (std::size_t i = 0; i < daylight_paths; ++i) {
    const auto path = static_cast<DaylightPath>(i);
    for (std::size_t m = 0; m < c.points; ++m)
      for (std::uint32_t r = 0; r < c.replicates; ++r) {
        if (r == left_out) continue;
        const auto row = c.row(path, m, r);
        for (std::size_t p = 0; p < width; ++p) {
          const auto part = fraction * row[p];
          columns.all.at(p, m) += part;
          if (path != DaylightPath::sky) columns.reflected.at(p, m) += part;
        }
      }
  }
  return columns;
}

}  // namespace

DaylightYear::DaylightYear(const YearCoefficients& coefficients, const YearSkies& skies,
                           std::span<const ProbePoint> points, const SunSurroundings& around,
                           const Context& context)
    : coefficients_(coefficients.open),
      windows_(coefficients.windows),
      context_(context.quiet()),
      skies_(skies),
      sun_(skies.hours.size()),
      sun_light_(skies, points, around, windows_.dark, context) {
  const auto& patches = skies.patches;
  for (std::size_t h = 0; h < hours().size(); ++h) {
    const auto& hour = hours()[h];
    if (!(hour.sun_illuminance > 0.0)) continue;
    for (const auto& [patch, weight] : patches.around(patches.in_scene_axes(hour.sun.direction)))
      if (weight > 0.0)
        sun_[h].push_back(
            {patch, static_cast<float>(weight * hour.sun_illuminance / patches.solid_angle(patch))});
  }
}

std::vector<float> DaylightYear::diffuse_by(const DaylightCoefficients& coefficients,
                                            std::uint32_t left_out) const {
  const auto columns = columns_of(coefficients, left_out);
  const auto count = points();
  auto light = columns.all.times(skies_.luminance, context_);
  context_.for_chunks(hours().size(), hours_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto h = begin; h < end; ++h)
      for (const auto& [patch, luminance] : sun_[h])
        for (std::size_t m = 0; m < count; ++m)
          light[h * count + m] += luminance * columns.reflected.at(patch, m);
  });
  return light;
}

std::vector<float> DaylightYear::diffuse(std::uint32_t left_out) const {
  return diffuse_by(coefficients_, left_out);
}

std::vector<float> DaylightYear::through(std::size_t group, std::vector<float> all,
                                         std::uint32_t left_out) const {
  if (!has_groups()) return all;
  const auto rest = diffuse_by(windows_.without[group], left_out);
  const auto sun = direct_sun(left_out);
  const auto sun_through = sun_light_.without(sun_light_.through(group), replicates(), left_out);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] -= rest[i] + sun[i] - sun_through[i];
  return all;
}

std::vector<float> DaylightYear::illuminance(std::uint32_t left_out) const {
  auto light = diffuse(left_out);
  const auto sun = direct_sun(left_out);
  for (std::size_t i = 0; i < light.size(); ++i) light[i] += sun[i];
  return light;
}

std::vector<float> illuminance_errors(const DaylightYear& year, const std::vector<float>& all) {
  const auto n = static_cast<double>(year.replicates());
  std::vector<double> sum(all.size(), 0.0);
  for (std::uint32_t r = 0; r < year.replicates(); ++r) {
    const auto without = year.illuminance(r);
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += std::pow(static_cast<double>(without[i]) - static_cast<double>(all[i]), 2.0);
  }
  std::vector<float> errors;
  for (const auto s : sum) errors.push_back(static_cast<float>(std::sqrt((n - 1.0) / n * s)));
  return errors;
}

}  // namespace luxel
