// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/classical/classical.h"
#include "luxel/classical/forecast.h"
#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/solve/sampled.h"

namespace luxel {

// Any of the methods, chosen by name, with the options of each.
struct LightOptions {
  static constexpr const char* by_sampling = "sampled";
  static constexpr const char* by_shooting = "shooting";
  static constexpr const char* by_dense = "dense";
  static constexpr const char* by_hemicube = "hemicube";
  static constexpr const char* by_lines = "lines";
  std::string method = by_sampling;
  SampledOptions sampled = {};
  StochasticJacobiOptions shooting = {};
  DenseSolveOptions dense = {};
  HemicubeSolveOptions hemicube = {};
  LinesSolveOptions lines = {};
};

// Solves by the method that is named; InputError where there is none of that name, and else what each of them
// promises. storage: of the sampled method alone.
SolveReport solve_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const LightOptions& options, const Workers& workers, const Monitor& monitor = {},
                        const SampleStorage& storage = {});

// What it is likely to take; nothing where that need not be asked: sampling and shooting end when they are
// told.
std::optional<Forecast> forecast_light(const PatchSet& patches, const Tracer& tracer,
                                       const LightOptions& options, const Workers& workers);

// More than an hour, or than four fifths of the memory that is free.
bool is_too_much(const Forecast& forecast);

}  // namespace luxel
