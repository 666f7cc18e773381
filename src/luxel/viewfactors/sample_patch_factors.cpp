// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>

#include "luxel/viewfactors/patch_rows.h"
#include "luxel/viewfactors/sampling.h"

namespace luxel {
namespace {

constexpr std::size_t trial_rows = 256;
constexpr std::size_t rays_a_job = 1u << 22;
constexpr double trial_margin = 0.97;  // of the error: what the trial rows may be off by

struct Trial {
  double factors_a_row = 0.0;
  double error = 0.0;
};

// Rows spread over the scene, as they would come out.
Trial try_rows(const ElementRays& rays, std::uint32_t per_slot, double keep_above, const Workers& workers) {
  const auto count = std::min(rays.slots(), trial_rows);
  std::vector<PatchRows> rows(count);
  std::vector<PatchRowScratch> scratch(static_cast<std::size_t>(workers.threads()));
  workers.for_chunks(count, 1, [&](std::size_t begin, std::size_t end, int worker) {
    for (auto i = begin; i < end; ++i) {
      const auto slot = i * rays.slots() / count;
      append_patch_rows(rays, slot_list(slot, slot + 1), per_slot, keep_above,
                        scratch[static_cast<std::size_t>(worker)], rows[i]);
    }
  });
  double factors = 0.0, error2 = 0.0;
  for (const auto& row : rows) {
    factors += static_cast<double>(row.column.size());
    error2 += row.error2;
  }
  return {factors / static_cast<double>(count), factors > 0.0 ? std::sqrt(error2 / factors) : 0.0};
}

// All rows, in runs of slots; nothing where the monitor said stop.
std::optional<std::vector<PatchRows>> make_rows(const ElementRays& rays, std::uint32_t per_slot,
                                                double keep_above, const Workers& workers,
                                                const Monitor& monitor) {
  const auto rays_a_slot = std::size_t{rays.replicates()} * per_slot;
  const auto positions = std::bit_floor(std::clamp<std::size_t>(rays_a_job / rays_a_slot, 1, 1024));
  const auto slots = slot_list(0, rays.slots());
  const auto begins = rays.runs(slots, static_cast<std::uint32_t>(positions));
  const auto runs = begins.size() - 1;
  std::vector<PatchRows> rows(runs);
  std::vector<PatchRowScratch> scratch(static_cast<std::size_t>(workers.threads()));
  // In turns, between which the monitor is asked.
  const auto turn = 4 * static_cast<std::size_t>(workers.threads());
  for (std::size_t from = 0; from < runs; from += turn) {
    const auto to = std::min(runs, from + turn);
    workers.for_chunks(to - from, 1, [&](std::size_t begin, std::size_t end, int worker) {
      for (auto run = from + begin; run < from + end; ++run)
        append_patch_rows(rays, std::span(slots).subspan(begins[run], begins[run + 1] - begins[run]),
                          per_slot, keep_above, scratch[static_cast<std::size_t>(worker)], rows[run]);
    });
    const auto done = static_cast<double>(begins[to]) / static_cast<double>(rays.slots());
    if (tell(monitor, {"view factors", done, begins[to] * std::uint64_t{rays_a_slot}}) == Next::stop)
      return {};
  }
  return rows;
}

// Moves one array of all rows to where each row begins, and frees it.
template <typename T>
std::vector<T> put_together(std::vector<PatchRows>& rows, std::vector<T> PatchRows::*array,
                            const ViewFactors& factors) {
  std::vector<T> result(factors.row_begin.back());
  for (auto& run : rows) {
    auto from = (run.*array).begin();
    for (std::size_t i = 0; i < run.element.size(); ++i) {
      std::copy_n(from, run.length[i],
                  result.begin() + static_cast<std::ptrdiff_t>(factors.row_begin[run.element[i]]));
      from += run.length[i];
    }
    run.*array = {};
  }
  return result;
}

ViewFactors put_together(std::vector<PatchRows> rows, const ElementRays& rays, double rays_a_row) {
  auto factors = ViewFactors::between(rays.elements().name, rays.elements().area);
  for (const auto& run : rows)
    for (std::size_t i = 0; i < run.element.size(); ++i) {
      const auto element = run.element[i];
      factors.rays[element] = rays_a_row;
      factors.is_known[element] = 1;
      factors.row_begin[element + 1] = run.length[i];
      for (std::size_t k = 0; k < ViewFactors::sinks; ++k) {
        factors.sink[k].factor[element] = run.sink[k][i];
        factors.sink[k].standard_error[element] = run.sink_error[k][i];
      }
    }
  for (std::size_t e = 0; e < factors.size(); ++e) factors.row_begin[e + 1] += factors.row_begin[e];
  factors.column = put_together(rows, &PatchRows::column, factors);
  factors.factor = put_together(rows, &PatchRows::factor, factors);
  factors.standard_error = put_together(rows, &PatchRows::standard_error, factors);
  return factors;
}

}  // namespace

std::optional<ViewFactors> sample_patch_factors(const ElementRays& rays, const SampleFactorsOptions& options,
                                                const Workers& workers, const Monitor& monitor,
                                                SampleFactorsReport& report) {
  // 1. How many rays are enough, and what the rows will take.
  const auto most = most_per_replicate(options);
  auto per_slot = options.error > 0.0 ? std::min(most, 8u) : most;
  auto trial = try_rows(rays, per_slot, options.keep_above, workers);
  while (options.error > 0.0 && trial.error > trial_margin * options.error && per_slot < most) {
    if (tell(monitor, {"trial rows", 0.0, per_slot}) == Next::stop) return {};
    trial = try_rows(rays, per_slot *= 2, options.keep_above, workers);
  }

  // 2. All rows. The trial's error may have been low by chance: then again with twice the rays.
  for (;; per_slot *= 2) {
    report.predicted_bytes =
        predicted_bytes(trial.factors_a_row * static_cast<double>(rays.slots()), options);
    auto rows = make_rows(rays, per_slot, options.keep_above, workers, monitor);
    if (!rows) return {};
    report.rays_a_side = std::uint64_t{rays.replicates()} * per_slot;
    report.rays += report.rays_a_side * rays.slots();
    double error2 = 0.0;
    std::size_t count = 0;
    for (const auto& run : *rows) {
      error2 += run.error2;
      count += run.column.size();
    }
    report.error = count > 0 ? std::sqrt(error2 / static_cast<double>(count)) : 0.0;
    const bool is_enough = options.error > 0.0 && report.error <= options.error;
    if (is_enough || per_slot >= most) {
      report.stop = is_enough ? StopReason::error_reached : StopReason::ray_limit;
      return put_together(std::move(*rows), rays, static_cast<double>(report.rays_a_side));
    }
    trial.factors_a_row = 2.0 * static_cast<double>(count) / static_cast<double>(rays.slots());
  }
}

}  // namespace luxel
