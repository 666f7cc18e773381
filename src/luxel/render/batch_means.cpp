// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/batch_means.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/student.h"

namespace luxel {
namespace {

constexpr std::uint64_t first_batches = 2;              // minimum for an error estimate
constexpr std::uint64_t judged_batches = 4;             // batches (64 paths) before an error estimate is used
constexpr std::uint64_t paths_between_calls = 1 << 16;  // between polls of the monitor
constexpr std::size_t grain = 4;                        // elements per chunk
constexpr double margin = 1.02;                         // factor for the uncertainty of the error estimate

}  // namespace

StopReason BatchMeans::run(const ReferenceLimits& limits, const Draw& draw, const Error& error,
                           const Context& context, std::string_view stage) {
  if (limits.samples == 0 && !(limits.error > 0.0))
    throw InputError(
        fmt::format("a reference needs a number of samples or an error above 0, not {}", limits.error));
  const auto most = limits.samples > 0
                        ? std::max<std::uint64_t>(2, (limits.samples + batch_paths - 1) / batch_paths)
                        : std::uint64_t{0};
  double reached = 0.0;
  std::uint64_t done = 0;       // batches per element so far
  std::uint64_t needed = most;  // 0: not yet determined
  for (;;) {
    // At most doubled per pass, so that a stopped run covers all elements.
    auto next = std::max(first_batches, 2 * done);
    if (needed > 0) next = std::min(next, std::max(needed, done + 1));
    const auto progress = [&](double fraction) {
      const auto now = static_cast<double>(done) + fraction * static_cast<double>(next - done);
      return Progress{stage, needed > 0 ? std::min(1.0, now / static_cast<double>(needed)) : 0.0, rays_,
                      reached};
    };
    if (!draw_up_to(next, draw, context, progress)) return StopReason::stopped_by_user;
    done = next;
    reached = error(*this);
    if (most > 0) {
      if (done >= most) return StopReason::ray_limit;
      continue;
    }
    if (done < judged_batches) continue;
    if (reached <= limits.error) return StopReason::error_reached;
    const auto ratio = reached / limits.error;
    needed = static_cast<std::uint64_t>(std::ceil(margin * ratio * ratio * static_cast<double>(done)));
  }
}

bool BatchMeans::draw_up_to(std::uint64_t batches, const Draw& draw, const Context& context,
                            const std::function<Progress(double)>& progress) {
  const auto n = elements();
  const auto more = batches - *std::min_element(count_.begin(), count_.end());
  const auto slice = std::max<std::size_t>(grain, paths_between_calls / (batch_paths * more));
  for (std::size_t first = 0; first < n; first += slice) {
    if (context.report(progress(static_cast<double>(first) / static_cast<double>(n))) == Next::stop)
      return false;
    std::atomic<std::uint64_t> rays = 0;
    context.for_chunks(std::min(slice, n - first), grain, [&](std::size_t begin, std::size_t end, int) {
      std::vector<double> sums(values_);
      std::uint64_t traced = 0;
      for (auto e = first + begin; e < first + end; ++e)
        while (count_[e] < batches) {
          std::fill(sums.begin(), sums.end(), 0.0);
          traced += draw(e, count_[e]++, sums);
          // Variance by Welford's method (1962).
          for (std::size_t v = 0; v < values_; ++v) {
            auto& mean = mean_[e * values_ + v];
            const auto value = sums[v] / static_cast<double>(batch_paths);
            const auto change = value - mean;
            mean += change / static_cast<double>(count_[e]);
            square_[e * values_ + v] += change * (value - mean);
          }
        }
      rays += traced;
    });
    rays_ += rays;
  }
  return true;
}

bool BatchMeans::complete() const {
  return std::all_of(count_.begin(), count_.end(), [](std::uint64_t n) { return n >= 2; });
}

double BatchMeans::variance(std::size_t element, std::size_t value) const {
  const auto n = static_cast<double>(count_[element]);
  return count_[element] < 2 ? 0.0 : square_[element * values_ + value] / (n * (n - 1.0));
}

double widening_of(std::uint64_t batches) {
  return batches < 2 ? 1.0 : student_widening(static_cast<double>(batches - 1));
}

}  // namespace luxel
