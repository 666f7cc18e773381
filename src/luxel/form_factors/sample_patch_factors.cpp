// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>

#include "luxel/core/memory.h"
#include "luxel/form_factors/patch_rows.h"
#include "luxel/form_factors/sampling.h"

namespace luxel {
namespace {

constexpr std::uint32_t max_rays_possible = 1u
                                            << 21;  // per replicate; the largest number that can be doubled
constexpr std::size_t trial_rows = 256;
constexpr std::size_t rays_per_job = 1u << 22;
// fraction of the target that the trial must reach, since the trial rows are a sample
constexpr double trial_margin = 0.97;

struct Trial {
  double factors_per_row = 0.0;
  double error = 0.0, row_error = 0.0;
};

// Totals over rows; sums of squares as in PatchRows.
Trial errors_of(std::span<const PatchRows> rows) {
  double factors = 0.0, count = 0.0, of_factors = 0.0, of_sinks = 0.0;
  for (const auto& run : rows) {
    factors += static_cast<double>(run.column.size());
    count += static_cast<double>(run.element.size());
    of_factors += run.factor_squared_error;
    of_sinks += run.sink_squared_error;
  }
  if (count == 0.0) return {};
  return {factors / count, factors > 0.0 ? std::sqrt(of_factors / factors) : 0.0,
          std::sqrt((of_factors + of_sinks) / count)};
}

// Computes rows spread over the scene as a trial.
Trial try_rows(const ElementRays& rays, std::uint32_t per_receiver, double min_factor,
               const Context& context) {
  const auto count = std::min(rays.receivers(), trial_rows);
  std::vector<PatchRows> rows(count);
  std::vector<PatchRowScratch> scratch(static_cast<std::size_t>(context.threads()));
  context.for_chunks(count, 1, [&](std::size_t begin, std::size_t end, int thread) {
    for (auto i = begin; i < end; ++i) {
      const auto receiver = i * rays.receivers() / count;
      append_patch_rows(rays, receiver_list(receiver, receiver + 1), per_receiver, min_factor,
                        scratch[static_cast<std::size_t>(thread)], rows[i]);
    }
  });
  return errors_of(rows);
}

bool has_target(const SampleFactorsOptions& options) {
  return options.error > 0.0 || options.row_error > 0.0;
}

// Returns whether this fraction of the error target is reached.
bool is_reached(const Trial& trial, const SampleFactorsOptions& options, double fraction) {
  return has_target(options) && (options.error == 0.0 || trial.error <= fraction * options.error) &&
         (options.row_error == 0.0 || trial.row_error <= fraction * options.row_error);
}

// Computes all rows, in runs of receivers; returns nothing where the monitor stops the work.
std::optional<std::vector<PatchRows>> make_rows(const ElementRays& rays, std::uint32_t per_receiver,
                                                double min_factor, const Context& context) {
  const auto rays_per_receiver = std::size_t{rays.replicates()} * per_receiver;
  const auto positions = std::bit_floor(std::clamp<std::size_t>(rays_per_job / rays_per_receiver, 1, 1024));
  const auto receivers = receiver_list(0, rays.receivers());
  const auto begins = rays.runs(receivers, static_cast<std::uint32_t>(positions));
  const auto runs = begins.size() - 1;
  std::vector<PatchRows> rows(runs);
  std::vector<PatchRowScratch> scratch(static_cast<std::size_t>(context.threads()));
  // Processed in turns; the monitor is polled between them.
  const auto turn = 4 * static_cast<std::size_t>(context.threads());
  for (std::size_t from = 0; from < runs; from += turn) {
    const auto to = std::min(runs, from + turn);
    context.for_chunks(to - from, 1, [&](std::size_t begin, std::size_t end, int thread) {
      for (auto run = from + begin; run < from + end; ++run) {
        append_patch_rows(rays, std::span(receivers).subspan(begins[run], begins[run + 1] - begins[run]),
                          per_receiver, min_factor, scratch[static_cast<std::size_t>(thread)], rows[run]);
        rows[run].column.shrink_to_fit();
        rows[run].hits.shrink_to_fit();
        rows[run].standard_error.shrink_to_fit();
      }
    });
    const auto done = static_cast<double>(begins[to]) / static_cast<double>(rays.receivers());
    if (context.report({"view factors", done, begins[to] * std::uint64_t{rays_per_receiver}}) == Next::stop)
      return {};
  }
  return rows;
}

// Concatenates one array of all runs into rows, and frees the source. make: converts an entry.
template <typename To, typename From, typename Make>
std::vector<To> put_together(std::vector<PatchRows>& rows, std::vector<From> PatchRows::*array,
                             const ViewFactors& factors, const Context& context, Make make) {
  std::vector<To> result(factors.row_begin.back());
  context.for_chunks(rows.size(), 1, [&](std::size_t begin, std::size_t end, int) {
    for (auto& run : std::span(rows).subspan(begin, end - begin)) {
      auto from = (run.*array).begin();
      for (std::size_t i = 0; i < run.element.size(); ++i) {
        const auto to = result.begin() + static_cast<std::ptrdiff_t>(factors.row_begin[run.element[i]]);
        std::transform(from, from + run.length[i], to, make);
        from += run.length[i];
      }
      std::vector<From>().swap(run.*array);  // = {} would not free the memory
    }
  });
  return_freed_memory();
  return result;
}

ViewFactors put_together(std::vector<PatchRows> rows, const ElementRays& rays, double rays_per_row,
                         const Context& context) {
  auto factors = ViewFactors::between(rays.elements().name, rays.elements().area);
  for (const auto& run : rows)
    for (std::size_t i = 0; i < run.element.size(); ++i) {
      const auto element = run.element[i];
      factors.rays[element] = rays_per_row;
      factors.is_known[element] = 1;
      factors.row_begin[element + 1] = run.length[i];
      for (std::size_t k = 0; k < ViewFactors::sinks; ++k) {
        factors.sink[k].factor[element] = run.sink[k][i];
        factors.sink[k].standard_error[element] = run.sink_error[k][i];
      }
    }
  for (std::size_t e = 0; e < factors.size(); ++e) factors.row_begin[e + 1] += factors.row_begin[e];
  return_freed_memory();
  const auto same = [](auto value) { return value; };
  factors.column = put_together<std::uint32_t>(rows, &PatchRows::column, factors, context, same);
  factors.standard_error = put_together<float>(rows, &PatchRows::standard_error, factors, context, same);
  factors.factor = put_together<double>(rows, &PatchRows::hits, factors, context, [&](std::uint32_t hits) {
    return static_cast<double>(hits) / rays_per_row;
  });
  return factors;
}

}  // namespace

std::optional<ViewFactors> sample_patch_factors(const ElementRays& rays, const SampleFactorsOptions& options,
                                                SampleFactorsReport& report, const Context& context) {
  // 1. Estimate the number of rays, and the size of the rows.
  const auto most = max_per_replicate(options);
  auto per_receiver = has_target(options) ? std::min(most, 8u) : most;
  auto trial = try_rows(rays, per_receiver, options.min_factor, context);
  while (has_target(options) && !is_reached(trial, options, trial_margin) && per_receiver < most) {
    if (context.report({"trial rows", 0.0, per_receiver}) == Next::stop) return {};
    trial = try_rows(rays, per_receiver *= 2, options.min_factor, context);
  }

  // 2. Compute all rows. The trial may have underestimated the error by chance: then repeat with twice the
  // rays.
  const auto receivers = static_cast<double>(rays.receivers());
  for (;; per_receiver *= 2) {
    // Pairs found from either side: about as many as one side finds with twice the rays.
    auto with_reverse = trial.factors_per_row;
    if (options.is_enforced && per_receiver < max_rays_possible)
      with_reverse = try_rows(rays, 2 * per_receiver, options.min_factor, context).factors_per_row;
    predict(receivers * trial.factors_per_row, receivers * with_reverse, options, report);
    auto rows = make_rows(rays, per_receiver, options.min_factor, context);
    if (!rows) return {};
    report.rays_per_side = std::uint64_t{rays.replicates()} * per_receiver;
    report.rays += report.rays_per_side * rays.receivers();
    trial = errors_of(*rows);
    report.error = trial.error;
    report.row_error = trial.row_error;
    const bool is_enough = is_reached(trial, options, 1.0);
    if (is_enough || per_receiver >= most) {
      report.stop = is_enough ? StopReason::error_reached : StopReason::ray_limit;
      return put_together(std::move(*rows), rays, static_cast<double>(report.rays_per_side), context);
    }
    trial.factors_per_row *= 2.0;
  }
}

}  // namespace luxel
