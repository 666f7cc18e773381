// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/forecast.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "luxel/classical/direct_solve.h"
#include "luxel/classical/hemicube.h"
#include "luxel/classical/local_lines.h"
#include "luxel/core/address.h"
#include "luxel/form_factors/form_factor.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {
namespace {

constexpr double max_seconds = 0.5;       // limit of the trials' duration
constexpr std::uint64_t min_trials = 30;  // minimum: some pairs take a thousand times as long as others
constexpr double operations_per_second = 1e9;
constexpr double factors_per_second = 3e8;  // multiplied and added in a sweep

std::uint64_t gathering_sides(const PatchSet& patches) {
  std::uint64_t count = patches.size();
  for (std::size_t p = 0; p < patches.size(); ++p) count += patches.material_of(p).two_sided ? 1 : 0;
  return count;
}

// Steps until the unshot light is below the tolerance, in a closed scene of the mean reflectance.
double steps_of(const PatchSet& patches, const JacobiOptions& options) {
  double area = 0.0;
  double reflected = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    auto rho = 0.0f;
    for (std::size_t b = 0; b < patches.band_count(); ++b) rho = std::max(rho, patches.albedo(p, b));
    area += double{patches.area[p]};
    reflected += double{patches.area[p]} * double{rho};
  }
  const auto mean = std::clamp(reflected / area, 0.01, 0.98);
  const auto steps = std::max(1.0, std::ceil(std::log(options.tolerance) / std::log(mean)));
  return options.steps > 0 ? std::min(steps, static_cast<double>(options.steps)) : steps;
}

// Mean time of trial(k), k = 0, 1, 2, ..., up to `most` trials or until the time limit.
double seconds_each(std::uint64_t most, const std::function<void(std::uint64_t)>& trial) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  double seconds = 0.0;
  std::uint64_t done = 0;
  while (done < most && (seconds < max_seconds || done < std::min(most, min_trials))) {
    trial(done++);
    seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }
  return done > 0 ? seconds / static_cast<double>(done) : 0.0;
}

// A random side that gathers light.
SideId some_side(const PatchSet& patches, std::uint64_t trial, std::size_t which) {
  const auto u = uniform4(seed_of(RandomSeed::forecast) + which, trial);
  const auto patch =
      static_cast<std::size_t>(static_cast<double>(u[0]) * static_cast<double>(patches.size()));
  return {patch, patches.material_of(patch).two_sided && u[1] < 0.5f};
}

}  // namespace

Forecast forecast_dense(const PatchSet& patches, const Tracer& tracer, const DenseSolveOptions& options,
                        const Context& context) {
  Forecast forecast;
  forecast.sides = gathering_sides(patches);
  const auto n = static_cast<double>(forecast.sides);
  const FormFactors form_factors(patches, tracer);
  double integrated = 0.0;
  std::uint64_t tried = 0;
  const auto a_pair = seconds_each(2000, [&](std::uint64_t k) {
    const auto factor =
        form_factors.between(some_side(patches, k, 0), some_side(patches, k, 1), options.factors.tolerance);
    integrated += factor.exact ? 0.0 : 1.0;
    ++tried;
  });
  const auto pairs = n * n / 2.0;
  forecast.seconds = pairs * a_pair / context.threads();
  forecast.bytes = 4 * forecast.sides * forecast.sides +
                   static_cast<std::uint64_t>(32.0 * pairs * integrated /
                                              static_cast<double>(std::max<std::uint64_t>(1, tried)));
  if (options.solver == DenseSolver::direct) {
    forecast.bytes += direct_solve_bytes(forecast.sides);
    forecast.seconds += static_cast<double>(patches.band_count()) * n * n * n /
                        (1.5 * operations_per_second * context.threads());
  } else {
    forecast.seconds +=
        steps_of(patches, options.iteration) * n * n / (factors_per_second * context.threads());
  }
  return forecast;
}

Forecast forecast_hemicube(const PatchSet& patches, const HemicubeSolveOptions& options,
                           const Context& context) {
  Forecast forecast;
  forecast.sides = gathering_sides(patches);
  Hemicube hemicube(patches, options.hemicube);
  FormFactorRow row;
  const auto a_row = seconds_each(200, [&](std::uint64_t k) { hemicube.row(some_side(patches, k, 0), row); });
  const auto passes = steps_of(patches, options.iteration) + 1.0;  // and one pass for the losses
  forecast.seconds = passes * static_cast<double>(forecast.sides) * a_row / context.threads();
  const auto pixels = static_cast<std::uint64_t>(options.hemicube.resolution * options.hemicube.resolution);
  forecast.bytes = 24 * pixels * static_cast<std::uint64_t>(context.threads()) +
                   forecast.sides * (8 * (1 + patches.materials.size()) + 24 * patches.band_count());
  return forecast;
}

Forecast forecast_lines(const PatchSet& patches, const Tracer& tracer, const LinesSolveOptions& options,
                        const Context& context) {
  Forecast forecast;
  forecast.sides = gathering_sides(patches);
  LineCounts counts;
  double entries = 0.0;
  std::uint64_t tried = 0;
  const auto a_row = seconds_each(200, [&](std::uint64_t k) {
    count_local_lines(patches, tracer, some_side(patches, k, 0), {options.lines.lines, options.lines.seed},
                      counts);
    entries += static_cast<double>(counts.entries.size());
    ++tried;
  });
  const auto stored =
      static_cast<double>(forecast.sides) * entries / static_cast<double>(std::max<std::uint64_t>(1, tried));
  constexpr double error_sweeps = 80.0;
  forecast.seconds = (static_cast<double>(forecast.sides) * a_row +
                      (steps_of(patches, options.iteration) + error_sweeps) * stored / factors_per_second) /
                     context.threads();
  forecast.bytes = static_cast<std::uint64_t>(8.0 * stored) +
                   forecast.sides * (64 + 8 * (1 + patches.materials.size()) + 60 * patches.band_count());
  return forecast;
}

}  // namespace luxel
