// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "luxel/classical/method_options.h"
#include "luxel/core/context.h"
#include "luxel/solve/sampled.h"

namespace luxel {

/// Solution methods; docs/methods.md compares them.
enum class Method { sampled, shooting, dense, hemicube, lines };

/// All methods, the default first.
std::span<const Method> all_methods();
std::string_view name(Method method);         ///< as files, options and JSON spell it
std::string_view description(Method method);  ///< a phrase for people
std::optional<Method> method_named(std::string_view name);
/// Returns whether the radiance of the sky may differ by direction.
bool takes_uneven_sky(Method method);

/// One of the methods, with the options of each.
struct LightOptions {
  Method method = Method::sampled;
  SampledOptions sampled = {};
  StochasticJacobiOptions shooting = {};
  DenseSolveOptions dense = {};
  HemicubeSolveOptions hemicube = {};
  LinesSolveOptions lines = {};
};

/// Solves by the method of the options; its own header describes result and errors. Throws InputError if the
/// method does not support lamps without a surface. hooks: from and keep are for the sampled method only.
SolveReport solve_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const LightOptions& options, const SolveHooks& hooks, const Context& context);

/// Solves from the beginning, without intermediate pictures.
inline SolveReport solve_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                               const LightOptions& options, const Context& context = {}) {
  return solve_light(patches, tracer, solution, options, SolveHooks{}, context);
}

/// Predicted time and memory; empty for sampling and shooting, which end at the given bounds.
///
std::optional<Forecast> forecast_light(const PatchSet& patches, const Tracer& tracer,
                                       const LightOptions& options, const Context& context = {});

/// Returns whether an estimate exceeds an hour, or four fifths of the free memory.
bool is_too_much(const Forecast& forecast);

}  // namespace luxel
