// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/refine_progress.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

// Fraction of the refinement's time that the first mesh is expected to take: in twelve scenes 0.26 to 0.59.
constexpr double first_mesh = 0.4;
// The solve that follows, in eleven scenes: its time per ray over that of the first answer, 0.51 to 0.75; and
// its rays over those of the first answer, 0.73 to 1.23 times later_growth * (first error / error
// target)^later_exponent. At least 1, and at most max_growth: a very large error falls much faster.
constexpr double later_time = 0.61, later_growth = 1.5, later_exponent = 1.08, max_growth = 13.5;
constexpr double beyond_budget = 1.2;  // the last round may go beyond it: is_beyond_budget()

}  // namespace

RefineProgress::RefineProgress(double later_error, std::uint64_t later_ray_budget, const Context& context)
    : later_error_(later_error),
      later_ray_budget_(static_cast<double>(later_ray_budget)),
      context_(context) {}

Next RefineProgress::report_first_mesh(double seconds, const Progress& solve, std::uint64_t budget) {
  const auto rays = static_cast<double>(solve.rays);
  note_first_answer(seconds, rays, solve.error);
  const auto by_rays = budget > 0 ? rays / static_cast<double>(budget) : 0.0;
  return report(seconds,
                {"refine", first_mesh * std::clamp(std::max(solve.done, by_rays), 0.0, 1.0), solve.rays});
}

Next RefineProgress::report_later_mesh(double seconds, double part, std::uint64_t rays,
                                       double mesh_error) const {
  return report(seconds, {"refine", first_mesh + (1.0 - first_mesh) * part, rays, mesh_error});
}

void RefineProgress::note_first_answer(double seconds, double rays, double error) {
  if (later_rays_ > 0.0 || later_error_ == 0.0 || patches_ == 0 || !(error > 0.0) || std::isinf(error))
    return;
  const auto above = error / later_error_;
  const auto growth =
      above > 1.0 ? std::min(later_growth * std::pow(above, later_exponent), max_growth) : 1.0;
  later_rays_ = growth * rays / static_cast<double>(patches_);
  later_pace_ = later_time * seconds / rays;
}

Next RefineProgress::report(double seconds, Progress progress) const {
  if (later_error_ == 0.0) return context_.report(progress);
  auto later = later_rays_ * static_cast<double>(patches_);
  if (later_ray_budget_ > 0.0) later = std::min(later, beyond_budget * later_ray_budget_);
  progress.later = later > 0.0 && seconds > 0.0 ? later_pace_ * later / seconds * progress.done : -1.0;
  return context_.report(progress);
}

}  // namespace luxel
