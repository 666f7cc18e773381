// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/solve_light.h"

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/memory.h"

namespace luxel {

SolveReport solve_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const LightOptions& options, const Workers& workers, const Monitor& monitor,
                        const SampleStorage& storage) {
  const auto& method = options.method;
  if (!patches.point_lights.empty() && method != LightOptions::by_sampling)
    throw InputError(fmt::format(
        "lamp '{}' has no surface: such lamps are solved by --method sampled alone, and by luxel reference",
        patches.point_lights.front().light.name));
  if (method == LightOptions::by_shooting)
    return solve_stochastic_jacobi(patches, tracer, solution, options.shooting, workers, monitor);
  if (method == LightOptions::by_dense)
    return solve_dense(patches, tracer, solution, options.dense, workers, monitor);
  if (method == LightOptions::by_hemicube)
    return solve_hemicube(patches, solution, options.hemicube, workers, monitor);
  if (method == LightOptions::by_lines)
    return solve_lines(patches, tracer, solution, options.lines, workers, monitor);
  if (method != LightOptions::by_sampling)
    throw InputError(fmt::format(
        "the methods are sampled, shooting, dense, hemicube and lines; there is none named '{}'", method));
  return solve_sampled(patches, tracer, solution, options.sampled, workers, monitor, storage);
}

std::optional<Forecast> forecast_light(const PatchSet& patches, const Tracer& tracer,
                                       const LightOptions& options, const Workers& workers) {
  if (options.method == LightOptions::by_dense)
    return forecast_dense(patches, tracer, options.dense, workers);
  if (options.method == LightOptions::by_hemicube)
    return forecast_hemicube(patches, options.hemicube, workers);
  if (options.method == LightOptions::by_lines)
    return forecast_lines(patches, tracer, options.lines, workers);
  return {};
}

bool is_too_much(const Forecast& forecast) {
  constexpr double max_seconds = 3600.0;
  constexpr double max_memory = 0.8;  // of what is free
  const auto free = free_memory();
  return forecast.seconds > max_seconds ||
         (free > 0 && static_cast<double>(forecast.bytes) > max_memory * static_cast<double>(free));
}

}  // namespace luxel
