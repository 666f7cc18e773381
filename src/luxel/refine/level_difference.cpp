// SPDX-License-Identifier: Apache-2.0
#include "luxel/refine/level_difference.h"

#include "luxel/math/barycentric.h"

namespace luxel {
namespace {

// Standard errors in a solution are those of eight replicates, widened as Student's t is; the square of that.
constexpr double widening2 = 1.45;
// Of a patch's variance, what a point of the field drawn over it has: not much is averaged out.
constexpr double field_noise = 0.7;

double variance(const std::vector<float>& error, std::size_t at) {
  if (error.empty()) return 0.0;
  return static_cast<double>(error[at]) * static_cast<double>(error[at]) / widening2;
}

// squared(side, band) and noise(side, band) of each patch, summed.
template <typename Squared, typename Noise>
FieldDifference summed(const PatchSet& patches, const Workers& workers, const Squared& squared,
                       const Noise& noise) {
  constexpr std::size_t chunk = 4096;
  FieldDifference result;
  result.squared.resize(patches.size());
  result.noise.resize(patches.size());
  workers.for_chunks(patches.size(), chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto p = begin; p < end; ++p) {
      double d2 = 0.0;
      double n2 = 0.0;
      for (const bool back : {false, true}) {
        if (back && !patches.material_of(p).two_sided) continue;
        for (std::size_t b = 0; b < patches.band_count(); ++b) {
          d2 += squared(p, back, b);
          n2 += noise(p, back, b);
        }
      }
      const double area = patches.area[p];
      result.noise[p] = area * n2;
      result.squared[p] = area * (d2 - n2);
    }
  });
  return result;
}

const std::vector<float>& irradiance(const Solution& s, bool back) {
  return back ? s.irradiance_back : s.irradiance_front;
}
const std::vector<float>& error(const Solution& s, bool back) {
  return back ? s.standard_error_back : s.standard_error_front;
}

double field_at(const LevelLight& level, std::size_t patch, const Vec3d& weights, bool back,
                std::size_t band) {
  const auto& light = back ? level.smooth.irradiance_back : level.smooth.irradiance_front;
  const auto bands = level.patches.band_count();
  const auto& corners = level.smooth.corners[patch];
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
    sum += weights[k] * static_cast<double>(light[corners[static_cast<std::size_t>(k)] * bands + band]);
  return sum;
}

}  // namespace

FieldDifference difference_of_levels(const LevelLight& coarse, const LevelLight& fine,
                                     std::span<const std::uint32_t> parent, const Workers& workers) {
  const auto bands = fine.patches.band_count();
  return summed(
      fine.patches, workers,
      [&](std::size_t p, bool back, std::size_t b) {
        const auto weights = barycentric(coarse.patches.points(parent[p]), fine.patches.centroid(p));
        const auto d = static_cast<double>(irradiance(fine.solution, back)[p * bands + b]) -
                       field_at(coarse, parent[p], weights, back, b);
        return d * d;
      },
      [&](std::size_t p, bool back, std::size_t b) {
        return variance(error(fine.solution, back), p * bands + b) +
               field_noise * variance(error(coarse.solution, back), parent[p] * bands + b);
      });
}

FieldDifference difference_within_patches(const LevelLight& level, const Workers& workers) {
  const auto bands = level.patches.band_count();
  return summed(
      level.patches, workers,
      [&](std::size_t p, bool back, std::size_t b) {
        const double mean = irradiance(level.solution, back)[p * bands + b];
        double sum = 0.0;
        for (int corner = 0; corner < 3; ++corner) {
          Vec3d weights(0.0);
          weights[corner] = 1.0;
          const auto d = field_at(level, p, weights, back, b) - mean;
          sum += d * d;
        }
        return sum / 12.0;  // the variance of a linear function over a triangle
      },
      [&](std::size_t p, bool back, std::size_t b) {
        return 0.25 * variance(error(level.solution, back), p * bands + b);
      });
}

double squared_light(const PatchSet& patches, const Solution& solution) {
  const auto bands = patches.band_count();
  double sum = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t b = 0; b < bands; ++b)
      for (const auto* light : {&solution.irradiance_front, &solution.irradiance_back}) {
        const double H = (*light)[p * bands + b];
        sum += static_cast<double>(patches.area[p]) * H * H;
      }
  return sum;
}

}  // namespace luxel
