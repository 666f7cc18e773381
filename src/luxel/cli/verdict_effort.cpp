// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/verdict_effort.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/runs/quantity.h"

namespace luxel {
namespace {

// The relative sampling error of points, root mean square: often smaller than was requested, since each point
// has a minimum number of rays.
double reached_error(const std::vector<ProbedLight>& points, double floor) {
  double sum = 0.0;
  for (const auto& light : points) {
    const auto relative = light.sampling_error / std::max(light.illuminance, std::max(floor, 1e-9));
    sum += relative * relative;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace

void VerdictEffort::add(const std::vector<Verdict>& verdicts, const std::vector<ProbedLight>& light) {
  for (const auto& verdict : verdicts) {
    add(verdict);
    // The rays of glare are not those of the points.
    if (!verdict.more_rays || verdict.quantity == "UGR") continue;
    rays_ = std::max(rays_, *verdict.more_rays);
    error_ = std::min(error_, reached_error(light, floor_) / std::sqrt(*verdict.more_rays));
  }
}

void VerdictEffort::add(const Verdict& verdict) {
  factor_ = std::min(factor_, verdict.solution_factor.value_or(1.0));
}

std::vector<std::string> VerdictEffort::sentences(const MeasuredSolution& solution, double seconds) const {
  std::vector<std::string> sentences;
  if (rays_ > 1.0)
    sentences.push_back(fmt::format(
        "some verdicts cannot be told yet: --error {:.2g}% takes about {:.2g} times as long{} and would tell "
        "if "
        "the values stay",
        100.0 * error_, rays_,
        seconds > 0.0 ? fmt::format(" (about {})", rough_duration(rays_ * seconds)) : std::string()));
  if (factor_ < 1.0)
    sentences.push_back(
        solution.seen_error > 0.0
            ? fmt::format("some verdicts need a better solution: luxel {} --error {:.2g}%",
                          solution.can_resume ? "resume " + solution.file : std::string("bake"),
                          100.0 * solution.seen_error * factor_)
            : std::string("some verdicts need a better solution: solve again with a smaller --error"));
  return sentences;
}

}  // namespace luxel
