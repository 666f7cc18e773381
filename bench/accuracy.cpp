// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/patch/make_patches.h"
#include "luxel/solution/solution_layout.h"

#include "bench/timing.h"

namespace luxel::bench {
namespace {

// Sums over both sides of every patch and all bands.
struct Comparison {
  double floor = 0.0;                           // W/m²: below, (H - H*) / H* is meaningless
  double square = 0.0, reference_square = 0.0;  // A (H - H*)², A H*²
  double shift = 0.0, reference = 0.0;          // A (H - H*), A H*
  double relative_shift = 0.0, lit_area = 0.0;  // A (H - H*) / H*, A where H* > floor

  void add(const PatchSet& patches, const std::vector<float>& values, const std::vector<float>& truth) {
    const auto bands = patches.band_count();
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double area = patches.area[i / bands];
      const double h = truth[i];
      const double off = values[i] - h;
      square += area * off * off;
      reference_square += area * h * h;
      shift += area * off;
      reference += area * h;
      if (h <= floor) continue;
      relative_shift += area * off / h;
      lit_area += area;
    }
  }
};

// Over the fronts, W/m².
double mean_irradiance(const PatchSet& patches, const std::vector<float>& truth) {
  const auto bands = patches.band_count();
  double power = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    power += static_cast<double>(patches.area[i / bands]) * truth[i];
    area += patches.area[i / bands];
  }
  return power / area;
}

Comparison compare(const PatchSet& patches, const Solution& solution, const Reference& reference) {
  Comparison sums;
  sums.floor = 0.01 * mean_irradiance(patches, reference.front);
  sums.add(patches, solution.irradiance.front, reference.front);
  sums.add(patches, solution.irradiance.back, reference.back);
  return sums;
}

double squared(double x) { return x * x; }

}  // namespace

Stage::Stage(std::string the_name, const Scene& scene, const Context& context)
    : name(std::move(the_name)),
      patches(make_patches(scene, {.max_edge = no_max_edge})),
      tracer(patches, context) {}

Run run(const Stage& stage, const Reference& reference, std::string setting, const Solver& solver) {
  constexpr int most = 4;              // solves that are averaged
  constexpr double long_enough = 0.5;  // s of processor time, all together
  Run result;
  result.setting = std::move(setting);
  double difference = 0.0;
  double predicted = 0.0;
  int count = 0;
  while (count < most && (count == 0 || result.cpu_seconds < long_enough)) {
    ++count;
    Solution solution;
    SolveReport report;
    const auto time = cost([&] { report = solver(solution, static_cast<std::uint64_t>(count)); });
    const auto sums = compare(stage.patches, solution, reference);
    difference += sums.square / sums.reference_square;
    predicted += squared(report.predicted_error);
    result.cpu_seconds += time.cpu;
    result.wall_seconds += time.wall;
    result.rays += report.rays;
    result.bias += sums.relative_shift / sums.lit_area;
    result.power_bias += sums.shift / sums.reference;
    result.stop = report.stop;
  }
  result.cpu_seconds /= count;
  result.wall_seconds /= count;
  result.rays /= static_cast<std::uint64_t>(count);
  result.bias /= count;
  result.power_bias /= count;
  result.difference = std::sqrt(difference / count);
  result.predicted_error = std::sqrt(predicted / count);
  if (squared(reference.error) < 0.8 * squared(result.difference))
    result.true_error = std::sqrt(squared(result.difference) - squared(reference.error));
  return result;
}

std::vector<Run> sampled_runs(const Stage& stage, const Reference& reference, SampledOptions options,
                              const std::vector<double>& errors, double seconds, const Context& context) {
  std::vector<Run> runs;
  for (const auto error : errors) {
    // Without a bound, as users run it: a bound makes for smaller steps. Half the error costs about four
    // times.
    if (!runs.empty() && 4.0 * runs.back().wall_seconds > seconds) break;
    options.error = error;
    options.error_measure = ErrorMeasure::power;
    runs.push_back(run(stage, reference, fmt::format("{:g} % asked for", 100.0 * error),
                       [&](Solution& solution, std::uint64_t seed) {
                         options.seed = seed;
                         return solve_sampled(stage.patches, stage.tracer, solution, options, context);
                       }));
  }
  return runs;
}

std::vector<Run> shooting_runs(const Stage& stage, const Reference& reference,
                               const std::vector<double>& rays_per_patch, const Context& context) {
  // The automatic number has a minimum, which does not matter here.
  constexpr double many = 1e6;
  const auto rays_of_many = static_cast<double>(automatic_rays(stage.patches, many));
  std::vector<Run> runs;
  for (const auto count : rays_per_patch)
    runs.push_back(run(stage, reference, fmt::format("{:g} rays a patch", count),
                       [&](Solution& solution, std::uint64_t seed) {
                         const StochasticJacobiOptions options{
                             .rays = static_cast<std::uint64_t>(rays_of_many * count / many), .seed = seed};
                         return solve_stochastic_jacobi(stage.patches, stage.tracer, solution, options,
                                                        context);
                       }));
  return runs;
}

namespace {

struct Point {
  double error, cpu_seconds, rays;
};

Price price_of(const std::vector<Point>& points, double target) {
  if (points.empty()) return {0.0, 0.0, "unknown"};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto& a = points[i];
    const auto& b = points[i + 1];
    if (a.error <= target || b.error > target) continue;
    const auto t = std::log(a.error / target) / std::log(a.error / b.error);
    const auto at = [t](double x, double y) { return x * std::pow(y / x, t); };
    return {at(a.cpu_seconds, b.cpu_seconds), at(a.rays, b.rays), "interpolated"};
  }
  const auto& first = points.front();
  if (first.error <= target) return {first.cpu_seconds, first.rays, "at most"};
  const auto& last = points.back();
  const auto factor = squared(last.error / target);
  return {last.cpu_seconds * factor, last.rays * factor, "extrapolated"};
}

}  // namespace

Price price_of(const std::vector<Run>& runs, double target) {
  std::vector<Point> points;
  for (const auto& r : runs)
    if (r.true_error) points.push_back({*r.true_error, r.cpu_seconds, static_cast<double>(r.rays)});
  return price_of(points, target);
}

Price predicted_price_of(const std::vector<Run>& runs, double target) {
  std::vector<Point> points;
  for (const auto& r : runs)
    if (r.predicted_error > 0.0)
      points.push_back({r.predicted_error, r.cpu_seconds, static_cast<double>(r.rays)});
  return price_of(points, target);
}

Json to_json(const Run& run) {
  return {{"setting", run.setting},
          {"cpu_seconds", run.cpu_seconds},
          {"wall_seconds", run.wall_seconds},
          {"rays", run.rays},
          {"predicted_error", run.predicted_error},
          {"true_error", run.true_error ? Json(*run.true_error) : Json()},
          {"difference_to_reference", run.difference},
          {"bias", run.bias},
          {"power_bias", run.power_bias},
          {"stop_reason", name(run.stop)}};
}

Json to_json(const Price& price) {
  return {{"cpu_seconds", price.cpu_seconds}, {"rays", price.rays}, {"how", price.how}};
}

}  // namespace luxel::bench
