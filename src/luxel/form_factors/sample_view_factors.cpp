// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/sample_view_factors.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/form_factors/sampling.h"

namespace luxel {
namespace {

constexpr std::uint32_t max_rays = 1u << 22;  // per side and replicate

}  // namespace

std::uint32_t max_per_replicate(const SampleFactorsOptions& options) {
  if (options.rays == 0) return max_rays;
  const auto rays = std::max<std::uint64_t>(options.rays / options.replicates, 1);
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(std::bit_floor(rays), max_rays));
}

std::vector<std::uint32_t> receiver_list(std::size_t begin, std::size_t end) {
  std::vector<std::uint32_t> receivers(end - begin);
  std::iota(receivers.begin(), receivers.end(), static_cast<std::uint32_t>(begin));
  return receivers;
}

double bytes_of_factors(double counted, double with_reverse, const SampleFactorsOptions& options) {
  constexpr double made = 20.0, held = 16.0, exchange_area = 20.0;
  // measured: ratio of resident to allocated memory, since the C library does not return all freed memory
  constexpr double kept = 1.1;
  const auto last = (options.is_enforced ? with_reverse : counted) * (held + options.bytes_beside);
  return kept * std::max({made * counted, last,
                          options.is_enforced ? held * counted + exchange_area * with_reverse : 0.0});
}

void predict(double counted, double with_reverse, const SampleFactorsOptions& options,
             SampleFactorsReport& report) {
  const auto bytes = bytes_of_factors(counted, with_reverse, options);
  const auto factors = options.is_enforced ? with_reverse : counted;
  constexpr double mib = 1024.0 * 1024.0;
  if (options.memory > 0 && bytes > static_cast<double>(options.memory))
    throw with_hints(
        InputError(fmt::format(
            "about {:.3g} million factors would be listed and take {:.0f} MiB, where {:.0f} MiB are allowed: "
            "drop "
            "small factors, count fewer rays, take groups or larger patches, or allow more memory",
            1e-6 * factors, bytes / mib, static_cast<double>(options.memory) / mib)),
        {{Setting::min_factor}, {Setting::rays}, {Setting::max_edge}, {Setting::memory}});
  report.predicted_bytes = static_cast<std::uint64_t>(bytes);
  report.predicted_factors = static_cast<std::uint64_t>(factors);
}

std::optional<ViewFactors> sample_view_factors(const PatchSet& patches, const Tracer& tracer,
                                               const ViewElements& elements,
                                               const SampleFactorsOptions& options,
                                               SampleFactorsReport& report, const Context& context) {
  const ElementRays rays(patches, tracer, elements, {options.rows, options.seed, options.replicates},
                         context);
  return elements.kind == Between::patches ? sample_patch_factors(rays, options, report, context)
                                           : sample_group_factors(rays, options, report, context);
}

}  // namespace luxel
