// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/exact_view_factors.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/none.h"
#include "luxel/form_factors/form_factor.h"
#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr std::size_t trial_pairs = 400;
constexpr double nothing = 1e-13;  // largest factor that rounding can produce where the exact factor is 0

std::vector<SideId> sides_of(const ViewElements& elements) {
  std::vector<SideId> sides;
  for (std::uint32_t s = 0; s < elements.of_side.size(); ++s)
    if (elements.of_side[s] != none) sides.push_back(SideId::at(s));
  return sides;
}

// Seconds per pair on one thread, measured on pairs spread over the scene.
double seconds_per_pair(const FormFactors& form_factors, const std::vector<SideId>& sides, double tolerance) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  std::size_t pairs = 0;
  for (; pairs < trial_pairs; ++pairs) {
    const auto a = pairs * 7919 % sides.size();
    const auto b = (pairs * 104729 + 1) % sides.size();
    if (a != b) static_cast<void>(form_factors.between(sides[a], sides[b], tolerance));
    if (std::chrono::duration<double>(Clock::now() - begin).count() > 2.0) break;
  }
  return std::chrono::duration<double>(Clock::now() - begin).count() / static_cast<double>(pairs + 1);
}

// Sums over one row of elements: exchange areas and squares of their errors.
struct Row {
  std::vector<double> area, squared_error;  // [element], m² and m⁴
};

}  // namespace

std::optional<ViewFactors> exact_view_factors(const PatchSet& patches, const Tracer& tracer,
                                              const ViewElements& elements,
                                              const ExactFactorsOptions& options, ExactFactorsReport& report,
                                              const Context& context) {
  const auto sides = sides_of(elements);
  const auto n = sides.size();
  report.pairs = std::uint64_t{n} * (n - 1) / 2;
  const FormFactors form_factors(patches, tracer);
  report.predicted_seconds = seconds_per_pair(form_factors, sides, options.tolerance) *
                             static_cast<double>(report.pairs) / context.threads();
  if (options.seconds > 0.0 && report.predicted_seconds > options.seconds)
    throw with_hints(
        InputError(fmt::format(
            "integrating {:.0f} million pairs of patches takes about {:.0f} min on {} threads and "
            "{:.0f} MiB, where {:.0f} min are allowed: larger patches have fewer pairs, and counting rays "
            "takes seconds",
            1e-6 * static_cast<double>(report.pairs), report.predicted_seconds / 60.0, context.threads(),
            28e-6 * static_cast<double>(elements.size() * elements.size()), options.seconds / 60.0)),
        {{Setting::max_edge}, {Setting::force}});

  // Each pair with all later sides, in parallel; summed in order.
  const auto e = elements.size();
  std::vector<std::vector<FormFactor>> rows(n);
  const auto turn = 16 * static_cast<std::size_t>(context.threads());
  std::vector<double> exchange(e * e, 0.0), squared_error(e * e, 0.0);
  std::uint64_t done = 0;
  for (std::size_t from = 0; from < n; from += turn) {
    const auto to = std::min(n, from + turn);
    context.for_chunks(to - from, 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = from + begin; i < from + end; ++i)
        for (auto j = i + 1; j < n; ++j)
          rows[i].push_back(form_factors.between(sides[i], sides[j], options.tolerance));
    });
    for (auto i = from; i < to; ++i) {
      const auto a = elements.of_side[sides[i].index()];
      const auto area = static_cast<double>(patches.area[sides[i].patch()]);
      for (auto j = i + 1; j < n; ++j) {
        const auto b = elements.of_side[sides[j].index()];
        const auto& factor = rows[i][j - i - 1];
        const auto error = area * factor.error;
        // Within one element both directions contribute.
        const auto times = a == b ? 2.0 : 1.0;
        exchange[std::min(a, b) * e + std::max(a, b)] += times * area * factor.value;
        squared_error[std::min(a, b) * e + std::max(a, b)] += times * times * error * error;
      }
      done += n - 1 - i;
      rows[i] = {};
    }
    const auto fraction =
        static_cast<double>(done) / static_cast<double>(std::max<std::uint64_t>(report.pairs, 1));
    if (context.report({"view factors", fraction}) == Next::stop) return {};
  }

  auto factors = ViewFactors::between(elements.name, elements.area);
  for (std::size_t i = 0; i < e; ++i) {
    factors.is_known[i] = 1;
    double sum = 0.0, dropped = 0.0, variance = 0.0;
    for (std::size_t j = 0; j < e; ++j) {
      const auto at = std::min(i, j) * e + std::max(i, j);
      const auto factor = exchange[at] / elements.area[i];
      sum += factor;
      variance += squared_error[at] / (elements.area[i] * elements.area[i]);
      if (factor < nothing) continue;
      if (factor < options.min_factor) {
        dropped += factor;
        continue;
      }
      factors.column.push_back(static_cast<std::uint32_t>(j));
      factors.factor.push_back(factor);
      factors.standard_error.push_back(static_cast<float>(std::sqrt(squared_error[at]) / elements.area[i]));
    }
    factors.row_begin[i + 1] = factors.count();
    factors.sink[ViewFactors::environment].factor[i] = std::max(0.0, 1.0 - sum);
    factors.sink[ViewFactors::environment].standard_error[i] = static_cast<float>(std::sqrt(variance));
    factors.sink[ViewFactors::dropped].factor[i] = dropped;
  }
  return factors;
}

}  // namespace luxel
