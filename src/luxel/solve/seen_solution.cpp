// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/seen_solution.h"

#include <span>
#include <vector>

#include "luxel/core/student.h"
#include "luxel/trace/place_views.h"
#include "luxel/trace/seen_error.h"

namespace luxel {

double seen_error_of(const PatchSet& patches, const Tracer& tracer, const Solution& solution,
                     const Workers& workers) {
  if (solution.standard_error_front.empty()) return 0.0;
  const auto views = place_views(patches, tracer, workers).stating;
  if (views.size() == 0) return 0.0;
  const auto widening =
      solution.error_degrees_of_freedom > 0.0 ? student_widening(solution.error_degrees_of_freedom) : 1.0;
  const bool black = reflects_nothing(patches, views);
  const auto bands = patches.band_count();
  SeenLight light{{}, {}, sky_radiance(patches)};
  std::vector<double> squared_error(bands);
  for (const auto side : views.sides) {
    const bool back = side % 2 == 1;
    const auto at = side / 2 * bands;
    const auto& H = back ? solution.irradiance_back : solution.irradiance_front;
    const auto& error = back ? solution.standard_error_back : solution.standard_error_front;
    for (std::size_t b = 0; b < bands; ++b) {
      const auto narrow = static_cast<double>(error[at + b]) / widening;
      squared_error[b] = narrow * narrow;
    }
    const auto seen = light_of_side(patches, side, std::span(H).subspan(at, bands), squared_error, black);
    light.radiance.push_back(seen.radiance);
    light.squared_error.push_back(seen.squared_error);
  }
  return SeenError(views, light).percentile_95();
}

}  // namespace luxel
