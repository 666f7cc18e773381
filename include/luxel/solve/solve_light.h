// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "luxel/classical/method_options.h"
#include "luxel/core/context.h"
#include "luxel/solve/sampled.h"

namespace luxel {

/// How the light is solved; docs/methods.md compares the methods.
enum class Method { sampled, shooting, dense, hemicube, lines };

/// All methods, the default first.
std::span<const Method> all_methods();
std::string_view name(Method method);         ///< as files, options and JSON spell it
std::string_view description(Method method);  ///< a phrase for people
std::optional<Method> method_named(std::string_view name);

/// One of the methods, with the options of each.
struct LightOptions {
  Method method = Method::sampled;
  SampledOptions sampled = {};
  StochasticJacobiOptions shooting = {};
  DenseSolveOptions dense = {};
  HemicubeSolveOptions hemicube = {};
  LinesSolveOptions lines = {};
};

/// Solves by that method, which describes what it returns and throws. InputError where a lamp has no surface
/// and the method needs one. hooks: from and keep are of the sampled method alone.
SolveReport solve_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const LightOptions& options, const SolveHooks& hooks, const Context& context);

/// The same from nothing, without intermediate pictures.
inline SolveReport solve_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                               const LightOptions& options, const Context& context = {}) {
  return solve_light(patches, tracer, solution, options, SolveHooks{}, context);
}

/// What it is likely to take; nothing where that need not be asked: sampling and shooting end when they are
/// told.
std::optional<Forecast> forecast_light(const PatchSet& patches, const Tracer& tracer,
                                       const LightOptions& options, const Context& context = {});

/// More than an hour, or than four fifths of the memory that is free.
bool is_too_much(const Forecast& forecast);

}  // namespace luxel
